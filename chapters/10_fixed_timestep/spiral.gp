set title "Without a cap, long frames make longer ones"
set xlabel "wall-clock time (s)"
set ylabel "duration of a frame (ms)"
set logscale y
set yrange [10:5000]
set xrange [0:10]
set label 1 "no cap" at 2.9, 2000 left textcolor linetype 2
set label 2 "at most 4 steps a frame" at 5.1, 150 left textcolor linetype 1
plot "spiral_uncapped.tsv" using 1:2 with lines linestyle 2 notitle, \
     "spiral_capped.tsv" using 1:2 with lines linestyle 1 notitle
