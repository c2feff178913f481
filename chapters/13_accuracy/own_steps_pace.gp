set title "With steps that follow the pace symmetrically, the energy is bounded"
set xlabel "steps"
set ylabel "largest relative error of the energy so far"
set logscale y
set format y "10^{%T}"
set termoption enhanced
set yrange [1e-4:1]
set xtics 25000
set key below left Left reverse samplen 1.5 maxrows 1
plot for [i=2:3] "own_steps_pace.tsv" using 1:(column(i)) with lines linestyle i-1 title columnhead(i)
