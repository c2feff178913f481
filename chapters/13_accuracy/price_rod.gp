@drawing 480,520
set title "A thin rod: one step of the splitting is worth dozens of evaluations"
set xlabel "time for a simulated second (ns)"
set ylabel "error after 1 s (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set termoption enhanced
set xrange [50:1e6]
set yrange [1e-15:10]
set ytics 1e-15, 1e5
set key below left Left reverse samplen 1.5 maxrows 4
is(method, precision) = strcol(1) eq method && strcol(2) eq precision
grey = "#555555"
plot for [m in "'Odeint rk4' 'Odeint Dormand-Prince 5' 'Odeint Fehlberg 7(8)' 'Odeint Bulirsch-Stoer'"] \
       "runs_rod.tsv" using (is(m, "double") ? $4 : NaN):3 with lines linecolor rgb grey linewidth 1 dashtype 1 notitle, \
     for [m in "'Simbody Verlet, controlled' 'Simbody Merson, controlled' 'Simbody CPodes'"] \
       "" using (is(m, "double") ? $4 : NaN):3 with lines linecolor rgb grey linewidth 1 dashtype 2 notitle, \
     "" using (is("Bullet functions", "double") ? $4 : NaN):3 with lines linecolor rgb grey linewidth 1 dashtype 3 notitle, \
     "" using (is("ODE QuickStep, finite rotation", "double") ? $4 : NaN):3 with lines linecolor rgb grey linewidth 1 dashtype 4 notitle, \
     "" using (is("momentum-carrying", "double") ? $4 : NaN):3 with linespoints linestyle 5 title "carrying 1", \
     "" using (is("splitting", "double") ? $4 : NaN):3 with linespoints linestyle 1 title "splitting 2", \
     "" using (is("splitting, Blanes-Moan 6", "double") ? $4 : NaN):3 with linespoints linestyle 3 title "splitting 6", \
     "" using (is("Runge-Kutta", "double") ? $4 : NaN):3 with linespoints linestyle 2 title "RK 4", \
     "" using (is("Dormand-Prince 8", "double") ? $4 : NaN):3 with linespoints linestyle 4 title "RK 8", \
     "" using (is("exact solution", "double") ? $4 : NaN):3 with points linestyle 6 pointtype 3 pointsize 1.2 title "exact", \
     NaN with lines linecolor rgb grey linewidth 1 dashtype 1 title "Odeint", \
     NaN with lines linecolor rgb grey linewidth 1 dashtype 2 title "engines"
