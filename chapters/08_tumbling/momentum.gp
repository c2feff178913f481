set title "Without torque the angular momentum must not turn"
set xlabel "time (s)"
set ylabel "angle of L from its start (degree)"
set yrange [0:6]
plot "momentum.tsv" using 1:4 with lines linestyle 2 title "explicit, |L| restored", \
     "momentum.tsv" using 1:5 with lines linestyle 3 title "implicit, one Newton step", \
     "momentum.tsv" using 1:2 with lines linestyle 5 title "steady: no gyroscopic term", \
     "momentum.tsv" using 1:7 with lines linestyle 1 title "splitting and momentum-carrying"
