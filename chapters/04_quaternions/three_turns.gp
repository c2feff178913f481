set title "How wrong are three turns in a row?"
set xlabel "angle of the whole turn (rad)"
set ylabel "error (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set termoption enhanced
set xrange [5e-4:2]
plot "three_turns.tsv" using 1:3 with lines linestyle 7 title "half of the cross products: slope 2", \
     "three_turns.tsv" using 1:2 with points linestyle 1 pointsize 0.8 title "three turns, measured"
