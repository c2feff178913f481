set terminal svg size 480,470 font "sans-serif,15"
set output name.".svg"
set title "Explicit Euler spirals out; kick and drift goes round"
set xlabel "place x (m)"
set ylabel "velocity v (m/s)"
set size ratio -1
set xrange [-2.8:3.2]
set yrange [-3.1:2.5]
set trange [0:2*pi]
set parametric
plot cos(t), sin(t) with lines linestyle 7 title "exact", \
     "phase_portrait.tsv" using 2:3 with linespoints linestyle 2 title "explicit Euler", \
     "phase_portrait.tsv" using 4:5 with linespoints linestyle 1 title "kick, then drift"
