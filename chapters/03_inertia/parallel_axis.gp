set title "No parallel axis is easier to turn about than the one through the centre of mass"
set xlabel "where the axis crosses the rod, from its centre (m)"
set ylabel "moment of inertia (kg m²)"
set yrange [0:*]
set xrange [-1.6:1.6]
set arrow from -1,graph 0 to -1,graph 1 nohead linestyle 7 linewidth 1
set arrow from 1,graph 0 to 1,graph 1 nohead linestyle 7 linewidth 1
unset key
set label 1 "the theorem" at 0, 5.6 center textcolor linetype 1
set label 2 "sums over 200 particles" at 0, 4.7 center textcolor linetype 2
set label "end" at -1.04,graph 0.94 right textcolor rgb "#22303a"
set label "end" at 1.04,graph 0.94 left textcolor rgb "#22303a"
plot "parallel_axis.tsv" using 1:2 with lines linestyle 1, \
     "parallel_axis.tsv" using 1:3 with points linestyle 2
