set title "With its gyroscopic motion the handle flips; without, it never does"
set xlabel "time (s)"
set ylabel "rate (rad/s)"
set ytics 5
set yrange [-11:11]
set key below left Left reverse maxrows 3
plot "t_handle.tsv" using 1:3 with lines linestyle 1 title "shaft", \
     "t_handle.tsv" using 1:5 with lines linestyle 7 title "shaft, exact", \
     "t_handle.tsv" using 1:6 with lines linestyle 2 title "shaft, no term", \
     "t_handle.tsv" using 1:2 with lines linestyle 3 title "bar", \
     "t_handle.tsv" using 1:4 with lines linestyle 4 title "third axis"
