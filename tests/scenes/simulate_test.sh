#!/usr/bin/env bash
# simulate_test.sh SIMULATE SCRATCH: what the program simulate answers to every option, to mistakes and to Ctrl-C.
set -u
# Whoever started this may ignore signals, as nohup does; what they end is tried here.
[ -n "${SIGNALS_AS_USUAL-}" ] || SIGNALS_AS_USUAL=yes exec env --default-signal=INT,HUP,TERM,PIPE bash "$0" "$@"
program=$1
scratch=$2
# shellcheck source=tests/verify.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/../verify.sh"
count=0

rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch" || exit 1

lines() { [ "$(wc -l <"$1")" -eq "$2" ]; }
leaves_nothing() { [ -z "$(ls -A)" ]; }
same_numbers() { cmp -s "$1" "$2"; }
different_numbers() { ! cmp -s "$1" "$2"; }

# What it prints.
run t_handle --plan
verify "--plan prints the plan" answers 0 "tumbling: splitting"
verify "--plan takes no step" says_not "steps per second"
run rain --plan --csv nowhere/rain.csv --view rain.html
verify "and begins no output, be it where nothing can be written or a page that would be too large" ends_with 0
run everything --check-plan --until 0.2
verify "--check-plan goes as far as it is asked to" answers 0 "48 steps by plan"
verify "--check-plan prints the plan" says "tumbling: splitting"
verify "--check-plan finds no difference" says "every number of every motion is the same"
run t_handle --check-plan --precision float --method splitting_without_sine --until 0.2
verify "nor in float by another method" says "every number of every motion is the same"
verify "which it takes" says "tumbling: splitting without sine"
# The rule turns this orientation, although it is at rest, until it finds one that it leaves as it is. And the step is too long for the spring.
cat >rest.json <<'SCENE'
{"duration": 0.1, "turning_method": "splitting_without_sine",
 "bodies": [{"name": "box", "mass": 1, "inertia": [1, 2, 2.5], "orientation": [0.1, 0.5, 0.7, 0.5]}],
 "effects": [{"kind": "spring", "bodies": ["box"], "stiffness": 1e6, "anchor": [0, 0, 0]}]}
SCENE
run rest.json --check-plan
verify "nor where the rule turns what is at rest" diff <(tail -1 <<<"$output") - <<'SAID'
6 steps by plan, and as many with nothing known of any body: every number of every motion is the same
SAID
verify "and a warning is that of the plan alone" [ "$errors$(grep -c ^warning: <<<"$output")" = 1 ]
for only in --plan=false --plan; do
  run rest.json "$only"
  verify "as where the scene is run, or only its plan is asked for" [ "$errors$(grep -c ^warning: <<<"$output")" = 1 ]
done
rm rest.json
for option in csv jsonl plot view live books; do
  run t_handle --check-plan "--$option" file
  verify "--check-plan writes no file of --$option" fails 2 "--check-plan compares two runs and writes no files; --$option can't go with it"
done
run t_handle --until 0.1
verify "it simulates until the time that is asked for" says "1 body, 24 steps of 0.00416667 s, in double"
verify "it tells the steps per second" says "steps per second"
verify "it prints the books" says "unexplained"
verify "without a terminal it tells calmly how far it is" says " 50 %: step 12 of 24"
verify "and draws no bar" says_not "["
run t_handle --until 0.1 --dt 0.01
verify "after the first step that completes a quarter, where steps are no multiple of four" diff <(grep '%:' <<<"$output") - <<'SAID'
 30 %: step 3 of 10
 50 %: step 5 of 10
 80 %: step 8 of 10
100 %: step 10 of 10
SAID
cat >fall.json <<'SCENE'
{"title": "Fall", "description": "A stone.", "duration": 9, "bodies": [{"name": "stone", "mass": 2, "velocity": [1, 0, 0]}],
 "effects": [{"kind": "gravity", "acceleration": [0, 0, -8]}]}
