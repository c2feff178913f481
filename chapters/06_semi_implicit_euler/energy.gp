set title "One order gains energy for ever, the other swings about it"
set xlabel "swings"
set ylabel "energy (J)"
set logscale y
set yrange [0.3:15]
set ytics (0.5, 1, 2, 5, 10)
plot "energy.tsv" using 1:4 with lines linestyle 7 title "exact", \
     "energy.tsv" using 1:2 with lines linestyle 2 title "explicit Euler", \
     "energy.tsv" using 1:3 with lines linestyle 1 title "kick, then drift"
