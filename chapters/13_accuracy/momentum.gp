set title "Rules that carry L along keep it to rounding"
set xlabel "time (s)"
set ylabel "relative error of L in the world"
set logscale y
set format y "10^{%T}"
set termoption enhanced
set yrange [1e-17:10]
set ytics 1e-16, 1e4
set key below left Left reverse samplen 1.5 maxrows 3
plot for [i=2:6] "momentum.tsv" using 1:(column(i) > 1e-16 ? column(i) : 1e-16) with lines linestyle i-1 title columnhead(i)