SCENE
run fall.json --dt 0.125 --until 1.06 --bill --csv f.csv --jsonl f.jsonl --view f.html --books f.json
verify "it prints all this, with the plan and the books" diff - <(sed -E "s#$PWD/##; /^effect  +phase/,/^order/d; /^ +energy/,/^no effect takes/d
  s/in [^ ]+ s: [^ ]+ steps/in N s: N steps/; s/ ([0-9]{1,2}\.[0-9]|[0-9]{3,}) +[0-9.]+ %$/N  N %/; s/ ([0-9]{1,2}\.[0-9]|[0-9]{3,}) +$/N/
  /N/s/ +/ /g" <<<"$output") <<'SAID'
Fall
A stone.

a time step of 0.125 s is taken as 125000000 ns
1.06 s are no whole number of steps: the last one ends at 1 s
1 body, 8 steps of 0.125 s, in double


 25 %: step 2 of 8
 50 %: step 4 of 8
 75 %: step 6 of 8
100 %: step 8 of 8
8 steps in N s: N steps per second


effect                            bodies  ns per body and step    part of the step
memory of centres 1 N N %
gravity 1 N N %
kick 1 N N %
drift 1 N N %
guard of centres 1 N N %
a whole step 1 N
wrote f.csv
wrote f.jsonl
wrote f.html
wrote f.json
SAID
verify "and the books of it" diff - f.json <<'BOOKS'
{"bodies":1,"turning_method":"splitting","scheme":"semi-implicit Euler","steps":8,"time_step":0.125,"time":1,"stored_at_the_start":0,"stored_now":-72,
"at_the_start":{"energy":1,"momentum":[2,0,0],"angular_momentum":[0,0,0]},
"effects":[
{"name":"gravity","energy":64,"momentum":[0,0,-16],"angular_momentum":[0,7,0]},
{"name":"drift","energy":0,"momentum":[0,0,0],"angular_momentum":[0,0,0]}],
"now":{"energy":65,"momentum":[2,0,-16],"angular_momentum":[0,7,0]},
"unexplained":{"energy":0,"momentum":[0,0,0],"angular_momentum":[0,0,0]}}
BOOKS
rm f.* fall.json
# A comet that falls from rest far away, past a point with G M = 1 at the distance 1, which needs steps of a quarter of a second.
cat >comet.json <<'SCENE'
{"duration": 70, "step": {"per_second": 1}, "effects": [{"kind": "point_gravity", "strength": 1}], "bodies": [
  {"name": "comet", "mass": 1, "position": [18, 0, 0], "velocity": [-0.32394177, 0.078567420, 0]}, {"name": "moon", "mass": 1, "position": [0, 9, 0], "velocity": [0.33333333, 0, 0]}]}
SCENE
run comet.json --until 30
verify "a body that is far from a point that attracts gets no warning" says_not "warning"
run comet.json
verify "with the distance and the remedy" says "warning: at 36 s 'comet' is too close to the centre of 'point gravity' for steps of 1 s: it passes at 1.05 m, and its energy may change for good. That passage takes steps of 0.23 s or less"
verify "and once" [ "$(grep -c '^warning:' <<<"$output")" = 1 ]
run comet.json --until 50 --dt 0.23
verify "which is one" says_not "warning"
run comet.json --until 50 --precision float --no-ledger --scheme suzuki
verify "in float too, by any scheme, and without books" says "'comet' is too close"
run comet.json --plan --dt 100
verify "the plan tells of one that is too close from the start" grep -q "^warning: at 0 s 'comet' is too close" <<<"$output"
run comet.json --dt 10 --until 90
verify "and the end of the run how many there were" grep -q "^warning: 2 bodies came too close to a point that attracts; at 10 s 'comet' is too close" <<<"$output"
rm comet.json
run t_handle --until 0.1 --no-ledger
verify "--no-ledger leaves the books out" says_not "unexplained"
run t_handle --until 0.1 --no-ledger=false --plan=false --bill=false --help=false
verify "a switch that is false is off" says "unexplained"
verify "and so are the others" says_not "ns per body and step"
run t_handle --plan=true
verify "a switch that is true is on" says_not "steps per second"
run t_handle --plan=perhaps
verify "a switch is nothing else" ends_with 2
run t_handle --until 0.1 --bill
verify "--bill measures each effect" says "ns per body and step"
printf '{"duration": 0.1, "bodies": [{"name": "a", "mass": 1}, {"name": "b", "mass": 1}, {"name": "c", "mass": 1}],
  "effects": [{"kind": "gravity", "acceleration": [0, 0, -9], "bodies": ["a", "c"]}]}' >billed.json
