@drawing 504,390
set title "Eight drops in one register: one addition moves all of them"
unset border; unset tics; unset grid; unset key
set lmargin 0; set rmargin 0; set bmargin at screen 0.01; set tmargin at screen 0.9
set xrange [0:504]
set yrange [0:347]
# One unit is a dot; a lane is 46 of them wide.
left(lane) = 134 + 46 * lane
middle(lane) = left(lane) + 23
array bottom[3] = [136, 82, 28]
array name[3] = ["heights (m)", "+ speed × step", "= new heights"]
do for [row = 1:3] {
  do for [lane = 0:7] { set object rect from left(lane), bottom[row] to left(lane + 1), bottom[row] + 32 fillcolor rgb "#eef3f6" fillstyle solid border rgb "#555555" linewidth 1 }
  set label sprintf("%s", name[row]) at 127, bottom[row] + 16 right
}
set label "lane" at 127, 11 right textcolor rgb "#555555"
set label "drops" at 127, 270 right textcolor linetype 1
number(x) = (x < 0 ? "−" : "") . sprintf("%.1f", abs(x))
height(z) = 196 + 38 * z
plot "drops.tsv" using (middle($1)):(height($2)):(0):(172 - height($2)) with vectors nohead linecolor rgb "#555555" linewidth 1 dashtype (2,3), \
     "" using (middle($1)):(height($2)) with points linetype 1 pointsize 1.5, \
     for [row = 1:3] "" using (middle($1)):(bottom[row] + 16):(number(column(row + 1))) with labels, \
     "" using (middle($1)):(11):(sprintf("%d", $1)) with labels textcolor rgb "#555555"
