set terminal svg size 480,440 font "sans-serif,15"
set output name.".svg"
set title "Explicit Euler lets the satellite escape"
set xlabel "x (smallest distance = 1)"
set ylabel "y"
set size ratio -1
set xrange [-9:3]
set yrange [-4:4]
set label "" at 0, 0 point linestyle 7 pointtype 7 pointsize 1
plot "exact_orbit.tsv" using 1:2 with lines linestyle 7 title "exact", \
     "orbit.tsv" using 2:3 with lines linestyle 2 title "explicit Euler", \
     "orbit.tsv" using 4:5 with lines linestyle 1 title "kick, then drift"