run billed.json --bill
verify "which it counts" says "3 bodies, "
verify "for the bodies that it visits" grep -Eq '^gravity +2 ' <<<"$output"
verify "and a whole step for all" grep -Eq '^a whole step +3 ' <<<"$output"
rm billed.json
run t_handle --until 1 --dt 0.0166666666666
verify "--dt says how it is rounded" says "0.0166666666666 s is taken as 16666667 ns"
verify "--dt changes the steps" says "60 steps of 0.0166667 s"
run t_handle --plan --dt 0.0166666666666
verify "which is said where there is only a plan, too" says "0.0166666666666 s is taken as 16666667 ns"
run t_handle --until 0.1 --method axis_by_axis
verify "--method changes the rule" says "tumbling: axis by axis"
run t_handle --until 0.1 --method splitting_kahan_li_8
verify "--method knows the rungs of chapter 13" says "tumbling: splitting, Kahan-Li 8"
turning() { # METHOD: a scene that names it
  printf '{"title": "box", "description": "tumbles", "duration": 0.1, "turning_method": "%s", "bodies": [{"name": "box",
    "mass": 1, "inertia": [1, 2, 2.5], "angular_velocity": [1, 2, 0.5]}]}' "$1" >turning.json
}
turning splitting_yoshida
run turning.json
verify "and so does a scene" says "tumbling: splitting, Yoshida"
run turning.json --method steady
verify "--method overrules the scene" says "tumbling: steady"
turning dormand_prince_8
run turning.json
verify "a rung that worlds do not offer is refused" complains '/turning_method is "dormand_prince_8"; no method has that name'
rm turning.json
run t_handle --dt 3 --until 10
verify "a time that is no whole number of steps is told" says "10 s are no whole number of steps: the last one ends at 9 s"
run t_handle --until 0.1
verify "and one that is one is not" says_not "whole number of steps"
run t_handle --dt 3 --until 11
verify "the end is the nearest one, which may be a later one" says "the last one ends at 12 s"
run t_handle --dt 3 --until 2
verify "or the first one" says "the last one ends at 3 s"
run t_handle --plan --scheme verlet
verify "--scheme changes the order" says "order 2: Verlet"
run t_handle --plan --until 1e9
verify "it may be asked for 1e9 s" says "240000000000 steps"
run rain --plan --seed 9007199254740992 --every 9223372036854775807 --dt 1e-6
verify "and for the largest seed, the most seldom record and the shortest step" says "steps of 1e-06 s"
run t_handle --until 0.1 --precision float
verify "--precision float is said" says "in float"
run --help
verify "--help tells the options" answers 0 "--csv FILE"
verify "nothing of this leaves a file" leaves_nothing

# Files.
run everything --until 0.1 --csv all.csv --jsonl all.jsonl --view all.html
verify "CSV has a line for each body and moment, and one of names" lines all.csv $((25 * 37 + 1))
verify "each copy has its own name there" grep -q '^0,dust 20,' all.csv
verify "JSON Lines have one for each body and moment" lines all.jsonl $((25 * 37))
verify "a view is one page with the player in it" grep -q 'class="player-recording"' all.html
verify "and asks for nothing from outside" bash -c '! grep -Eq "(src|href)=\"?(http|//)" all.html'
verify "whose camera stays where it is" bash -c '! grep -q "\"follow\":" all.html'
run orbit --until 9 --view all.html --follow craft
verify "or goes with a body" grep -q '"follow":1,"bodies":.*"name":"station",.*"name":"craft"' all.html
run everything --until 0.1 --view all.html --follow "dust 3"
verify "which may be a copy" grep -q '"follow":[1-9]' all.html
if command -v gnuplot >/dev/null 2>&1; then
  run tethered_box --until 0.5 --plot box.svg
  verify "--plot draws" grep -q '</svg>' box.svg
  verify "with the energies" grep -q 'kinetic' box.svg
  verify "and says what goes upwards" [ "$(sed -n '/rotate(/{n;s/<[^>]*>//g;p}' box.svg | xargs)" = "z (m) energy (J)" ]
  verify "and what to the right" [ "$(sed '/rotate(/,+1d; s/<[^>]*>//g' box.svg | grep -o '[a-z]* ([a-zA-Z])' | xargs)" = "x (m) time (s)" ]
