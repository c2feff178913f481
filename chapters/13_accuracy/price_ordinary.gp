@drawing 545,480
set title "What an error costs, for an ordinary body"
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
plot for [m in "'Odeint rk4' 'Odeint Fehlberg 7(8)'"] \
       "runs_ordinary.tsv" using (run(m)):3 with lines linecolor rgb grey linewidth 1 dashtype 1, \
     for [m in "'Simbody Verlet, controlled' 'Simbody Merson, controlled' 'Simbody CPodes'"] \
       "" using (run(m)):3 with lines linecolor rgb grey linewidth 1 dashtype 2, \
     "" using (run("Bullet functions")):3 with lines linecolor rgb grey linewidth 1 dashtype 3, \
     "" using (run("ODE QuickStep, finite rotation")):3 with lines linecolor rgb grey linewidth 1 dashtype 4, \
     "" using (run("momentum-carrying")):3 with linespoints linestyle 4, \
     "" using (run("splitting")):3 with linespoints linestyle 1, \
     "" using (run("splitting, Blanes-Moan 6")):3 with linespoints linestyle 3, \
     "" using (run("Runge-Kutta")):3 with linespoints linestyle 2, \
     "" using (run("Dormand-Prince 8")):3 with linespoints linestyle 5, \
     "" using (run("exact solution")):3 with points linestyle 7 pointtype 3 pointsize 1.2, \
     "" using (name_at("momentum-carrying", 0.5)):3:("momentum-carrying 1") with labels center offset 1.6,-1.5 textcolor linetype 4, \
     "" using (name_at("splitting", 1e-4)):3:("splitting 2") with labels left offset 0.8,0.4 textcolor linetype 1, \
     "" using (name_at("splitting, Blanes-Moan 6", 1e-4)):3:("splitting 6") with labels left offset 0.6,-0.2 textcolor linetype 3, \
     "" using (name_at("Runge-Kutta", 1e-7)):3:("Runge-Kutta 4") with labels left offset 0.8,0.4 textcolor linetype 2, \
     "" using (name_at("Dormand-Prince 8", 1e-8)):3:("Dormand-\nPrince 8") with labels right offset -0.8,-0.4 textcolor linetype 5, \
     "" using (run("exact solution")):3:("exact") with labels left offset 1.2,0 textcolor linetype 7, \
     "" using (name_at("Odeint rk4", 1e-10)):3:("Odeint 4") with labels left offset 0.8,0.4 textcolor rgb grey, \
     "" using (name_at("Odeint Fehlberg 7(8)", 1e-11)):3:("Odeint 8") with labels right offset -1.4,0 textcolor rgb grey, \
     "" using (name_at("Bullet functions", 0.014)):3:("Bullet") with labels left offset 0.6,0 textcolor rgb grey, \
     "" using (name_at("ODE QuickStep, finite rotation", 0.35)):3:("ODE") with labels left offset 0.8,0.4 textcolor rgb grey, \
     "" using (name_at("Simbody Merson, controlled", 1e-4)):3:("Simbody") with labels right offset -0.2,-0.9 textcolor rgb grey
