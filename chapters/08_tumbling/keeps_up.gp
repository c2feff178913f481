@drawing 540,420
set title "Splitting nods as the exact top does; the steady rule barely nods; the rest sink or reel"
set xlabel "time (s)"
set ylabel "tilt (degree)"
set xrange [0:1]
set yrange [180:0]
set ytics 30
set rmargin 11
unset key
set label 1 "explicit" at 0.2, 15 left textcolor linetype 2
set label 2 "steady" at 0.98, 50 right textcolor linetype 5
set label 3 "with a sphere, and exact" at 0.62, 82 left textcolor linetype 1
set label 4 "implicit" at 0.62, 135 right textcolor linetype 3
set label 5 "carrying" at 1.01, 67 left textcolor linetype 4
plot "keeps_up.tsv" using 1:4 with lines linestyle 2 linewidth 1.2, \
     "keeps_up.tsv" using 1:6 with lines linestyle 3, \
     "keeps_up.tsv" using 1:7 with lines linestyle 4, \
     "keeps_up.tsv" using 1:3 with lines linestyle 5, \
     "keeps_up.tsv" using 1:9 with lines linestyle 1, \
     "keeps_up.tsv" using 1:2 with lines linestyle 7
