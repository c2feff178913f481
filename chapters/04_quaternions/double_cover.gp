set title "After one turn the arrow is home and the quaternion is not: that takes two"
set xlabel "turned about z (degrees)"
set ylabel "component"
set xtics 90
set xrange [0:720]
set yrange [-1.05:1.05]
plot "double_cover.tsv" using 1:2 with lines linestyle 1 title "the arrow's x", \
     "double_cover.tsv" using 1:3 with lines linestyle 2 title "the quaternion's real part", \
     "double_cover.tsv" using 1:4 with lines linestyle 3 title "its part along k"
