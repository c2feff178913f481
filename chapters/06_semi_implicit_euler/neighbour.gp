@drawing 520,420
set output name.".svg"
set title "The steps lie on a curve of their own, where a neighbouring energy is constant"
set xlabel "angle (rad)"
set ylabel "rate (rad/s)"
set size ratio -1
set xrange [-2.4:3.2]
set xtics 1
set yrange [-2.1:2.3]
set ytics 1
# Names stand outside, each with a leader to its curve.
set label 1 "exact" at 2.2, -1.5 left textcolor linetype 7
set arrow 1 from 2.15, -1.4 to 1.4, -1.15 nohead linecolor rgb "#555555"
set label 2 "{/:Italic E} + {/:Italic hFv}/2 constant" at 1.05, 2.05 left textcolor linetype 3
set arrow 2 from 1.5, 1.9 to 1.19, 1.53 nohead linecolor rgb "#555555"
set label 3 "kick, then drift" at 0, 0 center textcolor linetype 1
plot "neighbour_exact.tsv" using 1:2 with lines linestyle 7 notitle, \
     "neighbour_curve.tsv" using 1:2 with lines linestyle 3 dashtype solid notitle, \
     "neighbour.tsv" using 1:2 with points linestyle 1 notitle