fi
run t_handle --until 0.1 --csv every.csv --every 10
verify "--every records each tenth step, the first and the last moment" lines every.csv 5
verify "the last moment is there" grep -q '^0.1,handle,' every.csv
run t_handle --until 0.1 --csv books.csv
run t_handle --until 0.1 --csv no_books.csv --no-ledger
verify "the books change no number" same_numbers books.csv no_books.csv
run rain --until 0.1 --csv one.csv --threads 1 --no-ledger --every 6
run rain --until 0.1 --csv two.csv --threads 2 --no-ledger --every 6
verify "the number of threads changes no number" same_numbers one.csv two.csv
cat >name.json <<'SCENE'
{"title": "", "description": "", "duration": 0.05, "bodies": [{"name": "a \"b\", c", "mass": 1}, {"name": "two\nlines", "mass": 1},
  {"name": "5\" rod", "mass": 1}, {"name": "left, right", "mass": 1}, {"name": "a; b'\\", "mass": 1}]}
SCENE
run ./name.json --csv name.csv --jsonl name.jsonl
verify "a name with commas and quotes is one cell" grep -qF '0,"a ""b"", c",0,0,0,1,0,0,0,0' name.csv
verify "and so is one with the end of a line" grep -qx '0,"two' name.csv
verify "or with a quote alone" grep -qF '0,"5"" rod",0,0,0,1,0,0,0,0' name.csv
verify "or with a comma alone" grep -qF '0,"left, right",0,0,0,1,0,0,0,0' name.csv
verify "and one text of JSON" grep -qF '"body":"a \"b\", c"' name.jsonl
verify "a name with none of these stands in CSV as it is" grep -qF "0,a; b'\\,0,0,0,1,0,0,0,0" name.csv
printf '{"duration": 0.05, "bodies": [{"name": "a", "mass": 1}]}' >untitled.json
run untitled.json
verify "a scene runs without a title and a description" answers 0 $'untitled.json\n\n1 body, '
output=$("$program" /dev/stdin --plan <untitled.json)
code=$?
verify "what is redirected to it can be the scene" ends_with 0
for seed in 0 1 1; do run rain --until 0.02 --csv "seed$((++count)).csv" --seed $seed --no-ledger; done
run rain --until 0.02 --csv file.csv --no-ledger
verify "--seed 0 draws the random bodies as the file does" same_numbers seed1.csv file.csv
verify "another seed draws others" different_numbers seed2.csv file.csv
verify "and the same ones again" same_numbers seed2.csv seed3.csv
cat >seed.json <<'SCENE'
{"duration": 0.01, "bodies": [{"name": "a", "mass": 1, "many": {"count": 1, "seed": 1, "position_between": [[0, 0, 0], [1, 1, 1]]}}]}
SCENE
for seed in 0 4294967296 9007199254740992; do run seed.json --csv "large$seed.csv" --seed $seed; done
verify "and others for one that no 32 bits hold" different_numbers large4294967296.csv large0.csv
verify "up to the largest" different_numbers large9007199254740992.csv large0.csv
rm -f -- *.csv *.jsonl *.html *.svg *.json

# Mistakes: none leaves a file.
run
verify "without a scene it asks for one" complains "which scene?"
run t_handel
verify "an unknown scene gets the nearest" fails 2 "did you mean t_handle?"
run t_handle --pln
verify "an unknown option gets the nearest" fails 2 "there is no option --pln; did you mean --plan?"
while read -r option value complaint; do
  run t_handle "--$option" "$value" --csv never.csv
  verify "--$option $value is refused" fails 2 "$complaint"
done <<'CASES'
dt 0 --dt is 0 s; it must lie between 1e-6 and 3600 s
dt -1 --dt is -1 s; it must lie between 1e-6 and 3600 s
dt nan --dt is nan; it must be a number of seconds
dt 3601 --dt is 3601 s; it must lie between 1e-6 and 3600 s
dt 1e-7 --dt is 1e-7 s; it must lie between 1e-6 and 3600 s
dt 1s --dt is 1s; it must be a number of seconds
until 0 --until is 0 s; it must be greater than 0
until inf --until is inf; it must be a number of seconds
until 2e9 --until is 2e9 s; it must be greater than 0 and at most 1e9 s
until 1e-300 --until is 1e-300 s; that is less than half a step of 0.0041666
dt 3600 the scene lasts 10 s; that is less than half a step of 3600 s, and only whole steps are taken
seed -1 --seed is -1; it must be a whole number from 0 to 2^53
seed 9007199254740993 --seed is 9007199254740993; it must be a whole number from 0 to 2^53
seed 1 /bodies hold nothing random that a seed could change
every 0 --every is 0; it must be a whole number of steps, 1 or more
every 9223372036854775808 --every is 9223372036854775808; it must be a whole number of steps, 1 or more
every 1.5 --every is 1.5; it must be a whole number of steps, 1 or more
threads 0 --threads is 0; it must be from 1 to 1024
threads 1025 --threads is 1025; it must be from 1 to 1024
threads two --threads is two; it must be from 1 to 1024
method spliting no method is called spliting; did you mean splitting?
method splitting_kahan_li8 no method is called splitting_kahan_li8; did you mean splitting_kahan_li_8?
scheme verlt no scheme is called verlt; did you mean verlet?
precision half --precision is half; it must be float or double
CASES
run t_handle --scheme euler
verify "what is called otherwise is listed" complains "The schemes are: semi_implicit_euler, verlet, suzuki"
run t_handle --until 0.1 --no-ledger --books never.json
verify "books that are not kept are not written" fails 2 "--books writes the books that --no-ledger does not keep"
for option in csv jsonl plot view live books; do
  run t_handle "--$option" ""
  verify "an output without a name is refused" fails 2 "--$option needs the name of a file"
