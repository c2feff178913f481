@drawing 500,350
set output name.".svg"
set title "One effect wakes the next, until a round brings nothing new"
unset grid
unset border
unset key
set tics scale 0
set lmargin 13
set rmargin 0.5
set bmargin 0.5
set xrange [0.5:3.5]
set yrange [3.9:0.1]
set format x ""
do for [n = 1:3] { set label n sprintf("round %d", n) at n, 0.32 center textcolor rgb "#555555" }
part(text, from) = (from <= words(text) ? word(text, from) : "").(from < words(text) ? " ".word(text, from + 1) : "").(from + 1 < words(text) ? " ".word(text, from + 2) : "")
lines(text) = part(text, 1).(words(text) > 3 ? "\n".part(text, 4) : "").(words(text) > 6 ? "\n".part(text, 7) : "")
set label 4 "thick frame: the effect acts" at 2, 3.7 center textcolor rgb "#555555"
plot "rounds.tsv" using 3:2:(0.47):(0.43):ytic(1) with boxxyerror linecolor rgb "#b9c2c9" linewidth 1 dashtype solid fillstyle empty, \
     "" using ($4 == 1 ? $3 : NaN):2:(0.47):(0.43) with boxxyerror linecolor rgb "#0b6aa2" linewidth 3 dashtype solid fillstyle empty, \
     "" using 3:($2 - 0.14 * (words(strcol(5)) > 6 ? 2 : words(strcol(5)) > 3)):(lines(strcol(5))) with labels center textcolor rgb "#22303a"
