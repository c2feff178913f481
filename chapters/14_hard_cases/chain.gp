set title "One NaN, and half a second later every body is lost"
set xlabel "step"
set ylabel "beads of 40 that are nowhere"
set yrange [-2:42]
plot "chain.tsv" using 1:2 with linespoints linestyle 2 title "naive", \
     "" using 1:3 with lines linestyle 1 title "our world, which stops"