done
run t_handle --until 0.1 --view never.html --follow handles
verify "a body to follow that isn't there gets the nearest" fails 2 "--follow is handles; no body has that name; did you mean handle?"
run t_handle --until 0.1 --view never.html --follow ""
verify "or must have a name" fails 2 "--follow needs the name of a body"
run t_handle --until 0.1 --follow handle
verify "and without a page there is nothing that follows" fails 2 "--follow is for the page that --view writes"
run t_handle --dt
verify "an option without its value is refused" ends_with 2
run t_handle coin
verify "a second scene is refused" complains "one word too many: coin"
while read -r option value; do
  run t_handle --live page.html "--$option" ${value:+"$value"}
  verify "--live changes nothing of the scene and runs nothing: --$option is refused" fails 2 \
    "--live writes a page of the scene as its file has it and runs nothing; --$option can't go with it"
done <<'OPTIONS'
dt 0.01
until 1
method steady
scheme verlet
precision double
seed 0
threads 1
every 1
follow handle
csv page.csv
jsonl page.jsonl
plot page.svg
view view.html
books page.json
no-ledger
bill
plan
OPTIONS
run rain --live page.html
verify "nor does it write a page that nobody could wait for" fails 2 "the scene has 100000 bodies; a page that runs it by itself draws at most 2000"
run t_handle --live page.html
if ends_with 0; then
  verify "a page with the engine holds the scene" grep -q 'class="live-texts">{"scene":"{.u000a  ...schema.*"file":"t_handle.json"}' page.html
  verify "which is told" [ "$output" = "wrote $PWD/page.html" ]
  verify "and the engine" grep -q "tumble_live.modules.scene = 'AGFzbQ" page.html
  rm page.html
else
  verify "without the engine it says what is missing" fails 3 "the engine for pages was not built; that takes clang++ with Debian's packages"
fi
verify "and leaves no page" test ! -e page.html
printf '{"duration": 0.001, "bodies": [{"name": "a", "mass": 1}]}' >short.json
run short.json --live page.html
verify "no page is written of a scene that lasts no step" complains "the scene lasts 0.001 s; that is less than half a step"
rm -f short.json page.html
printf '{"duration": 10, "step": {"per_second": 200}, "bodies": [{"name": "a", "mass": 1, "many": {"count": 2000, "seed": 1}}]}' >crowd.json
run crowd.json --live page.html
verify "2000 bodies are not too many for a page" [ "$code" -ne 2 ]
run crowd.json --no-ledger --view page.html --every 1000
verify "nor are 2000 steps for a view of three moments" ends_with 0
run crowd.json --no-ledger --view page.html --every 2
verify "but 2000 bodies at 1001 moments are too many for one" complains "it would hold 2002000 poses"
rm -f crowd.json page.html
mkdir folder
while read -r path why; do
  run t_handle --until 0.1 --csv "$path"
  verify "$path can't be written" fails 3 "cannot write $path: $why"
done <<PATHS
folder it is a directory
nowhere/file.csv there is no directory $PWD/nowhere
/dev/null it is no regular file
/proc/no_such.csv $([ "$(id -u)" = 0 ] && echo No such file or directory || echo no permission)
PATHS
verify "/dev/null is still there" test -c /dev/null
if [ "$(id -u)" != 0 ]; then # whom nobody forbids anything
  echo before >read_only.csv
  chmod a-w read_only.csv
  run t_handle --until 0.1 --csv read_only.csv
  verify "what may not be written is told" fails 3 "cannot write read_only.csv: no permission"
  verify "and is as it was" [ "$(cat read_only.csv)" = before ]
  rm -f read_only.csv
