set title "Above one spin the top sleeps; below it, it falls and rises again"
set xlabel "spin (rad/s)"
set ylabel "largest tilt (degree)"
set yrange [-5:185]
set ytics 30
set key below left Left reverse
plot "sleeping.tsv" using 1:3 with lines linestyle 7 title "exact", \
     "sleeping.tsv" using 1:2 with points linestyle 1 title "stepped, nudged"
