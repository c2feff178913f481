set title "With ω on the wrong side, the nose goes round another axis"
unset border
unset tics
unset grid
set size ratio -1
set xrange [-1.2:1.4]
set yrange [-1.05:1.4]
set margins 1, 1, 3, 2
marks = "wrong_side_marks.tsv"
is(kind) = strcol(1) eq kind ? column(2) : NaN
near(c) = column(c + 2) == 1 ? column(c) : NaN
far(c) = column(c + 2) == 0 ? column(c) : NaN
# What runs behind the globe is dotted.
plot "wrong_side.tsv" using 7:8 with lines linecolor rgb "#b9c2c9" linewidth 1 dashtype solid notitle, \
     "" using (far(1)):2 with lines linestyle 1 dashtype (1,4) notitle, \
     "" using (far(4)):5 with lines linestyle 2 dashtype (1,4) notitle, \
     "" using (near(1)):2 with lines linestyle 1 title "the nose, {/:Italic ω} on the left: about {/:Italic ω}", \
     "" using (near(4)):5 with lines linestyle 2 title "the nose, {/:Italic ω} on the right", \
     marks using (is("right")):3:4:5 with vectors head filled linestyle 1 notitle, \
     marks using (is("wrong")):3:4:5 with vectors head filled linestyle 2 dashtype solid notitle, \
     marks using (is("dot")):3 with points linestyle 7 pointtype 7 pointsize 0.8 notitle, \
     marks using (is("label")):3:(strcol(6) eq "ω" ? formula("ω") : strcol(6) eq "the body's z" ? "the body's ".formula("z") : strcol(6)) with labels textcolor rgb "#22303a" notitle
