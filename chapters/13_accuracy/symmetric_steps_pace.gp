@drawing 565,400
set title "On a symmetric top, steps that follow the pace symmetrically bound the energy"
set xlabel "steps"
set ylabel "largest error of the energy so far"
set logscale y
set format y "10^{%T}"
set xrange [0:100000]
set yrange [1e-4:0.1]
set xtics 50000
set rmargin 21
unset key
plot for [i=2:3] "symmetric_steps_pace.tsv" using 1:(column(i)) with lines linestyle i-1, \
     for [i=2:3] "" using ($1 == 100000 ? 100000 : NaN):(column(i)):(columnhead(i)) with labels left offset 0.5,0 textcolor linetype i-1
