@drawing 480,370
set output name.".svg"
set title "What the plan leaves out, the exhaustive run does"
unset grid
unset border
unset key
set tics scale 0
set lmargin 19
set rmargin 1
set xrange [0.5:6.5]
set yrange [10.6:-0.2]
set format x ""
set label 1 "by plan too" at 0.6, 10.9 left textcolor linetype 1
set label 2 "exhaustively alone" at 6.4, 10.9 right textcolor linetype 2
plot "members.tsv" using 4:2:(0.42):(0.36):ytic(1) with boxxyerror linecolor rgb "#b9c2c9" linewidth 1 dashtype solid fillstyle empty, \
     "" using ($6 == 1 ? $4 : NaN):2:(0.42):(0.36) with boxxyerror linetype 2 dashtype solid fillstyle solid 0.35 border linetype 2, \
     "" using ($5 == 1 ? $4 : NaN):2:(0.42):(0.36) with boxxyerror linecolor rgb "#0b6aa2" dashtype solid fillstyle solid 1, \
     "" using ($2 == 1 ? $4 : NaN):(0.2):3 with labels center textcolor rgb "#22303a"
