@drawing 460,380
set title "What moves and turns has another velocity at each point"
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.2:2.7]
set yrange [-1.6:1.6]
set margins 0, 0, 0, 2
of(kind) = strcol(1) eq kind ? column(2) : NaN
last(kind) = strcol(1) eq kind && column(3) > 0.9 ? column(2) : NaN
set label 1 "{/:Italic V}" at 1.05, 0.93 center textcolor linetype 7
set label 4 "centre" at -0.12, 0 right textcolor linetype 7
set label 2 "{/:Italic ω} × {/:Italic r}" at 1.13, 1.45 left textcolor linetype 2
set label 3 "{/:Italic v}" at 0.57, 1.35 right textcolor linetype 1
plot "velocities.tsv" using (of("rod")):3:4:5 with vectors nohead linecolor rgb "#b9c2c9" linewidth 8 dashtype solid, \
     "" using (of("moving")):3:4:5 with vectors head size 0.09,20 filled linecolor rgb "#555555" linewidth 1 dashtype solid, \
     "" using (of("turning")):3:4:5 with vectors head size 0.09,20 filled linetype 2 dashtype solid, \
     "" using (of("both")):3:4:5 with vectors head size 0.11,20 filled linetype 1 linewidth 2.5, \
     "" using (of("particle")):3 with points linetype 7 pointtype 7 pointsize 0.9
