set title "Every step loses a triangle"
set xlabel "time (s)"
set ylabel "upward velocity (m/s)"
plot "staircase.tsv" using 1:2:3 with filledcurves linetype 3 fillstyle transparent solid 0.35 notitle, \
     "staircase.tsv" using 1:2 with lines linestyle 1 title "  true" at end, \
     "staircase.tsv" using 1:3 with lines linestyle 2 dashtype solid title "  of the steps" at end
