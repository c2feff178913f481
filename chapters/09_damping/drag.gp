@drawing 400,350
set output name.".svg"
set title "Damping stops a ball that air would only slow down"
set xlabel "time (s)"
set ylabel "speed (m/s)"
plot "drag.tsv" using 1:2 with lines linestyle 1 title "  quadratic drag" at end, \
     "drag.tsv" using 1:3 with lines linestyle 2 title "  damping, equal at the start" at end
