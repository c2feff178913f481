set title "With the cap the world slows down; without it, it stands still and leaps"
set xlabel "time on the wall (s)"
set ylabel "simulated time (s)"
set xrange [0:10]
set yrange [0:10]
plot x with lines linestyle 7 title "real time", \
     "spiral_uncapped.tsv" using 1:3 with lines linestyle 2 title "no cap", \
     "spiral_capped.tsv" using 1:3 with lines linestyle 1 title "at most 4 steps a frame"