fi
run t_handle --csv kept.csv --view nowhere/x.html
verify "if one file can't be written, the others are not touched" test ! -e kept.csv
rmdir folder
name=$(printf 'n%.0s' {1..300})
run t_handle --until 0.1 --csv "$name"
verify "a name of 300 letters is told" fails 3 "File name too long"
run "$name"
verify "and so is one of a scene" complains "no scene and no file is called"
ln -s loop loop
run t_handle --until 0.1 --csv loop
verify "a link that leads to itself is told" fails 3 "Too many levels of symbolic links"
rm loop

# No output goes where what is printed goes.
echo before >log.txt
for path in /dev/stdout /proc/self/fd/1 /dev/fd/1 log.txt /dev/stderr /proc/self/fd/7; do
  "$program" t_handle --until 0.1 --csv "$path" >>log.txt 2>>log.txt 7>>log.txt
  code=$? output=$(cat log.txt) errors=$output
  verify "$path is refused where something is printed" fails 3 "cannot write $path: it is open already"
  verify "and nothing is lost" [ "$(head -1 log.txt)" = before ]
  verify "nor simulated" says_not "steps per second"
  echo before >log.txt
done
rm log.txt

# One output that fails does not lose those after it.
mkdir programs tmp
while IFS=';' read -r ending expected complaint; do
  printf '#!/bin/sh\necho broken >&2\n%s\n' "$ending" >programs/gnuplot
  chmod +x programs/gnuplot
  path=$PWD/programs:$PATH TMPDIR=$PWD/tmp run t_handle --until 0.1 --csv a.csv --plot a.svg --view a.html --books a.json
  verify "where gnuplot ends with '$ending' it is told" fails "$expected" "a.svg: $complaint"
  verify "and all but the figure are there" [ "$(echo ./a*)" = "./a.csv ./a.html ./a.json" ]
  verify "and whole" grep -q '"unexplained"' a.json
  verify "and of what gnuplot should draw nothing is left" rmdir tmp
  mkdir tmp
  rm -f ./a.*
done <<'ENDINGS'
exit 1;3;gnuplot says: broken
exit 130;130;gnuplot was interrupted
kill -INT $PPID $$;130;gnuplot was interrupted
kill -TERM $PPID $$;3;gnuplot says: broken
ENDINGS
mkdir "it's"
path=$PWD/programs:$PATH TMPDIR=$PWD/it\'s run t_handle --until 0.1 --plot a.svg
verify "the folder for that may have any name" complains "a.svg: gnuplot says: broken"
rmdir "it's"
limit="-f 10" path=$PWD/programs:$PATH run t_handle --until 0.1 --csv a.csv --plot a.svg --view a.html
verify "of two outputs that can't be finished both are told" complains "a.html: the disk may be full"
verify "the first of them at the end" [ "$(tail -1 <<<"$errors" | sed 's/.*: //')" = broken ]
verify "and it ends with 3" ends_with 3
verify "and what could be finished is there" [ "$(echo ./a*)" = ./a.csv ]
rm a.csv
# A gnuplot that shows what has been told before it is called.
printf '#!/bin/sh\ncat "%s/told.txt" >&2; exit 1\n' "$PWD" >programs/gnuplot
PATH=$PWD/programs:$PATH "$program" t_handle --until 0.1 --plot a.svg >told.txt 2>errors.txt
code=$? output="" errors=$(cat errors.txt)
verify "how far it is can be read at once" complains "100 %: step 24 of 24"
rm -r programs tmp told.txt errors.txt

# No output goes over the scene or over another output, by whatever name.
printf '{"duration": 0.05, "bodies": [{"name": "a", "mass": 1}]}' >scene.json
cp scene.json kept.json
ln scene.json hard.json
ln -s scene.json soft.json
for path in scene.json ./scene.json hard.json soft.json "$PWD/scene.json"; do
  for option in csv jsonl plot view live books; do
    run scene.json "--$option" "$path"
    verify "--$option $path does not overwrite the scene" fails 2 "that is the scene itself"
  done
done
ln -s . linked
for other in ./a linked/a "$PWD/a"; do
  for two in "a|$other" "$other|a"; do
    run scene.json --csv "${two%|*}" --jsonl "${two#*|}"
    verify "two outputs into one file, ${two%|*} and ${two#*|}, are refused" fails 2 "--jsonl is ${two#*|}; that is where --csv goes, and each needs a file of its own"
  done
