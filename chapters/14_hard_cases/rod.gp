set title "Only the splittings keep a thin rod's energy"
set xlabel "time (s)"
set ylabel "energy by that at the start"
set yrange [0:2.2]
set key below left Left reverse samplen 1.5 maxrows 2
plot for [i=2:5] "rod.tsv" using 1:i with lines linestyle i title columnhead(i), \
     "" using 1:6 with lines linestyle 1 title columnhead(6)
