set title "Half the angle, a quarter of the error: three turns miss by second order"
set xlabel "angle of the whole turn (rad)"
set ylabel "error (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set termoption enhanced
plot "three_turns.tsv" using 1:3 with lines linestyle 7 title "half of the cross products: slope 2", \
     "three_turns.tsv" using 1:2 with linespoints linestyle 1 title "x, y, z one after another, against one turn"
