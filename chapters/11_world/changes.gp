@drawing 480,440
set output name.".svg"
set title "A change to the scene wakes only the passes that it calls for"
set xlabel "step"
set xrange [0:100]
set yrange [10.5:-1.2]
unset grid
unset ytics
unset key
set border 1
set lmargin 2
set rmargin 18
do for [step in "20 40 60 80"] { set arrow from step, 0.1 to step, 10.5 nohead linetype 7 linewidth 1 }
set label 1 "coin spun" at 20, -0.9 center
set label 2 "a wind" at 40, -0.2 center
set label 3 "thruster off" at 60, -0.9 center
set label 4 "drop removed" at 80, -0.2 center
plot for [n = 1:10] "changes.tsv" using 1:(n + 0.35 - 0.75 * column(n + 1) / 5):(n + 0.35) with filledcurves linecolor rgb "#0b6aa2" fillstyle solid 1 notitle, \
     for [n = 1:10] "" using 1:(n + 0.35) with lines linecolor rgb "#555555" linewidth 0.6 dashtype solid title "  ".columnhead(n + 1) at end
