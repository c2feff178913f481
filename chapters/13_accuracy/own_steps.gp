set title "The step shortens near the star"
set xlabel "time (s)"
set ylabel "time step (s), distance (m)"
set logscale y
set format y "10^{%T}"
set termoption enhanced
set yrange [1e-4:10]
set key below left Left reverse samplen 1.5
plot "own_steps.tsv" using 1:2 with points linestyle 1 title "time step", \
     "" using 1:3 with lines linestyle 2 title "distance from the star"
