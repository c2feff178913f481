set title "At 1 m/s in float: far away one goes too fast, and further away not at all"
set xlabel "time (s)"
set ylabel "way gone (m)"
set key below left Left reverse samplen 1.5 maxrows 2
plot for [i=2:5] "far_away.tsv" using 1:i with lines linestyle i-1 title columnhead(i)
