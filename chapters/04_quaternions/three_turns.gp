set title "The error of three turns in a row grows with the square of the angle"
set xlabel "angle of the whole turn (rad)"
set ylabel "error (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xrange [5e-4:2]
unset key
set label 1 "three turns" at 0.05, 1e-2 right textcolor linetype 1
set label 2 "half of the cross products:\nslope 2" at 0.02, 8e-6 textcolor linetype 7
plot "three_turns.tsv" using 1:3 with lines linestyle 7, \
     "three_turns.tsv" using 1:2 with points linestyle 1 pointsize 0.8
