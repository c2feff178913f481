@drawing 545,470
set title "The time per body hardly depends on how many there are, until they outgrow a cache"
set xlabel "bodies"
set ylabel "time per body and step (ns)"
set logscale xy
set format x "%.0s%c"
set ytics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
unset key
grey = "#555555"
# The columns: bodies, two worlds, three loops, columns apart, two of Bullet, ODE. What was not measured is empty.
known(c) = valid(c) ? column(c) : NaN
larger(a, b) = a > b || b != b ? a : b
smaller(a, b) = a < b || b != b ? a : b
slowest(x) = larger(larger(known(8), known(9)), known(10))
fastest(x) = smaller(smaller(known(8), known(9)), known(10))
stats "times.tsv" using 1 name "count" nooutput
stats "times.tsv" using (larger(column(2), slowest(0))) name "top" nooutput
stats "times.tsv" using 6 name "least" nooutput
low = least_min / 1.4
high = top_max * 1.6
set xrange [count_min / 1.3:count_max * 1.3]
set yrange [low:high]
set rmargin at screen 0.72
# The five names stand at the ends of their curves, a line of text apart at least.
array of[5] = ["world", "world, no sine", "loop", "loop, no sine", "loop, explicit"]
array end[5]
do for [n = 1:5] {
  stats "times.tsv" using ($1 == count_max ? column(n + 1) : NaN) name "last" nooutput
  end[n] = last_max
}
apart = exp(20. / 360 * log(high / low))
array place[5]
below = low
do for [rank = 1:5] {
  next = 0
  do for [n = 1:5] { if (end[n] > 0 && (next == 0 || end[n] < end[next])) { next = n } }
  place[next] = end[next] > below * apart ? end[next] : below * apart
  below = place[next]
  end[next] = -1
}
do for [n = 1:5] { set label sprintf("%s", of[n]) at graph 1.02, first place[n] left textcolor linetype n }
# Where the arrays of the plain loop no longer fit into a level of the cache.
in_range(bodies) = bodies > count_min && bodies < count_max ? bodies : NaN
peers = ""
named(c, name) = valid(c) && strstrt(peers, name) == 0 ? (peers = peers . (peers eq "" ? "" : ", ") . name) : peers
plot "caches.tsv" using (in_range($3)):(low):(0):(high - low) with vectors nohead linecolor rgb grey linewidth 1 dashtype (2,4), \
     "" using (in_range($3)):(high):(sprintf(" L%d", $1)) with labels left offset 0,-0.6 textcolor rgb grey, \
     "times.tsv" using 1:(fastest(0)):(slowest(0)) with filledcurves fillcolor rgb "#b9c2c9" fillstyle solid noborder, \
     "" using 1:(slowest(0)) with lines linecolor rgb grey linewidth 1 dashtype solid, \
     "" using 1:(fastest(0)) with lines linecolor rgb grey linewidth 1 dashtype solid, \
     for [n = 1:5] "" using 1:(column(n + 1)) with linespoints linetype n, \
     "" using (named(8, "Bullet"), named(10, "ODE"), $1 == count_min ? $1 : NaN):(sqrt(fastest(0) * slowest(0))):(peers) with labels left offset 0.4,0
