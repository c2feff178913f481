@drawing 600,270
set output name.".svg"
set title "A triangle that faces the origin takes its tetrahedron away"
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-0.3:5.9]
set yrange [-0.85:1.5]
set margins 0, 0, 0, 2
of(kind) = strcol(1) eq kind ? column(2) : NaN
set label 1 "far side: added" at 1.3, -0.65 center textcolor linetype 3
set label 2 "near side: taken away" at 4.6, -0.65 center textcolor linetype 2
set label 3 "origin" at -0.05, -0.2 left textcolor linetype 7
plot "signed.tsv" using (of("added")):3 with filledcurves closed fillstyle transparent solid 0.3 border linetype 3 dashtype solid linetype 3, \
     "signed.tsv" using (of("taken")):3 with filledcurves closed fillstyle transparent solid 0.3 border linetype 2 dashtype solid linetype 2, \
     "signed.tsv" using (strcol(1) eq "edge" || strcol(1) eq "gap" ? column(2) : NaN):3 with lines linetype 7 dashtype solid linewidth 1.2, \
     "signed.tsv" using (of("origin")):3 with points linetype 7 pointtype 7 pointsize 0.9
