set title "Most nets bear little more than the limit; some held by arms bear far more"
set xlabel "step, in units of the limit"
set ylabel "nets that bear it (%)"
set logscale y
set xrange [1:8.2]
set yrange [0.1:100]
unset key
set label 1 "held within" at 2.55, 0.3 left textcolor linetype 1
set label 2 "by arms" at 3.2, 8 left textcolor linetype 2
of(kind) = strcol(1) eq kind ? column(2) : NaN
plot "careful.tsv" using (of("within")):3 with lines linestyle 1, \
     "careful.tsv" using (of("by_arms")):3 with lines linestyle 2
