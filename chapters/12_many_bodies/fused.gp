@drawing 480,250
set title "Three digits: 1.27² − 1.61 is 0 if it is rounded twice, and 0.0029 if once"
unset border; unset tics; unset grid; unset key
set lmargin 0; set rmargin 0; set bmargin at screen 0.01; set tmargin at screen 0.76
set xrange [1.5975:1.6325]
set yrange [0:187]
product = 1.27 * 1.27
rounded = floor(100 * product + 0.5) / 100.
set arrow from 1.5985, 62 to 1.6315, 62 nohead linecolor rgb "#555555"
do for [n = 160:163] {
  set arrow from n / 100., 54 to n / 100., 70 nohead linecolor rgb "#555555"
  set label sprintf("%.2f", n / 100.) at n / 100., 36 center
}
set label "the numbers of three digits" at 1.615, 12 center textcolor rgb "#555555"
set arrow from product, 74 to product, 118 nohead linetype 1 linewidth 1 dashtype (2,3)
set label sprintf("1.27² = %.4f", product) at product, 132 left textcolor linetype 1
set arrow from product, 92 to rounded + 0.0001, 92 head filled size screen 0.02, 20 linetype 2
set label "rounded" at rounded - 0.0004, 92 right textcolor linetype 2
set label "fusing keeps these 0.0029" at product + 0.0006, 92 left textcolor linetype 1
plot "+" using (product):(62) every 1000 notitle with points linetype 1 pointsize 1.4
