@drawing 430,390
set output name.".svg"
set title "With the cap the game falls behind evenly; without it, it leaps"
set xlabel "wall-clock time (s)"
set ylabel "simulated time (s)"
set xrange [0:10]
set yrange [0:10]
set label 1 "real time" at 10.2, 10.7 left textcolor linetype 7
set label 2 "no cap" at 10.2, 9.9 left textcolor linetype 2
plot x with lines linestyle 7 notitle, \
     "spiral_uncapped.tsv" using 1:3 with lines linestyle 2 notitle, \
     "spiral_capped.tsv" using 1:3 with lines linestyle 1 title "  at most 4 steps a frame" at end
