@drawing 480,370
set output name.".svg"
set title "Each part of the step visits only the bodies that it concerns"
unset grid
unset border
unset key
set tics scale 0
set lmargin 19
set rmargin 1
set xrange [0.5:6.5]
set yrange [10.6:-0.2]
set format x ""
set label 1 "filled: visited in each step" at 3.5, 10.9 center textcolor rgb "#555555"
plot "members.tsv" using 4:2:(0.42):(0.36):ytic(1) with boxxyerror linecolor rgb "#b9c2c9" linewidth 1 dashtype solid fillstyle empty, \
     "" using ($5 == 1 ? $4 : NaN):2:(0.42):(0.36) with boxxyerror linecolor rgb "#0b6aa2" dashtype solid fillstyle solid 1, \
     "" using ($2 == 1 ? $4 : NaN):(0.2):3 with labels center textcolor rgb "#22303a"
