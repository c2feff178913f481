@drawing 420,370
set output name.".svg"
set title "Taken about the world's origin, the torque grows with the distance from it"
set xlabel "distance of the crate from the world's origin (m)"
set ylabel "torque (N m)"
stats "wrong_lever_arm.tsv" using 4 name "mesh" nooutput
stats "wrong_lever_arm.tsv" using 2 name "centre" nooutput
set label 1 sprintf("the mesh's origin: %.0f N m", mesh_mean) at 51.4, 50 left textcolor linetype 3
set label 2 sprintf("the centre of mass: %.0f N m", centre_mean) at 51.4, -8 left textcolor linetype 1
plot "wrong_lever_arm.tsv" using 1:2 with lines linestyle 1 notitle, \
     "wrong_lever_arm.tsv" using 1:3 with linespoints linestyle 2 title "  about the world's origin" at end, \
     "wrong_lever_arm.tsv" using 1:4 with linespoints linestyle 3 notitle
