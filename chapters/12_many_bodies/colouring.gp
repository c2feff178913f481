@drawing 480,250
set title "Packs of the same colour share no pack of tops"
unset border; unset tics; unset grid; unset key
set lmargin 0; set rmargin 0; set bmargin at screen 0.01; set tmargin at screen 0.84
set xrange [0:480]
set yrange [0:207]
# A pack is four lanes of 24 dots. Packs of bodies lie above, those of their tops below.
wide = 96
left_of_bodies(pack) = 26 + 114 * pack
left_of_tops(pack) = 83 + 114 * pack
body_x(body) = left_of_bodies(floor(body / 4)) + 24 * (int(body) % 4) + 12
top_x(top) = left_of_tops(floor(top / 4)) + 24 * (int(top) % 4) + 12
do for [pack = 0:3] { set object rect from left_of_bodies(pack), 132 to left_of_bodies(pack) + wide, 160 fillcolor rgb "#eef3f6" fillstyle solid border rgb "#555555" linewidth 1 }
do for [pack = 0:2] { set object rect from left_of_tops(pack), 34 to left_of_tops(pack) + wide, 62 fillcolor rgb "#eef3f6" fillstyle solid border rgb "#555555" linewidth 1 }
set label "packs of bodies (○: a point, without a top)" at 240, 182 center
set label "packs of tops" at 240, 14 center
of_part(part, x) = column(2) == part ? x : NaN
with_top(x) = column(3) >= 0 ? x : NaN
plot for [part = 0:1] "colouring.tsv" using (of_part(part, with_top(body_x($1)))):(146):(top_x($3) - body_x($1)):(-98) with vectors nohead linecolor part + 1 linewidth 1.5, \
     for [part = 0:1] "" using (of_part(part, with_top(body_x($1)))):(146) with points linetype part + 1 pointtype 7 pointsize 0.9, \
     for [part = 0:1] "" using (of_part(part, $3 < 0 ? body_x($1) : NaN)):(146) with points linetype part + 1 pointtype 6 pointsize 0.9, \
     for [part = 0:1] "" using (of_part(part, with_top(top_x($3)))):(48) with points linetype part + 1 pointtype 7 pointsize 0.9
