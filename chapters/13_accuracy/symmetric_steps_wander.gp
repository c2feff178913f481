@drawing 565,400
set title "Without a mirror plane, only steps of one length keep the energy"
set xlabel "steps"
set ylabel "relative error of the energy, in 1/1000"
set xrange [0:1000000]
set xtics 500000
set format x "%.0f"
set rmargin 21
unset key
plot for [i=2:4] "symmetric_steps_wander.tsv" using 1:(1000 * column(i)) with lines linestyle i-1, \
     for [i=2:4] "" using ($1 == 1000000 ? 1000000 : NaN):(1000 * column(i)):(columnhead(i)) with labels left offset 0.5,0 textcolor linetype i-1
