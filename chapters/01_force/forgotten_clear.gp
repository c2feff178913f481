@drawing 410,360
set output name.".svg"
set title "Forces that are never cleared pull harder every step"
set xlabel "time (s)"
set ylabel "height (m)"
plot "forgotten_clear.tsv" using 1:2 with lines linestyle 1 title "  cleared once in every step" at end, \
     "forgotten_clear.tsv" using 1:3 with lines linestyle 2 title "  never cleared" at end