done
rm linked
ln -s scene.json link.json
run kept.json --view soft.json --books link.json
verify "and through two links too" complains "that is where --view goes"
verify "the scene is as it was" cmp -s scene.json kept.json
rm ./*.json

# What the system lacks is a sentence, and nothing is left.
if ! grep -q __asan_init "$program"; then # the address sanitizer needs terabytes of addresses
  limit="-v 60000" run rain --until 1 --csv rain.csv
  verify "too little memory is told" fails 4 "the memory does not suffice"
  limit="-v 400000" run t_handle --until 1 --csv handle.csv --threads 1024
  verify "too few threads are told" fails 4 "fewer --threads may do"
fi
limit="-f 10" run rain --until 1 --csv rain.csv
verify "a file beyond the limit of its size is told" complains "simulate: cannot write"
verify "at once where there is no other" says_not "steps per second"
verify "and ends with 3" ends_with 3
limit="-f 1" run t_handle --until 0.1 --csv short.csv --books books.json
verify "so is one that meets the limit with its last letters" fails 3 "short.csv: the disk may be full"
verify "and what could be written of it is gone" test ! -e short.csv
verify "and another one is there" grep -q '"unexplained"' books.json
rm books.json
limit="-f 10" run rain --until 0.1 --csv rain.csv --jsonl rain.jsonl --books books.json
for file in rain.csv rain.jsonl; do
  verify "$file, which is full while something is recorded, is given up" complains "$file is given up, and the other outputs go on"
done
verify "and each of them is given up once" [ "$(grep -c 'is given up' <<<"$errors")" = 2 ]
verify "the first of them is told at the end too" [ "${errors##*/}" = "rain.csv: the disk may be full" ]
verify "the run ends with 3" ends_with 3
verify "and the output that isn't full is there" grep -q '"unexplained"' books.json
rm books.json
"$program" t_handle --until 0.1 >/dev/full 2>errors.txt
code=$? errors=$(cat errors.txt) output=""
rm errors.txt
verify "if what is printed can't be written it says so" fails 3 "what is printed can't be written"
"$program" t_handle --plan >/dev/full 2>errors.txt
code=$? errors=$(cat errors.txt)
rm errors.txt
verify "even if nothing is printed after it" ends_with 3
run rain --view rain.html
verify "a page that would be too large is refused" complains "poses"
printf '{"duration": 1, "bodies": [{"name": "far", "mass": 1, "position": [1e40, 0, 0]}]}' >far.json
run far.json --view far.html
verify "and so is a place that it can't hold" fails 3 "a recording holds finite floats only"
run far.json --check-plan --precision float
verify "--check-plan in float refuses what float can't hold" ends_with 2
run far.json --check-plan
verify "which double can" ends_with 0
rm far.json
if command -v gnuplot >/dev/null 2>&1; then
  path=$PATH TMPDIR=/nowhere run t_handle --until 0.1 --plot t.svg
  verify "without a place for what gnuplot draws from it says so" fails 3 "there is no folder for temporary files"
  path=$PATH TMPDIR=/proc run t_handle --until 0.1 --plot t.svg
  verify "and so it does where none can be made" fails 3 "no folder for what gnuplot draws from"
fi
path=/nowhere run t_handle --plot t.svg
verify "without gnuplot it says so" complains "gnuplot draws it and is not installed"
verify "no mistake leaves a file" leaves_nothing
printf '{"title": "", "description": "",\n "duration": }' >bad.json
run bad.json
verify "a scene that is no JSON gets line and column" fails 2 "bad.json: line 2, column 14: not valid JSON"
rm bad.json

# A step that can't be taken: what was computed before is kept.
cat >crash.json <<'SCENE'
{"title": "Crash", "description": "A point falls into the centre: 2 m at 4 m/s and four steps in a second.", "duration": 9,
 "step": {"nanoseconds": 250000000}, "bodies": [{"name": "comet", "mass": 1, "position": [2, 0, 0], "velocity": [-4, 0, 0]}],
 "effects": [{"kind": "point_gravity", "strength": 1e-200}]}
