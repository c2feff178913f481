@drawing 504,330
set title "One addition moves eight drops"
unset border; unset tics; unset grid; unset key
set lmargin 0; set rmargin 0; set bmargin at screen 0.01; set tmargin at screen 0.83
set xrange [0:504]
set yrange [0:270]
# One unit is a dot; a lane is 46 of them wide.
left(lane) = 134 + 46 * lane
middle(lane) = left(lane) + 23
array bottom[3] = [124, 76, 28]
array name[3] = ["heights (m)", "+ speed × step", "= new heights"]
do for [row = 1:3] {
  do for [lane = 0:7] { set object rect from left(lane), bottom[row] to left(lane + 1), bottom[row] + 30 fillcolor rgb "#eef3f6" fillstyle solid border rgb "#555555" linewidth 1 }
  set label sprintf("%s", name[row]) at 127, bottom[row] + 15 right
}
set label "lane" at 127, 11 right textcolor rgb "#555555"
set label "drops" at 127, 205 right textcolor linetype 1
number(x) = (x < 0 ? "−" : "") . sprintf("%.1f", abs(x))
height(z) = 163 + 25 * z
plot "drops.tsv" using (middle($1)):(height($2)):(0):(157 - height($2)) with vectors nohead linecolor rgb "#555555" linewidth 1 dashtype (2,3), \
     "" using (middle($1)):(height($2)) with points linetype 1 pointsize 1, \
     for [row = 1:3] "" using (middle($1)):(bottom[row] + 15):(number(column(row + 1))) with labels, \
     "" using (middle($1)):(11):(sprintf("%d", $1)) with labels textcolor rgb "#555555"
