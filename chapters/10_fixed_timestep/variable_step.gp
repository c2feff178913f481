set title "Two stable steps, taken in turn, explode"
set xlabel "time (s)"
set ylabel "|{/:Italic x}| (m)"
set logscale y
set xrange [0:0.6]
set label 1 "  all 1/30 s" at 0.6, 1.6 left textcolor linetype 3
set label 2 "  all 1/60 s" at 0.6, 0.75 left textcolor linetype 1
set label 3 "1/30 s and 1/60 s in turn" at 0.3, 40 left textcolor linetype 2
set yrange [0.005:200]
of(run) = strcol(1) eq run ? column(2) : NaN
plot "variable_step.tsv" using (of("in turn")):3 with linespoints linestyle 2 notitle, \
     "variable_step.tsv" using (of("1/30 s")):3 with linespoints linestyle 3 notitle, \
     "variable_step.tsv" using (of("1/60 s")):3 with linespoints linestyle 1 notitle
