set title "How far does the ball move in each frame?"
set xlabel "frame"
set ylabel "position (cm)"
set xtics 4
plot "stutter.tsv" using 1:2 with linespoints linestyle 2 title "last state", \
     "stutter.tsv" using 1:3 with linespoints linestyle 1 title "between the last two"
