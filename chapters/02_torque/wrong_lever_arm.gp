@drawing 420,370
set output name.".svg"
set title "Taken about the world's origin, the torque grows with the distance from it"
set xlabel "distance of the crate from the world's origin (m)"
set ylabel "torque (N m)"
set label 1 "about the mesh's origin" at 51.4, 50 left textcolor linetype 3
set label 2 "about the centre of mass" at 51.4, -8 left textcolor linetype 1
plot "wrong_lever_arm.tsv" using 1:2 with lines linestyle 1 notitle, \
     "wrong_lever_arm.tsv" using 1:3 with linespoints linestyle 2 title "  about the world's origin" at end, \
     "wrong_lever_arm.tsv" using 1:4 with linespoints linestyle 3 notitle
