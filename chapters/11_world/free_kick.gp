set title "A spin of six turns a second bends a free kick by metres"
set xlabel "towards the goal (m)"
set ylabel "to the left (m)"
plot "free_kick.tsv" using 1:2 with lines linestyle 1 title "with spin", \
     "free_kick.tsv" using 3:4 with lines linestyle 2 title "without"
