@drawing 560,440
set output name.".svg"
unset border
unset tics
unset key
unset grid
set size ratio -1
set xrange [-1.9:3.0]
set yrange [-1.05:2.1]
set margins 0, 0, 0, 2
set title "1000 particles have a centre, three axes and three moments"
data = "cloud.tsv"
is(kind) = strcol(1) eq kind ? column(2) : NaN
plot data using (is("edge")):3:4:5 with vectors nohead linecolor rgb "#555555" linewidth 0.8, \
     data using (is("particle")):3 with points linestyle 1 pointsize 0.2, \
     data using (is("axis")):3:4:5 with vectors head filled linestyle 2 dashtype solid linewidth 2.5, \
     data using (is("centre")):3 with points linestyle 2 pointtype 7 pointsize 0.9, \
     data using (is("label")):3:6 with labels left textcolor rgb "#22303a"
