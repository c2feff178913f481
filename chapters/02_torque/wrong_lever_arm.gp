set title "About the origin, the torque grows with the distance from home"
set xlabel "distance of the crate from the world's origin (m)"
set ylabel "torque (N m)"
plot "wrong_lever_arm.tsv" using 1:2 with lines linestyle 1 title "about the centre of mass", \
     "wrong_lever_arm.tsv" using 1:3 with linespoints linestyle 2 title "about the world's origin", \
     "wrong_lever_arm.tsv" using 1:4 with linespoints linestyle 3 title "about the mesh's origin"
