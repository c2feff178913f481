@drawing 560,470
set title "Each scheme divides its step into kicks and drifts of its own"
set xlabel "time, as a part of the step"
set xrange [-0.02:1.02]
set yrange [0.8:12.6]
set xtics 0.25
set border 1
unset key
set ytics ("Euler" 11.5, "Verlet" 10, "Suzuki" 5) scale 0
set grid noytics
forwards = "#0b6aa2"
backwards = "#c2500a"
set style arrow 1 head nofilled size screen 0.02,20 linecolor rgb forwards linewidth 2
set style arrow 2 head nofilled size screen 0.02,20 linecolor rgb backwards linewidth 2
# Suzuki's five steps of Verlet, each below the one before: where they begin, and how long they are.
p = 1 / (4 - 4**(1.0 / 3))
begins(i) = i < 3 ? i * p : 1 - (5 - i) * p
lasts(i) = i == 2 ? 1 - 4 * p : p
kicks(i) = begins(i) + lasts(i) / 2
row(i) = 8.2 - 1.6 * i
signed(x) = x < 0 ? sprintf("−%.2f {/:Italic h}", -x) : sprintf("%.2f {/:Italic h}", x)
set arrow from 0,11.5 to 1,11.5 arrowstyle 1
set arrow from 0,10 to 1,10 arrowstyle 1
set label "kick by {/:Italic h}" at 0,11.5 left offset 0,0.8 textcolor rgb forwards
set label "kick by {/:Italic h}" at 0.5,10 center offset 0,0.8 textcolor rgb forwards
do for [i=0:4] {
  set arrow from begins(i),row(i) to begins(i)+lasts(i),row(i) arrowstyle i == 2 ? 2 : 1
  set label "kick by ".signed(lasts(i)) at kicks(i),row(i) center offset 0,0.8 textcolor rgb i == 2 ? backwards : forwards
}
set label "drift" at 0.98,11.5 right offset 0,0.8 textcolor rgb forwards
plot "+" using (0):(11.5) every ::0::0 with points pointtype 7 pointsize 1.1 linecolor rgb forwards, \
     "+" using (0.5):(10) every ::0::0 with points pointtype 7 pointsize 1.1 linecolor rgb forwards, \
     for [i=0:4] "+" using (kicks(i)):(row(i)) every ::0::0 with points pointtype 7 pointsize 1.1 linecolor rgb i == 2 ? backwards : forwards
