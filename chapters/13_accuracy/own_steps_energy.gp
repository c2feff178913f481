set title "Steps chosen at their start spoil the energy; in transformed time it is kept"
set xlabel "rounds"
set ylabel "relative error of the energy"
set logscale y
set yrange [1e-16:1]
set format y "10^{%T}"
plot 'own_steps_energy.tsv' using 1:(abs($2)+1e-16) with lines title 'one length', \
     '' using 1:(abs($3)+1e-16) with lines title 'chosen at the start', \
     '' using 1:(abs($4)+1e-16) with lines title 'pair 5(4)', \
     '' using 1:(abs($5)+1e-16) with lines title 'transformed time'
