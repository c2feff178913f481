@drawing 545,480
set title "A swinging torque: high order pays for small errors"
set xlabel "time for a simulated second (ns)"
set ylabel "error after 10 s (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xrange [50:2e6]
set yrange [1e-15:10]
set ytics 1e-15, 1e5
unset key
is(method, precision) = strcol(1) eq method && strcol(2) eq precision
run(method) = is(method, "double") ? column(4) : NaN
# A name stands beside the first run whose error is below a level.
named = ""
name_at(method, level) = is(method, "double") && column(3) < level && named ne method ? (named = method, column(4)) : NaN
grey = "#555555"
set label 2 "Odeint" at 1.7e5, 1e-11 left textcolor rgb grey
plot for [m in "'Odeint rk4' 'Odeint Dormand-Prince 5' 'Odeint Fehlberg 7(8)' 'Odeint Bulirsch-Stoer'"] \
       "runs_driven.tsv" using (run(m)):3 with lines linecolor rgb grey linewidth 1 dashtype 1, \
     for [m in "'Simbody Verlet, controlled' 'Simbody Merson, controlled' 'Simbody CPodes'"] \
       "" using (run(m)):3 with lines linecolor rgb grey linewidth 1 dashtype 2, \
     "" using (run("Bullet functions")):3 with lines linecolor rgb grey linewidth 1 dashtype 3, \
     "" using (run("ODE QuickStep, finite rotation")):3 with lines linecolor rgb grey linewidth 1 dashtype 4, \
     "" using (run("kick and drift")):3 with linespoints linestyle 4, \
     "" using (run("kicked splitting")):3 with linespoints linestyle 1, \
     "" using (run("kicked splitting, Kahan-Li 6")):3 with linespoints linestyle 3, \
     "" using (run("Runge-Kutta")):3 with linespoints linestyle 2, \
     "" using (run("Dormand-Prince 8")):3 with linespoints linestyle 5, \
     "" using (run("Fehlberg 8")):3 with linespoints linestyle 6, \
     "" using (name_at("kick and drift", 0.05)):3:("kick, drift 1") with labels left offset -1,-1.1 textcolor linetype 4, \
     "" using (name_at("kicked splitting", 2e-5)):3:("splitting 2") with labels left offset 1.6,0.1 textcolor linetype 1, \
     "" using (name_at("kicked splitting, Kahan-Li 6", 1e-5)):3:("splitting 6") with labels left offset 0.8,0.4 textcolor linetype 3, \
     "" using (name_at("Runge-Kutta", 1e-12)):3:("RK 4") with labels left offset 1,0 textcolor linetype 2, \
     "" using (name_at("Dormand-Prince 8", 1e-14)):3:("RK 8") with labels right offset -0.8,0 textcolor linetype 5, \
     "" using (name_at("Fehlberg 8", 1e-8)):3:("Fehlberg 8") with labels right offset -0.8,-0.4 textcolor linetype 6, \
     "" using (name_at("Bullet functions", 0.03)):3:("Bullet") with labels left offset 0.6,0 textcolor rgb grey, \
     "" using (name_at("ODE QuickStep, finite rotation", 0.35)):3:("ODE") with labels left offset 0.8,0.4 textcolor rgb grey, \
     "" using (name_at("Simbody Merson, controlled", 1e-3)):3:("Simbody") with labels left offset 0.6,-0.1 textcolor rgb grey
