@drawing 480,250
set output name.".svg"
set title "A spin of six turns a second bends a free kick past the wall into the goal"
set xlabel "towards the goal (m)"
set ylabel "to the left (m)"
unset key
unset grid
set size ratio -1
set lmargin 7
set rmargin 5
set tmargin 2.5
set bmargin 3.2
set xrange [-0.6:25]
set yrange [-2:8.4]
set ytics 2
# The goal, 7.32 m wide, and the wall, 9.15 m from the ball: four players, half a metre each.
set arrow 1 from 24.1, 0.4 to 24.1, 7.72 nohead linecolor rgb "#22303a" linewidth 4
set label 1 "goal" at 24.6, 4.06 left textcolor rgb "#22303a"
do for [n = 0:3] { set object n + 1 circle at 9.15, 0.95 + 0.5 * n size 0.24 fillstyle solid 1 fillcolor rgb "#555555" }
set label 2 "wall" at 9.15, 3.4 center textcolor rgb "#22303a"
set object 5 circle at 0, 0 size 0.25 fillstyle solid 1 fillcolor rgb "#22303a"
set label 3 "with spin" at 19, 3.6 right textcolor linetype 1
set label 4 "without" at 11, -1.1 left textcolor linetype 2
plot "free_kick.tsv" using 1:2 with lines linestyle 1, \
     "free_kick.tsv" using 3:4 with lines linestyle 2
