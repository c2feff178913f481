@drawing 480,300
set output name.".svg"
set title "The part along the axis stays, the part across it turns"
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.15:1.25]
set yrange [-0.08:1.75]
set margins 0, 0, 0, 2
is(kind) = strcol(1) eq kind ? column(2) : NaN
data = "parts.tsv"
# A dashed head would be torn, so the head of a dashed arrow is an arrow of its own.
end(kind) = is(kind) + 0.97*column(4)
set label 1 "{/:Italic n}" at 0.06, 1.64 left textcolor rgb "#22303a"
set label 2 "{/:Italic v}" at -0.44, 0.22 right textcolor linetype 1
set label 3 "{/:Italic v} turned" at 0.62, 0.3 left textcolor linetype 1
set label 4 "stays" at 0.06, 0.42 left textcolor linetype 3
set label 5 "turns by {/:Italic θ}" at -0.06, 1.02 right textcolor linetype 2
plot data using (is("axis")):3:4:5 with vectors nohead linecolor rgb "#555555" linewidth 1 dashtype (4,3), \
     data using (is("circle")):3 with lines linecolor rgb "#555555" linewidth 0.8 dashtype (4,3), \
     data using (is("angle")):3 with lines linecolor rgb "#555555" linewidth 1.4 dashtype solid, \
     data using (is("along")):3:4:5 with vectors head filled size 0.1,18 fixed linestyle 3 dashtype solid linewidth 2.4, \
     data using (is("across")):3:4:5 with vectors head filled size 0.1,18 fixed linestyle 2 dashtype solid linewidth 2.4, \
     data using (is("v")):3:4:5 with vectors head filled size 0.1,18 fixed linestyle 1 dashtype solid linewidth 2.4, \
     data using (is("turned across")):3:4:5 with vectors nohead linestyle 2 dashtype (6,3) linewidth 2.4, \
     data using (end("turned across")):($3 + 0.97*$5):(0.03*$4):(0.03*$5) with vectors head filled size 0.1,18 fixed linestyle 2 dashtype solid linewidth 2.4, \
     data using (is("turned")):3:4:5 with vectors nohead linestyle 1 dashtype (6,3) linewidth 2.4, \
     data using (end("turned")):($3 + 0.97*$5):(0.03*$4):(0.03*$5) with vectors head filled size 0.1,18 fixed linestyle 1 dashtype solid linewidth 2.4
