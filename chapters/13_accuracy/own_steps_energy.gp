set title "With steps that are chosen at their start, the energy drifts"
set xlabel "rounds"
set ylabel "relative error of the energy"
set logscale y
set format y "10^{%T}"
set termoption enhanced
set yrange [1e-17:10]
set ytics 1e-16, 1e4
set key below left Left reverse samplen 1.5 maxrows 2
plot for [i=2:5] "own_steps_energy.tsv" using 1:(column(i) > 1e-16 ? column(i) : 1e-16) with lines linestyle i-1 title columnhead(i)
