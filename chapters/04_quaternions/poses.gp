@drawing 620,245
set output name.".svg"
set title "Two quarter turns in the other order leave the book elsewhere"
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.6:15.2]
set yrange [-2.6:2]
set margins 0, 0, 0, 2
of(kind) = strcol(1) eq kind ? column(2) : (strcol(1) eq "gap" ? NaN : NaN)
set label 1 "as it lies" at 0, -2 center textcolor linetype 7
set label 2 "turned about {/:Italic x}" at 3.4, -2 center textcolor linetype 7
set label 3 "then about {/:Italic z}" at 6.8, -2 center textcolor linetype 1
set label 4 "turned about {/:Italic z}" at 10.2, -2 center textcolor linetype 7
set label 5 "then about {/:Italic x}" at 13.6, -2 center textcolor linetype 2
set arrow 1 from 8.5,-2.2 to 8.5,1.8 nohead linecolor rgb "#b9c2c9"
plot for [n=0:4] "poses.tsv" using (of(sprintf("page %d", n))):3 with filledcurves closed fillstyle solid 0.12 border linetype 7 dashtype solid linetype 7, \
     for [n=0:4] "poses.tsv" using (of(sprintf("spine %d", n))):3 with filledcurves closed fillstyle solid 0.75 border linetype 6 dashtype solid linetype 6, \
     for [n=0:4] "poses.tsv" using (of(sprintf("cover %d", n))):3 with filledcurves closed fillstyle solid 0.5 border linetype 1 dashtype solid linetype 1, \
     "poses.tsv" using (of("head")):3:4:5 with vectors head filled linetype 2 dashtype solid linewidth 1.6
