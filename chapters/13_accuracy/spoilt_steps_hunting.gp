@drawing 560,400
set title "With a strong damper, the controller that sees only one error hunts"
set xlabel "attempt"
set ylabel "time step (ms)"
set xrange [100:150]
set yrange [2.4:4.4]
set xtics 10
set rmargin 15
unset key
plot "spoilt_steps_hunting.tsv" using 1:($2 * 1e3) with lines linestyle 2, \
     "" using 1:($3 == 0 ? $2 * 1e3 : NaN) with points pointtype 2 pointsize 0.9 linewidth 2 linecolor rgb "#22303a", \
     "" using 1:($4 * 1e3) with lines linestyle 1, \
     "" using ($1 == 149 ? $1 : NaN):($4 * 1e3):("sees two errors") with labels left offset 0.5,-0.6 textcolor linetype 1, \
     "" using ($1 == 149 ? $1 : NaN):($2 * 1e3):("sees one") with labels left offset 0.5,0.4 textcolor linetype 2
