set title "Halve the step: one rule learns nothing, four halve their error, two quarter it"
set xlabel "time step (s)"
set ylabel "angle error (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set termoption enhanced
set xrange [2e-4:0.1]
set yrange [1e-8:10]
set ytics 100
set key below left Left reverse maxrows 3
plot "order.tsv" using 1:2 with linespoints linestyle 5 title "steady", \
     "order.tsv" using 1:6 with linespoints linestyle 4 title "carrying", \
     "order.tsv" using 1:5 with linespoints linestyle 3 title "implicit", \
     "order.tsv" using 1:4 with linespoints linestyle 2 title "|L| restored", \
     "order.tsv" using 1:7 with linespoints linestyle 6 title "by axes", \
     "order.tsv" using 1:8 with linespoints linestyle 1 title "with a sphere"
