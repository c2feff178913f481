set title "What the wheel gains, the telescope gains with the opposite sign"
set xlabel "time (s)"
set ylabel "momentum (N m s)"
set xrange [0:40]
set yrange [-13:13]
unset key
set label 1 "telescope: the area is {/:Italic I} times the angle" at 20, 11.3 center textcolor linetype 1
set label 2 "wheel" at 20, -11.3 center textcolor linetype 2
plot "wheel.tsv" using 1:2 with filledcurves y=0 linestyle 1 fillstyle transparent solid 0.15, \
     "" using 1:2 with lines linestyle 1, \
     "" using 1:3 with lines linestyle 2, \
     0 with lines linestyle 7
