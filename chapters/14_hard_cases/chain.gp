set title "One NaN goes from bead to bead until all of them are lost"
set xlabel "step"
set ylabel "beads of 40 that are nowhere"
set yrange [-2:42]
set label 1 "naive" at 18.5, 24 right textcolor linetype 2
set label 2 "our world, which stops" at 16, 2.5 left textcolor linetype 1
plot "chain.tsv" using 1:2 with linespoints linestyle 2 notitle, \
     "" using 1:3 with lines linestyle 1 notitle
