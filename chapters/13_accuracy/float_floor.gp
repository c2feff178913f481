set title "In float the error stops falling long before it does in double"
set xlabel "time for a simulated second (ns)"
set ylabel "error after 10 s (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set termoption enhanced
set xrange [50:2e5]
set yrange [1e-15:10]
set ytics 1e-15, 1e5
set key below left Left reverse samplen 1.5 maxrows 2
is(method, precision) = strcol(1) eq method && strcol(2) eq precision
plot "runs_ordinary.tsv" using (is("splitting", "float") ? $4 : NaN):3 with linespoints linestyle 1 title "order 2, float", \
     "" using (is("splitting", "double") ? $4 : NaN):3 with linespoints linestyle 3 title "order 2, double", \
     "" using (is("splitting, Kahan-Li 8", "float") ? $4 : NaN):3 with linespoints linestyle 2 title "order 8, float", \
     "" using (is("splitting, Kahan-Li 8", "double") ? $4 : NaN):3 with linespoints linestyle 4 title "order 8, double"
