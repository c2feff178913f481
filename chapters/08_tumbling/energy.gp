set title "Only three rules hold the energy of a tumbling handle"
set xlabel "time (s)"
set ylabel "energy, relative to the start"
set yrange [0:2.5]
plot "energy.tsv" using 1:3 with lines linestyle 2 title "explicit", \
     "energy.tsv" using 1:6 with lines linestyle 4 title "momentum-carrying", \
     "energy.tsv" using 1:7 with lines linestyle 1 title "splitting (and steady, and |L| restored)", \
     "energy.tsv" using 1:5 with lines linestyle 3 title "implicit, one Newton step"
