set title "What becomes of the ellipse?"
set xlabel "x (smallest distance = 1)"
set ylabel "y"
set size ratio -1
set xrange [-9:3]
set yrange [-4:4]
set label "" at 0, 0 point linestyle 7 pointtype 7 pointsize 1
set label 11 "explicit Euler" at -6.4, 3.4 left textcolor linetype 2
set label 12 "kick, then drift" at -3.2, -2.45 left textcolor linetype 1
set label 13 "exact" at 1.2, 1.2 left textcolor linetype 7
plot "exact_orbit.tsv" using 1:2 with lines linestyle 7 notitle, \
     "orbit.tsv" using 2:3 with lines linestyle 2 notitle, \
     "orbit.tsv" using 4:5 with lines linestyle 1 notitle
