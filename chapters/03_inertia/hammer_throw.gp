@drawing 640,400
set output name.".svg"
unset border
unset tics
unset grid
set size ratio -1
set autoscale fix
set offsets 0.02, 0.02, 0.02, 0.02
set lmargin 0
set rmargin 0
set bmargin 4
set title "One point of a thrown hammer draws a parabola: its centre of mass"
set key bmargin center horizontal maxcols 2 samplen 3
data = "hammer_throw.tsv"
is(kind) = strcol(1) eq kind ? column(2) : NaN
plot data using (is("end")):3 with lines linestyle 3 linewidth 1.4 title "end of the handle", \
     for [k=0:10] data using (is(sprintf("handle %d", k))):3 with filledcurves closed \
       fillstyle transparent solid 0.28 border linestyle 5 dashtype solid linewidth 1 notitle, \
     for [k=0:10] data using (is(sprintf("head %d", k))):3 with filledcurves closed \
       fillstyle transparent solid 0.6 border linestyle 6 dashtype solid linewidth 1 notitle, \
     data using (is("parabola")):3 with lines linestyle 7 linewidth 1.8 title "exact parabola", \
     data using (is("centre")):3 with points linestyle 1 pointsize 0.8 title "centre of mass, stepped", \
     data using (is("push")):3:4:5 with vectors head filled linestyle 2 dashtype solid linewidth 3 title "the push"
