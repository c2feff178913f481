set title "Above one spin the top sleeps; below it, it falls and rises again"
set xlabel "spin (rad/s)"
set ylabel "largest tilt (degree)"
set yrange [-5:185]
set ytics 30
unset key
set label 1 "line: exact" at 100, 130 left textcolor linetype 7
set label 2 "dots: stepped" at 100, 112 left textcolor linetype 1
plot "sleeping.tsv" using 1:3 with lines linestyle 7, \
     "sleeping.tsv" using 1:2 with points linestyle 1