SCENE
run crash.json --csv crash.csv
verify "a step that can't be taken ends with 1" answers 1 $'\n2 steps in '
verify "and names body and effect" complains "'comet' at 0.5 s (step 2): point gravity gives a force of"
verify "and keeps what was computed" lines crash.csv 4
verify "the books are printed" says "unexplained"
for every in 2 3; do
  run crash.json --csv crash.csv --every $every
  verify "with --every $every the last moment before it is kept, and kept once" lines crash.csv 3
done
verify "and it is the last one" grep -q '^0.5,comet,0,0,0,' crash.csv
sed 's/\[2, 0, 0\]/[0, 0, 0]/' crash.json >first.json
run first.json --csv first.csv --jsonl first.jsonl
verify "if the first step can't be taken it ends with 1 as well" ends_with 1
verify "and says so" complains "'comet' at 0 s (step 0): point gravity gives a force of"
verify "and the start is kept, and kept once" lines first.csv 2
verify "in JSON Lines too" lines first.jsonl 1
rm first.*
run crash.json --check-plan
verify "--check-plan tells of such a step once, and where both runs end" [ "$(grep -c "'comet' at 0.5 s" <<<"$output")" = 1 ]
verify "and that they agree until there" says "2 steps by plan, and as many with nothing known of any body"
run crash.json --bill
verify "of a run that could not be ended there is no bill" says_not "a whole step"
verify "and that is its only failure" ends_with 1
run crash.json --until 0.5 --bill
verify "a bill is that of the steps that were taken" answers 0 "a whole step"
sed 's/\[2, 0, 0\]/[3, 0, 0]/' crash.json >later.json
run later.json --until 0.75 --bill
verify "nor beyond three, which are no power of two" ends_with 0
rm crash.json later.json crash.csv

# Without a standard output nothing is printed, least of all into a file that is opened.
"$program" t_handle --until 0.1 --csv closed.csv >&- 2>&-
code=$? output="" errors=""
verify "closed outputs are no failure" ends_with 0
verify "and what is printed is not in the file" lines closed.csv 26
rm closed.csv
"$program" t_handle --until 0.1 --csv closed.csv 1</dev/null 2</dev/null
code=$?
verify "nor are those that a shell has left open for reading" ends_with 0
verify "and the file is whole" lines closed.csv 26
rm closed.csv

# A signal, sent once the simulation has told that it runs.
set -m
while read -r signal expected; do
  "$program" rain --until 1000 --csv rain.csv --every 1000000 --bill >told.txt 2>&1 &
  process=$!
  for ((i = 0; i < 300; ++i)); do
    ls rain.csv.partial-* >/dev/null 2>&1 && grep -q 'steps of' told.txt && break
    sleep 0.1
  done
  verify "what is simulated can be read at once" grep -q 'steps of' told.txt
  kill "-$signal" "$process"
  wait "$process"
  code=$?
  output=$(cat told.txt) errors=""
  verify "SIG$signal ends with $expected" ends_with "$expected"
  steps=$(sed -n 's/^\([0-9]*\) steps in .*/\1/p' <<<"$output")
  verify "it says how far it came" says "interrupted after $steps of 60000 steps"
  verify "and prints the books" says "unexplained"
  verify "and measures nothing more" says_not "ns per body and step"
  verify "the file holds the first and the last moment, whole" lines rain.csv 200001
  verify "and nothing else is left" [ "$(echo ./*)" = "./rain.csv ./told.txt" ]
  rm rain.csv
done <<'SIGNALS'
INT 130
TERM 143
HUP 129
SIGNALS
# Who ignores one, as nohup does, runs to the end.
rm told.txt
(trap '' HUP && exec "$program" t_handle --until 8000 --no-ledger >told.txt 2>&1) &
process=$!
until grep -qs 'steps of' told.txt || ! kill -0 "$process"; do sleep 0.02; done
kill -HUP "$process"
wait "$process"
code=$? output=$(cat told.txt)
verify "a SIGHUP that is ignored ends nothing" ends_with 0
rm told.txt

# The reader goes: with the next line that is printed the simulation ends.
"$program" rain --until 0.5 --csv rain.csv --every 1000000 --no-ledger 2>errors.txt | head -1 >/dev/null
code=${PIPESTATUS[0]} output="" errors=$(cat errors.txt)
rm errors.txt
verify "a reader who goes ends it with 141" ends_with 141
verify "without a word" [ -z "$errors" ]
verify "and the file is whole" lines rain.csv 200001
rm rain.csv
verify "nothing else is left" leaves_nothing

[ "$failures" -eq 0 ]
