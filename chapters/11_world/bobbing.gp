set title "A ball shoots out of the water and comes to rest on it"
set xlabel "time (s)"
set ylabel "height of its centre (m)"
set label 1 "ball" at 1.2, 2.3 left textcolor linetype 1
set label 2 "surface" at 7, -0.2 left textcolor linetype 7
plot "bobbing.tsv" using 1:2 with lines linestyle 1 notitle, \
     0 with lines linestyle 7 notitle
