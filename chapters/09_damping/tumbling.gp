set title "Energy and angular momentum fall; the angular speed may rise"
set xlabel "time (s)"
set ylabel "relative to the start"
plot "tumbling.tsv" using 1:2 with lines linestyle 1 title "angular speed", \
     "tumbling.tsv" using 1:3 with lines linestyle 2 title "energy", \
     "tumbling.tsv" using 1:4 with lines linestyle 3 title "angular momentum"
