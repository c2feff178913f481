set title "In two steps a second the controller throws the satellite to and fro"
set xlabel "time (s)"
set ylabel "angle about z (rad)"
set xrange [0:12]
plot "attitude.tsv" using ($1 == 2 ? $2 : NaN):3 with linespoints linestyle 2 title "2 steps per second", \
     "" using ($1 == 10 ? $2 : NaN):3 with lines linestyle 1 title "10 steps per second"
