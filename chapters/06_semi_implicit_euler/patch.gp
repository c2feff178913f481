@drawing 500,290
set output name.".svg"
# Start, kick and drift side by side; the explicit step is outlined beside the drift.
set multiplot layout 1,3 margins 0.15,0.99,0.21,0.86 spacing 0.03,0 title "A kick and a drift shear a patch of starts and keep its area" font "sans-serif,18"
set xlabel "{/:Italic x} (m)"
set label 3 "{/:Italic v} (m/s)" at graph -0.48, graph 1.14 left textcolor rgb "#22303a" # an axis' own name is left out where its room is short
set size ratio -1
set xrange [0.2:1.6]
set xtics (0.4, 0.8, 1.2)
set yrange [-1.4:0.5]
set ytics 0.5
of(kind) = strcol(1) eq kind ? column(2) : NaN
area(kind) = strcol(1) eq kind ? 0.9 : NaN
set label 1 "start" at 0.9, 0.33 center textcolor rgb "#22303a"
plot "patch.tsv" using (of("start")):3 with filledcurves closed fillstyle transparent solid 0.25 border linestyle 7 notitle, \
     "patch_areas.tsv" using (area("start")):(-1.24):(sprintf("%.2f m²/s", $2)) with labels textcolor rgb "#22303a" notitle
unset label 3
set format y ""
set label 1 "after the kick" at 0.9, 0.33 center textcolor linetype 3
plot "patch.tsv" using (of("start")):3 with lines linestyle 7 notitle, \
     "patch.tsv" using (of("kicked")):3 with filledcurves closed fillstyle transparent solid 0.25 border linestyle 3 notitle, \
     "patch_areas.tsv" using (area("kicked")):(-1.24):(sprintf("%.2f m²/s", $2)) with labels textcolor linetype 3 notitle
set label 1 "after the drift" at 0.9, 0.33 center textcolor rgb "#0b6aa2"
plot "patch.tsv" using (of("kicked")):3 with lines linestyle 3 notitle, \
     "patch.tsv" using (of("stepped")):3 with filledcurves closed fillstyle transparent solid 0.35 border linestyle 1 notitle, \
     "patch.tsv" using (of("explicit")):3 with lines linestyle 2 notitle, \
     "patch_areas.tsv" using (area("stepped")):(0.1):(sprintf("%.2f m²/s", $2)) with labels textcolor rgb "#0b6aa2" notitle, \
     "patch_areas.tsv" using (area("explicit")):(-1.24):(sprintf("explicit: %.2f", $2)) with labels textcolor linetype 2 notitle
unset multiplot
