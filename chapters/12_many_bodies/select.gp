@drawing 504,290
set title "Every lane computes the push; the mask says which ones count"
unset border; unset tics; unset grid; unset key
set lmargin 0; set rmargin 0; set bmargin at screen 0.01; set tmargin at screen 0.85
set xrange [0:504]
set yrange [0:240]
# One unit is a dot; a lane is 46 of them wide.
left(lane) = 134 + 46 * lane
middle(lane) = left(lane) + 23
array bottom[5] = [204, 156, 108, 70, 22]
array name[5] = ["height (m)", "{/:Italic z} < 0", "− {/:Italic k z} (N)", "0 (N)", "push (N)"]
do for [row = 1:5] {
  do for [lane = 0:7] { set object rect from left(lane), bottom[row] to left(lane + 1), bottom[row] + 30 fillcolor rgb "#eef3f6" fillstyle solid border rgb "#555555" linewidth 1 }
  set label name[row] at 127, bottom[row] + 15 right
}
set label "lane" at 127, 6 right textcolor rgb "#555555"
number(x) = (x < 0 ? "−" : "") . sprintf("%g", abs(x))
whole(x) = (x < -0.5 ? "−" : "") . sprintf("%.0f", abs(x))
# What the mask takes is framed and strong, what it leaves is grey.
plot "select.tsv" using (middle($1)):(bottom[1] + 15):(number($2)) with labels, \
     "" using ($3 == 1 ? middle($1) : NaN):(bottom[2] + 15):("yes") with labels textcolor linetype 2, \
     "" using ($3 == 0 ? middle($1) : NaN):(bottom[2] + 15):("no") with labels textcolor rgb "#555555", \
     "" using ($3 == 1 ? middle($1) : NaN):(bottom[3] + 15):(whole($4)) with labels textcolor linetype 2, \
     "" using ($3 == 0 ? middle($1) : NaN):(bottom[3] + 15):(whole($4)) with labels textcolor rgb "#555555", \
     "" using ($3 == 0 ? middle($1) : NaN):(bottom[4] + 15):("0") with labels, \
     "" using ($3 == 1 ? middle($1) : NaN):(bottom[4] + 15):("0") with labels textcolor rgb "#555555", \
     "" using (middle($1)):($3 == 1 ? bottom[3] + 15 : bottom[4] + 15):(19):(13) with boxxyerror fillstyle empty linetype 1 linewidth 2 dashtype solid, \
     "" using (middle($1)):(bottom[5] + 15):(whole($5)) with labels, \
     "" using (middle($1)):(6):(sprintf("%d", $1)) with labels textcolor rgb "#555555"
