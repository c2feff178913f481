@drawing 545,420
set title "The longest step with less than half of the allowed error"
set xlabel "time for a simulated second (ns)"
set ylabel "error after 10 s (rad)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xrange [100:5e4]
set yrange [1e-11:10]
set ytics 1e-11, 1e2
unset key
# Each run takes √2 times the steps of the one before it: every second one doubles them.
runs = -1
is_run(m, p) = strcol(1) eq "splitting, Suzuki" && strcol(2) eq "double"
number(x) = is_run(0, 0) ? (runs = runs + 1, runs) : -1
doubled(n) = n >= 5 && n <= 15 && n % 2 == 1
set arrow from 100,1e-6 to 5e4,1e-6 nohead linetype 7 linewidth 1.3
set arrow from 100,5e-7 to 5e4,5e-7 nohead linecolor rgb "#555555" linewidth 1 dashtype (2,3)
set label "allowed" at 115,1e-6 left offset 0,0.7 textcolor rgb "#22303a"
set label "half of it" at 115,5e-7 left offset 0,-0.8 textcolor rgb "#555555"
plot "runs_ordinary.tsv" using (is_run(0, 0) ? column(4) : NaN):3 with lines linecolor rgb "#b9c2c9" linewidth 2, \
     (runs = -1, "runs_ordinary.tsv") using (n = number(0), doubled(n) ? column(4) : NaN):3 with points linetype 1 pointtype 7 pointsize 1, \
     (runs = -1, "runs_ordinary.tsv") using (n = number(0), n == 14 ? column(4) : NaN):3 with points linetype 2 pointtype 6 pointsize 1.6 linewidth 2.5, \
     (runs = -1, "runs_ordinary.tsv") using (n = number(0), n == 9 ? column(4) : NaN):3:("steps are doubled, …") with labels left offset 1,0.4 textcolor linetype 1, \
     (runs = -1, "runs_ordinary.tsv") using (n = number(0), n == 15 ? column(4) : NaN):3:("… until below,") with labels left offset 1,0.3 textcolor linetype 1, \
     (runs = -1, "runs_ordinary.tsv") using (n = number(0), n == 14 ? column(4) : NaN):3:("then fewer are tried") with labels right offset -1,-1.3 textcolor linetype 2
