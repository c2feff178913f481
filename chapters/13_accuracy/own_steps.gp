@drawing 540,400
set title "The step shortens near the star"
set xlabel "time (s)"
set ylabel "time step (s), distance (m)"
set logscale y
set format y "10^{%T}"
set yrange [1e-4:10]
unset key
set label 1 "distance from the star" at graph 0.33, first 3.4 center textcolor linetype 2
set label 2 "time step" at graph 0.33, first 0.03 center textcolor linetype 1
plot "own_steps.tsv" using 1:2 with points linestyle 1, \
     "" using 1:3 with lines linestyle 2
