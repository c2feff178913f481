set title "Halve the step: one rule gains nothing, four halve their error, two quarter it"
set xlabel "time step (s)"
set ylabel "angle error (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xrange [2e-4:0.1]
set yrange [1e-8:10]
set ytics 100
set label 1 "steady" at 0.08, 60 left textcolor linetype 5
set label 2 "implicit" at 0.08, 1.7 left textcolor linetype 3
set label 7 "○ explicit" at 0.08, 10 left textcolor linetype 3
set label 3 "carrying" at 0.08, 0.29 left textcolor linetype 4
set label 4 "|{/:Italic L}| restored" at 0.08, 0.05 left textcolor linetype 2
set label 5 "by axes" at 0.08, 0.0085 left textcolor linetype 6
set label 6 "with a sphere" at 0.08, 0.0015 left textcolor linetype 1
plot "order.tsv" using 1:2 with linespoints linestyle 5 notitle, \
     "order.tsv" using 1:6 with linespoints linestyle 4 notitle, \
     "order.tsv" using 1:5 with linespoints linestyle 3 notitle, \
     "order.tsv" using 1:3 with points linetype 3 pointtype 6 pointsize 1.3 notitle, \
     "order.tsv" using 1:4 with linespoints linestyle 2 notitle, \
     "order.tsv" using 1:7 with linespoints linestyle 6 notitle, \
     "order.tsv" using 1:8 with linespoints linestyle 1 notitle
