set title "Only the splitting keeps the energy of a handle that nothing touches"
set xlabel "time (s)"
set ylabel "energy / start"
set yrange [0:2.5]
set label 1 "explicit" at 18.5, 2.3 left textcolor linetype 2
plot "energy.tsv" using 1:3 with lines linestyle 2 notitle, \
     "energy.tsv" using 1:6 with lines linestyle 4 title "  carrying" at end, \
     "energy.tsv" using 1:7 with lines linestyle 1 title "  splitting" at end, \
     "energy.tsv" using 1:5 with lines linestyle 3 title "  implicit" at end
