set title "A thrown ball, stepped 10 and 60 times a second"
set xlabel "distance (m)"
set ylabel "height (m)"
set xrange [0:16.5]
set xtics 2
set label 1 "exact parabola" at 11.4, 4.9 left textcolor linetype 7
plot "throw_60.tsv" using 2:4 with lines linestyle 7 notitle, \
     "throw_60.tsv" using 2:3 with lines linestyle 1 title "  60 steps a second" at end, \
     "throw_10.tsv" using 2:3 with linespoints linestyle 2 title "  10 steps a second" at end
