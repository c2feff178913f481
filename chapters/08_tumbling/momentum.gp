set title "Without torque the angular momentum must not turn"
set xlabel "time (s)"
set ylabel "turn of L (degree)"
set yrange [0:4]
set ytics 1
set key below left Left reverse maxrows 2
plot "momentum.tsv" using 1:4 with lines linestyle 2 linewidth 1.3 title "|L| restored", \
     "momentum.tsv" using 1:5 with lines linestyle 3 title "implicit", \
     "momentum.tsv" using 1:2 with lines linestyle 5 title "steady", \
     "momentum.tsv" using 1:7 with lines linestyle 1 title "splitting"
