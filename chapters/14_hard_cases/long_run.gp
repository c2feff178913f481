set title "Only the phase is lost"
set xlabel "time (s)"
set ylabel "off by (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set termoption enhanced
set yrange [1e-15:10]
set ytics 1e-15, 1e5
set key below left Left reverse samplen 1.5 maxrows 2
plot for [i=2:5] "long_run.tsv" using 1:i with lines linestyle i-1 title columnhead(i)
