set title "Two stable steps, taken in turn, explode"
set xlabel "time (s)"
set ylabel "|x| (m)"
set logscale y
set yrange [0.005:200]
plot "variable_step.tsv" using 1:4 with linespoints linestyle 2 title "  1/30 s and 1/60 s in turn" at end, \
     "variable_step.tsv" using 1:3 with linespoints linestyle 3 title "  all 1/30 s" at end, \
     "variable_step.tsv" using 1:2 with linespoints linestyle 1 title "  all 1/60 s" at end
