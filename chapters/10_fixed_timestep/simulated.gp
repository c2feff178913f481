@drawing 480,360
set output name.".svg"
set title "With the cap the game stays behind; without it, it catches up by leaps"
set xlabel "wall-clock time (s)"
set ylabel "behind by (s)"
set xrange [0:10]
set yrange [0:1.3]
set rmargin 14
set label 1 "no cap" at 4.5, 0.55 left textcolor linetype 2
plot "spiral_uncapped.tsv" using 1:($1 - $3) with lines linestyle 2 notitle, \
     "spiral_capped.tsv" using 1:($1 - $3) with lines linestyle 1 title "  at most 4 steps" at end
