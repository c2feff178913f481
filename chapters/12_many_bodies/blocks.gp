@drawing 480,500
set title "The cache holds two blocks: block by block, each is fetched once"
unset border; unset tics; unset grid; unset key
set lmargin 0; set rmargin 0; set bmargin at screen 0.01; set tmargin at screen 0.92
set xrange [0:480]
set yrange [0:455]
passes = 4; blocks = 6
left(block) = 84 + 66 * (block - 1)
# Where a panel begins, and the place of a visit in its order. What is fetched from memory has a thick edge.
array foot[2] = [245, 8]
array head[2] = ["one pass after another", "one block after another"]
array fetches[2] = [passes * blocks, blocks]
visit(panel, pass, block) = panel == 1 ? (pass - 1) * blocks + block : (block - 1) * passes + pass
is_fetched(panel, pass) = panel == 1 || pass == 1
do for [panel = 1:2] {
  set label sprintf("%s", head[panel]) at left(1), foot[panel] + 190 left
  set label sprintf("%d fetches from memory", fetches[panel]) at left(blocks + 1), foot[panel] + 190 right textcolor rgb "#c2500a"
  do for [pass = 1:passes] {
    low = foot[panel] + 36 * (passes - pass)
    set label sprintf("pass %d", pass) at 76, low + 15 right textcolor rgb "#555555"
    do for [block = 1:blocks] {
      if (is_fetched(panel, pass)) {
        set object rect from left(block) + 4, low + 2 to left(block) + 62, low + 28 fillstyle empty border linecolor rgb "#c2500a" linewidth 3
        set label sprintf("%d", visit(panel, pass, block)) at left(block) + 33, low + 15 center textcolor rgb "#c2500a"
      } else {
        set object rect from left(block) + 4, low + 2 to left(block) + 62, low + 28 fillcolor rgb "#eef3f6" fillstyle solid border linecolor rgb "#b9c2c9" linewidth 1
        set label sprintf("%d", visit(panel, pass, block)) at left(block) + 33, low + 15 center
      }
    }
  }
  do for [block = 1:blocks] { set label sprintf("block %d", block) at left(block) + 33, foot[panel] + 160 center textcolor rgb "#555555" }
}
plot NaN notitle
