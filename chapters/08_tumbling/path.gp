@drawing 520,420
set title "The axis nods as it goes round; a push makes it steady"
set xlabel "direction of the axis (degree)"
set ylabel "tilt (degree)"
set yrange [90:50]
set ytics 10
set xrange [-20:160]
unset key
set label 1 "pushed along" at 70, 56 center textcolor linetype 2
set label 2 "let go" at 85.5, 63.8 center textcolor linetype 1
set label 3 "pushed back" at 86, 83.5 center textcolor linetype 3
set label 4 "dots: stepped; lines: exact" at 155, 87 right textcolor linetype 7
plot "path.tsv" using 1:2 with lines linestyle 7, \
     "path.tsv" using 3:4 with lines linestyle 7, \
     "path.tsv" using 5:6 with lines linestyle 7, \
     "path_stepped.tsv" using 1:2 with points linestyle 1, \
     "path_stepped.tsv" using 3:4 with points linestyle 2, \
     "path_stepped.tsv" using 5:6 with points linestyle 3
