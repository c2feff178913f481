@drawing 520,420
set title "The classical rule asks for four slopes and goes by their mean"
set xlabel "time, as a part of the step"
set ylabel "{/:Italic y}"
set xrange [-0.02:1.25]
set yrange [0.4:5.4]
set xtics 0,0.25,1
set ytics 1
set rmargin 3
unset grid
unset key
# y' = y, from y = 1, by one step as long as h = 1.5: long enough to see where each slope points.
h = 1.5
slope_1 = 1.0
slope_2 = 1 + h / 2 * slope_1
slope_3 = 1 + h / 2 * slope_2
slope_4 = 1 + h * slope_3
mean = (slope_1 + 2 * slope_2 + 2 * slope_3 + slope_4) / 6
array at[4] = [0, 0.5, 0.5, 1]
array value[4] = [slope_1, slope_2, slope_3, slope_4] # for the slope of y' = y is y
set style arrow 1 head filled size screen 0.02,20 linecolor rgb "#c2500a" linewidth 2
reach(i) = 0.16 / sqrt(1 + (0.22 * h * value[i])**2) # of one length, for a step is 0.22 as long in the drawing as so much of y
do for [i=1:4] {
  set arrow from at[i],value[i] to at[i]+reach(i),value[i]+reach(i)*h*value[i] arrowstyle 1
}
set label "1" at at[1],value[1] offset 0.3,-0.9 textcolor linetype 2
set label "2" at at[2],value[2] offset 0.3,-0.9 textcolor linetype 2
set label "3" at at[3],value[3] offset -1.6,-0.2 textcolor linetype 2
set label "4" at at[4],value[4] offset -0.9,1 textcolor linetype 2
set label "exact" at 0.8,exp(h * 0.8) offset 0.8,-0.9 textcolor linetype 7
set label "Euler" at 1,1+h offset 0.9,0 textcolor rgb "#555555"
set label "classical" at 1,1+h*mean offset 1.1,-0.5 textcolor linetype 1
plot sample [x=0:1] "+" using 1:(exp(h * $1)) with lines linestyle 7, \
     [x=0:1] "+" using 1:(1 + h * $1) with lines linecolor rgb "#555555" dashtype 3, \
     [x=0:1] "+" using 1:(1 + h * mean * $1) with lines linestyle 1, \
     [i=1:4] "+" using (at[int($1)]):(value[int($1)]) with points pointtype 7 pointsize 0.6 linecolor rgb "#c2500a", \
     [x=1:2] "+" using (1):(1 + h) every ::0::0 with points pointtype 6 pointsize 0.9 linecolor rgb "#555555", \
     [x=1:2] "+" using (1):(1 + h * mean) every ::0::0 with points pointtype 7 pointsize 1.1 linecolor rgb "#0b6aa2"
