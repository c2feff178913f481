set title "With two steps a second the controller throws the satellite to and fro"
set xlabel "time (s)"
set ylabel "angle about {/:Italic z} (rad)"
set label 1 "2 a second" at 11, 0.22 right textcolor linetype 2
set label 2 "10 a second" at 12.2, 0 left textcolor linetype 1
set xrange [0:12]
plot "attitude.tsv" using ($1 == 2 ? $2 : NaN):3 with linespoints linestyle 2 notitle, \
     "" using ($1 == 10 ? $2 : NaN):3 with lines linestyle 1 notitle
