set title "No axis is easier than the one through the centre of mass"
set xlabel "where the axis crosses the rod, from its centre (m)"
set ylabel "moment of inertia (kg m²)"
set yrange [0:*]
set xrange [-1.6:1.6]
set arrow from -1,graph 0 to -1,graph 1 nohead linestyle 7 linewidth 1
set arrow from 1,graph 0 to 1,graph 1 nohead linestyle 7 linewidth 1
set label "end" at -1.04,graph 0.94 right textcolor rgb "#22303a"
set label "end" at 1.04,graph 0.94 left textcolor rgb "#22303a"
plot "parallel_axis.tsv" using 1:2 with lines linestyle 1 title "parallel axis theorem", \
     "parallel_axis.tsv" using 1:3 with points linestyle 2 title "200 particles, summed about that point"
