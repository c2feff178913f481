set title "Two rules keep the top up as it is; one keeps it up and turns it too slowly"
set xlabel "time (s)"
set ylabel "tilt (degree)"
set xrange [0:1]
set yrange [180:0]
set ytics 30
set key below left Left reverse maxrows 3
plot "keeps_up.tsv" using 1:4 with lines linestyle 2 linewidth 1.2 title "explicit", \
     "keeps_up.tsv" using 1:6 with lines linestyle 3 title "implicit", \
     "keeps_up.tsv" using 1:7 with lines linestyle 4 title "carrying", \
     "keeps_up.tsv" using 1:3 with lines linestyle 5 title "steady", \
     "keeps_up.tsv" using 1:9 with lines linestyle 1 title "with a sphere", \
     "keeps_up.tsv" using 1:2 with lines linestyle 7 title "exact"
