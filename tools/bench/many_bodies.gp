set title "The time per body hardly depends on their number until they outgrow a cache"
set terminal svg size 480,620 dynamic font "sans-serif,16" name name noenhanced background rgb "#fffffe"
set output name.".svg"
set xlabel "bodies"
set ylabel "time per body and step (ns)"
set logscale xy
set format x "%.0s%c"
stats "times.tsv" using 1 name "count" nooutput
stats "times.tsv" using 6 name "fastest" nooutput
stats "times.tsv" using 2 name "ours" nooutput
low = fastest_min / 2
high = ours_max * 100
set yrange [low:high]
# Where the arrays of the plain loop no longer fit into a level of the cache.
in_range(bodies) = bodies > count_min && bodies < count_max ? bodies : NaN
grey = "#555555"
plot "times.tsv" using 1:2 with linespoints linetype 1 title "world", \
     "" using 1:3 with linespoints linetype 2 title "world, cheapest rule", \
     "" using 1:4 with linespoints linetype 3 title "loop, splitting", \
     "" using 1:5 with linespoints linetype 4 title "loop, no sine", \
     "" using 1:6 with linespoints linetype 5 title "loop, explicit", \
     "" using 1:8 with linespoints linecolor rgb grey pointtype 4 pointsize 0.5 dashtype solid title "Bullet's functions", \
     "" using 1:9 with linespoints linecolor rgb grey pointtype 8 pointsize 0.5 dashtype (8,4) title "Bullet's world", \
     "" using 1:10 with linespoints linecolor rgb grey pointtype 12 pointsize 0.5 dashtype (2,3) title "ODE", \
     "caches.tsv" using (in_range($3)):(low):(0):(high - low) with vectors nohead linecolor rgb grey linewidth 1 dashtype (2,4) notitle, \
     "" using (in_range($3)):(high):(sprintf(" L%d", $1)) with labels left offset 0,-0.6 textcolor rgb grey notitle
