set title "Summed time drifts, in float most of all; counted steps err by rounding alone"
set xlabel "time (s)"
set ylabel "clock is off by (s)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xrange [1:4e6]
set yrange [1e-17:1e7]
set label 1 "{/:Italic nh}; no dot: exact" at graph 1.01, first 5e-11 left textcolor linetype 1
plot "clocks.tsv" using 1:2 with lines linestyle 2 title "  float t += h" at end, \
     "clocks.tsv" using 1:3 with lines linestyle 3 title "  double t += h" at end, \
     "clocks.tsv" using 1:4 with points linestyle 1 notitle
