set title "Stiffness and damping share what a step can bear"
set xlabel "{/:Italic ω h}"
set ylabel "{/:Italic h c}"
set size ratio -1
set xrange [0:2.8]
set yrange [0:2.4]
set xtics 0.5
set ytics 0.5
unset grid
unset key
of(value) = column(3) == value && int(10 * column(1)) % 2 == 0 && int(10 * column(2)) % 2 == 0 ? column(1) : NaN  # every fourth
set label 1 "spring alone" at 1.97, 0.15 left
set label 2 "damper alone" at 0.05, 2.15 left
set label 3 "10 steps per second" at 0.24, 0.35 left
set label 4 "2 steps per second" at 0.87, 1.75 left
plot "bearable.tsv" using (of(1)):2 with points linetype 2 pointtype 2 pointsize 0.5 linewidth 1, \
     "" using (of(0)):2 with points linetype 1 pointtype 7 pointsize 0.35, \
     "bearable_limit.tsv" using 1:2 with lines linetype 7, \
     "bearable_steps.tsv" using 2:3 with linespoints linetype 3 dashtype solid pointtype 7 pointsize 1
