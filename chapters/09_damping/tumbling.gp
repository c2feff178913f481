set title "Damping takes energy all the time, yet at first the body spins faster"
set xlabel "time (s)"
set ylabel "relative to the start"
plot "tumbling.tsv" using 1:2 with lines linestyle 1 title "  angular speed" at end, \
     "tumbling.tsv" using 1:3 with lines linestyle 2 title "  energy" at end, \
     "tumbling.tsv" using 1:4 with lines linestyle 3 title "  angular momentum" at end
