set title "Every step loses a triangle"
set xlabel "time (s)"
set ylabel "upward velocity (m/s)"
set label 1 "true velocity" at 0.85, 4.2 left textcolor linetype 1
set label 2 "velocity of the steps" at 0.04, -5 left textcolor linetype 2
plot "staircase.tsv" using 1:2:3 with filledcurves linetype 3 fillstyle transparent solid 0.35 notitle, \
     "staircase.tsv" using 1:2 with lines linestyle 1 notitle, \
     "staircase.tsv" using 1:3 with lines linestyle 2 dashtype solid notitle
