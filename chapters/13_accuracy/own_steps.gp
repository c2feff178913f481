set title "The step shortens where the planet is near the star"
set xlabel "time (s)"
set ylabel "time step (s)"
set y2label "distance from the star (m)"
set y2tics
set ytics nomirror
set logscale y
plot 'own_steps.tsv' using 1:2 with linespoints title 'time step', \
     '' using 1:3 axes x1y2 with lines title 'distance'
