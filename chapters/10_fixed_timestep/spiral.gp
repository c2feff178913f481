set title "Without a cap each frame makes the next one longer"
set xlabel "time on the wall (s)"
set ylabel "duration of a frame (ms)"
set logscale y
set yrange [10:5000]
set xrange [0:10]
plot "spiral_uncapped.tsv" using 1:2 with lines linestyle 2 title "no cap", \
     "spiral_capped.tsv" using 1:2 with lines linestyle 1 title "at most 4 steps a frame"
