@drawing 520,300
set title "Two children balance on a seesaw"
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.9:2.4]
set yrange [-1.05:0.75]
set margins 0, 0, 0, 2
of(kind) = strcol(1) eq kind ? column(2) : NaN
set object 1 polygon from 0, -0.05 to 0.22, -0.55 to -0.22, -0.55 to 0, -0.05 fillcolor rgb "#b9c2c9" fillstyle solid noborder
set arrow 1 from -1.7, -0.02 to 2.2, -0.02 nohead linecolor rgb "#555555" linewidth 5
set arrow 2 from -1.7, -0.55 to 2.2, -0.55 nohead linecolor rgb "#555555" linewidth 1
set label 1 "pivot" at 0, -0.72 center textcolor linetype 7
plot "seesaw.tsv" using (of("weight")):(0.22):(0.17) with circles fillcolor rgb "#0b6aa2" fillstyle solid noborder, \
     "" using (of("weight")):(0):4:5 with vectors head size 0.1,20 filled linetype 2 dashtype solid linewidth 3, \
     "" using (of("weight") + 0.1):(0.5 * $5 - 0.1):6 with labels left textcolor linetype 2, \
     "" using (of("weight")):(0.56):(sprintf("%g m %s", abs($2), $2 < 0 ? "to the left" : "to the right")) with labels center textcolor linetype 7
