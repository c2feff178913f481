@drawing 480,430
set output name.".svg"
set title "The first-order rule leaves the circle, and falls short"
set xlabel "real part, cos of half the angle"
set ylabel "part along {/:Italic ω}, sin of half the angle"
unset key
set size ratio -1
set xrange [0:1.55]
set yrange [0:1.2]
of(kind) = strcol(1) eq kind ? column(2) : NaN
plot "off_the_circle.tsv" using (of("circle")):3 with lines linetype 7 dashtype solid, \
     "off_the_circle.tsv" using (of("back")):3:4:5 with vectors nohead linetype 7, \
     "off_the_circle.tsv" using (of("arc")):3 with lines linetype 1 linewidth 3, \
     "off_the_circle.tsv" using (of("step")):3:4:5 with vectors head size 0.05,20 filled linetype 2 dashtype solid linewidth 3, \
     "off_the_circle.tsv" using (of("exponential")):3 with points linetype 1 pointtype 7 pointsize 1.2, \
     "off_the_circle.tsv" using (of("first")):3 with points linetype 2 pointtype 5 pointsize 1.2, \
     "off_the_circle.tsv" using (of("exponential") - 0.06):($3 - 0.05):6 with labels right textcolor linetype 1, \
     "off_the_circle.tsv" using (of("first") - 0.09):($3 - 0.03):6 with labels right textcolor linetype 2, \
     "off_the_circle.tsv" using (of("sum name") + 0.05):3:("1 + {/:Italic hω}/2") with labels left textcolor linetype 2
