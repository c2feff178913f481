set title "Explicit Euler gains energy; kick, then drift stays in a band"
set xlabel "swings"
set ylabel "energy (J)"
set logscale y
set yrange [0.3:15]
set ytics (0.5, 1, 2, 5, 10)
set label 1 "  exact" at 5, 0.385 left textcolor linetype 7
plot "energy.tsv" using 1:4 with lines linestyle 7 notitle, \
     "energy.tsv" using 1:2 with lines linestyle 2 title "  explicit Euler" at end, \
     "energy.tsv" using 1:3 with lines linestyle 1 title "  kick, then drift" at end
