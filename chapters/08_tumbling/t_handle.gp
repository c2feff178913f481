@drawing 630,280
set title "The spin about the shaft turns over, again and again"
set xlabel "time (s)"
set ylabel "rate (rad/s)"
set ytics 5
set yrange [-11:12]
unset key
set label 1 "A;\ndots: exact" at 12.3, 0 left textcolor linetype 1
set label 2 "B, without\nthe term" at 12.3, 10 left textcolor linetype 2
set rmargin 17
plot "t_handle.tsv" using 1:2 with lines linestyle 1, \
     "t_handle.tsv" using 1:3 every 12 with points pointtype 7 pointsize 0.3 linecolor rgb "#22303a", \
     "t_handle.tsv" using 1:4 with lines linestyle 2
