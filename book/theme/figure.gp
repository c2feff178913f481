# What every figure shares. Run before the figure's own script, with name set to the figure's name.
#
# The colours below are names: the book turns each into a colour of its style sheet, so that one drawing suits light,
# dark and print. Lines also differ by dash and by point, for readers and printers without colour.
#   linetype 1 to 6   data
#   linetype 7        the exact answer: thin, dashed, in the colour of the text
#   #555555           what helps to read: frames, arrows, labels
#   #b9c2c9           the grid
# A line is named where it ends: title "its name" at end, in its own colour. Where lines end in one place or leave the picture,
# a label stands beside them: set label 1 "its name" at x, y textcolor linetype 2. Where the place of a line depends on the
# machine, the name is plotted with labels, beside a row of the table: see price_ordinary.gp. Letters have one size, that of the text.
# The title states the finding. Its size marks it: the book takes it out and sets it as text above the drawing, where it
# can break into lines. So leave its font alone. Empty paper around the drawing is cut away.
# The name of the y axis is set level above it by the book.
# A variable stands in italics, as in the text: "{/:Italic h}²{/:Italic a}". Where a program wrote a formula, formula() sets it so.
# A drawing of another size begins with @drawing WIDTH,HEIGHT.
drawing = 'set terminal svg dynamic font "sans-serif,16" name name enhanced background rgb "#fffffe" size'
@drawing 480,400
set output name.".svg"
set encoding utf8
set minussign
set datafile separator "\t"
set key autotitle columnhead

set linetype 1 linecolor rgb "#0b6aa2" linewidth 2   dashtype solid      pointtype 7 pointsize 0.55
set linetype 2 linecolor rgb "#c2500a" linewidth 2   dashtype (8,4)      pointtype 5 pointsize 0.55
set linetype 3 linecolor rgb "#12805c" linewidth 2   dashtype (2,3)      pointtype 9 pointsize 0.65
set linetype 4 linecolor rgb "#96408a" linewidth 2   dashtype (10,3,2,3) pointtype 13 pointsize 0.65
set linetype 5 linecolor rgb "#8a6a00" linewidth 2   dashtype (5,2)      pointtype 11 pointsize 0.65
set linetype 6 linecolor rgb "#4d5bc4" linewidth 2   dashtype (14,4)     pointtype 6 pointsize 0.55
set linetype 7 linecolor rgb "#22303a" linewidth 1.3 dashtype (4,3)      pointtype 2 pointsize 0.5
set linetype cycle 7

set border 3 linecolor rgb "#555555" linewidth 1
set tics nomirror scale 0.6 textcolor rgb "#22303a"
unset mxtics; unset mytics # where a label stands for some powers of ten, the others would crowd beside it
set grid linecolor rgb "#b9c2c9" linewidth 0.6 dashtype solid
set title font "sans-serif,18" textcolor rgb "#22303a"
set xlabel offset 0,0.4 textcolor rgb "#22303a"
set ylabel textcolor rgb "#22303a"
set key below left Left reverse samplen 2.5 spacing 1.15 height 0.7 textcolor variable

formula(text) = "{/:Italic ".with_minus(text)."}"
with_minus(text) = strstrt(text, "-") == 0 ? text : text[1:strstrt(text, "-") - 1]."−".with_minus(text[strstrt(text, "-") + 1:*])
