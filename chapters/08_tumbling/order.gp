@drawing 480,440
set output name.".svg"
set title "Halve the step: one rule gains nothing, four halve their error, two quarter it"
set xlabel "time step (s)"
set ylabel "angle error (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xrange [2e-4:0.1]
set yrange [1e-8:40]
set ytics 100
set label 1 "steady" at 3e-4, 20 left textcolor linetype 5
set label 2 "implicit, ○ explicit" at 0.09, 2 left textcolor linetype 3
set label 3 "carrying" at 2.8e-4, 0.5 left textcolor linetype 4
set label 4 "|{/:Italic L}| restored" at 0.09, 0.15 left textcolor linetype 2
set label 5 "by axes" at 0.09, 0.01 left textcolor linetype 6
set label 6 "with a sphere" at 0.09, 0.0012 left textcolor linetype 1
plot "order.tsv" using 1:2 with linespoints linestyle 5 notitle, \
     "order.tsv" using 1:6 with linespoints linestyle 4 notitle, \
     "order.tsv" using 1:5 with linespoints linestyle 3 notitle, \
     "order.tsv" using 1:3 with points linetype 3 pointtype 6 pointsize 1.3 notitle, \
     "order.tsv" using 1:4 with linespoints linestyle 2 notitle, \
     "order.tsv" using 1:7 with linespoints linestyle 6 notitle, \
     "order.tsv" using 1:8 with linespoints linestyle 1 notitle
