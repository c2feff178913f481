set title "Gravity and the tether lend and take back; the drag only takes"
set xlabel "time (s)"
set ylabel "energy (J)"
set rmargin 13
set xrange [0:10]
plot "accounts.tsv" using 1:2 with lines linestyle 3 title "  gravity" at end, \
     "" using 1:3 with lines linestyle 4 title "  tether" at end, \
     "" using 1:4 with lines linestyle 2 title "  drag" at end, \
     "" using 1:5 with lines linestyle 1 title "  the box has" at end
