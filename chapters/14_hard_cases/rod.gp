@drawing 560,400
set title "Only the splittings keep a thin rod's energy"
set xlabel "time (s)"
set ylabel "energy / energy at the start"
set xrange [0:5]
set yrange [0:2.2]
set rmargin 17
unset key
plot for [i=2:5] "rod.tsv" using 1:i with lines linestyle i, \
     "" using 1:6 with lines linestyle 1, \
     for [i=2:4] "" using ($1 == 5 ? 5 : NaN):(column(i)):(columnhead(i)) with labels left offset 0.5,0 textcolor linetype i, \
     "" using ($1 == 5 ? 5 : NaN):6:("ours, by axes") with labels left offset 0.5,0 textcolor linetype 1
