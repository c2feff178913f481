set title "In float, a body at 1 m/s is too fast far from the origin, and further out stands still"
set xlabel "time (s)"
set ylabel "way gone (m)"
set key below left Left reverse samplen 1.5 maxrows 2
plot for [i=2:5] "far_away.tsv" using 1:i with lines linestyle i-1 title columnhead(i)
