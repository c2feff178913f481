set title "The coarser the step, the lower the ball: by g h t / 2"
set xlabel "distance (m)"
set ylabel "height (m)"
plot "throw_60.tsv" using 2:4 with lines linestyle 7 title "exact parabola", \
     "throw_60.tsv" using 2:3 with lines linestyle 1 title "60 steps a second", \
     "throw_10.tsv" using 2:3 with linespoints linestyle 2 title "10 steps a second"
