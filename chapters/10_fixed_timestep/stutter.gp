set title "Drawn at its last state the ball stutters; drawn between two it glides"
set xlabel "frame"
set ylabel "position (cm)"
set xtics 4
set label 1 "A: last state" at 11.4, 30 right textcolor linetype 2
set label 2 "B: between the last two" at 11.6, 14 left textcolor linetype 1
plot "stutter.tsv" using 1:2 with linespoints linestyle 2 notitle, \
     "stutter.tsv" using 1:3 with linespoints linestyle 1 notitle
