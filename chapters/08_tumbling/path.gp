set title "The axis nods as it goes round; a push makes it steady"
set xlabel "direction of the axis (degree)"
set ylabel "tilt (degree)"
set yrange [90:50]
set ytics 10
set xrange [-20:160]
set key below left Left reverse maxrows 2
plot "path.tsv" using 1:2 with lines linestyle 7 title "exact", \
     "path.tsv" using 3:4 with lines linestyle 7 notitle, \
     "path.tsv" using 5:6 with lines linestyle 7 notitle, \
     "path_stepped.tsv" using 1:2 with points linestyle 1 title "let go", \
     "path_stepped.tsv" using 3:4 with points linestyle 2 title "pushed along", \
     "path_stepped.tsv" using 5:6 with points linestyle 3 title "pushed back"
