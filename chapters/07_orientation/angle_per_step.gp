set title "The first-order rule turns by less than half a turn, however much is asked for"
set xlabel "asked for: {/:Italic ωh} (rad)"
set ylabel "turned in one step (rad)"
set xrange [0:6.2]
set yrange [0:6.2]
plot "angle_per_step.tsv" using 1:4 with lines linestyle 7 title "  half a turn" at end, \
     "angle_per_step.tsv" using 1:3 with lines linestyle 1 title "  exponential" at end, \
     "angle_per_step.tsv" using 1:2 with lines linestyle 2 title "  first order" at end
