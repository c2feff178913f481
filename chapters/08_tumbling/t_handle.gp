set title "With its gyroscopic motion the handle flips; without, it never does"
set xlabel "time (s)"
set ylabel "angular velocity in the body (rad/s)"
plot "t_handle.tsv" using 1:5 with lines linestyle 7 title "exact, about the shaft", \
     "t_handle.tsv" using 1:3 with lines linestyle 1 title "about the shaft", \
     "t_handle.tsv" using 1:2 with lines linestyle 3 title "about the bar", \
     "t_handle.tsv" using 1:4 with lines linestyle 4 title "about the third axis", \
     "t_handle.tsv" using 1:6 with lines linestyle 2 title "about the shaft, without the term"
