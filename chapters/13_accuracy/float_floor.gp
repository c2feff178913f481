@drawing 540,440
set title "In float the error stops falling long before it does in double"
set xlabel "time for a simulated second (ns)"
set ylabel "error after 10 s (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xrange [50:2e5]
set yrange [1e-15:10]
set ytics 1e-15, 1e5
unset key
is(method, precision) = strcol(1) eq method && strcol(2) eq precision
run(method, precision) = is(method, precision) ? column(4) : NaN
eighth = "splitting, Kahan-Li 8"
# A name stands beside the first run whose error is below a level.
named = ""
name_at(method, precision, level) = is(method, precision) && column(3) < level && named ne method.precision ? (named = method.precision, column(4)) : NaN
plot "runs_ordinary.tsv" using (run("splitting", "float")):3 with linespoints linestyle 1, \
     "" using (run("splitting", "double")):3 with linespoints linestyle 3, \
     "" using (run(eighth, "float")):3 with linespoints linestyle 2, \
     "" using (run(eighth, "double")):3 with linespoints linestyle 4, \
     "" using (name_at("splitting", "float", 1e-3)):3:("order 2, float") with labels left offset 0.5,1.1 textcolor linetype 1, \
     "" using (name_at("splitting", "double", 2e-6)):3:("order 2, double") with labels right offset 1,-1.2 textcolor linetype 3, \
     "" using (name_at(eighth, "float", 1e-5)):3:("order 8, float") with labels right offset -1,-0.3 textcolor linetype 2, \
     "" using (name_at(eighth, "double", 1e-9)):3:("order 8, double") with labels right offset -1,-0.3 textcolor linetype 4
