set title "A needle's energy: wrong by a hundredfold, by hundredths, or by millionths"
set xlabel "time (s)"
set ylabel "relative error of the energy"
set logscale y
set format y "10^{%T}"
set termoption enhanced
set yrange [1e-8:1e4]
set ytics 1e-8, 1e2
set key below left Left reverse samplen 1.5 maxrows 2
off(x) = abs(x - 1) > 1e-8 ? abs(x - 1) : 1e-8
plot for [i=2:5] "needle.tsv" using 1:(off(column(i))) with lines linestyle i title columnhead(i), \
     "" using 1:(off($6)) with lines linestyle 1 title columnhead(6)
