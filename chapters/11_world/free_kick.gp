set title "A spin of six turns a second bends a free kick by metres"
set xlabel "towards the goal (m)"
set ylabel "to the left (m)"
set xrange [0:25]
set yrange [-0.5:3.5]
set label 1 "with spin" at 17, 2.2 right textcolor linetype 1
set label 2 "without" at 17, 0.3 right textcolor linetype 2
plot "free_kick.tsv" using 1:2 with lines linestyle 1 notitle, \
     "free_kick.tsv" using 3:4 with lines linestyle 2 notitle
