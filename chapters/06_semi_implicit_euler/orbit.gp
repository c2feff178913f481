@drawing 520,420
set output name.".svg"
set title "Explicit Euler leaves the ellipse; kick, then drift slowly turns it"
set xlabel "{/:Italic x} (smallest distance = 1)"
set ylabel "{/:Italic y}"
set size ratio -1
set xrange [-8.5:3]
set yrange [-4.2:4.2]
set label "" at 0, 0 point linestyle 7 pointtype 7 pointsize 1
# Names stand beside the curves, each with a leader.
set label 11 "explicit Euler" at -7.9, 3.6 left textcolor linetype 2
set arrow 11 from -6.6, 3.3 to -5.9, 2.75 nohead linecolor rgb "#555555"
set label 12 "kick, then drift" at -3.6, -3.6 left textcolor linetype 1
set arrow 12 from -2.5, -3.25 to -2.05, -1.7 nohead linecolor rgb "#555555"
set label 13 "exact" at -2.1, -0.2 left textcolor linetype 7
set arrow 13 from -2.1, -0.4 to -2.66, -0.94 nohead linecolor rgb "#555555"
plot "exact_orbit.tsv" using 1:2 with lines linestyle 7 notitle, \
     "orbit.tsv" using 2:3 with lines linestyle 2 notitle, \
     "orbit.tsv" using 4:5 with lines linestyle 1 notitle
