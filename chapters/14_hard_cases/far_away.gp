@drawing 560,400
set title "In float, a body at 1 m/s is too fast far from the origin, and further out stands still"
set xlabel "time (s)"
set ylabel "distance moved (m)"
set xrange [0:2]
set xtics 0.5
set rmargin 17
unset key
plot for [i=2:5] "far_away.tsv" using 1:i with lines linestyle i-1, \
     for [i=2:3] "" using ($1 == 2 ? 2 : NaN):(column(i)):(columnhead(i)) with labels left offset 0.5,0 textcolor linetype i-1, \
     "" using ($1 == 2 ? 2 : NaN):4:("900, 1200 km") with labels left offset 0.5,0.2 textcolor linetype 4
