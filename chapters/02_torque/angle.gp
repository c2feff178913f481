set title "How does the torque depend on the direction of the push?"
set xlabel "angle between door and push (degrees)"
set ylabel "torque about the hinge (N m)"
set xtics 30
plot "angle.tsv" using 1:2 with lines linestyle 1 title "torque", \
     "angle.tsv" using 1:3 with points linestyle 2 title "force times distance of its line"
