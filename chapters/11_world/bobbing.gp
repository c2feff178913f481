set title "A ball shoots out of the water and comes to rest on it"
set xlabel "time (s)"
set ylabel "height of its centre (m)"
plot "bobbing.tsv" using 1:2 with lines linestyle 1 title "ball", \
     0 with lines linestyle 7 title "surface"
