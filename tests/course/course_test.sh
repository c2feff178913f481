#!/usr/bin/env bash
# course_test.sh SOURCE SCRATCH: what ./course answers, on systems that lack things. Nothing outside SCRATCH is touched:
# its PATH holds a few tools that only read and write text, and stand-ins for everything else.
# shellcheck disable=SC2016  # what stands in single quotes belongs to the stand-ins
set -u
source=$1
scratch=$2
# shellcheck source=tests/verify.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/../verify.sh"

rm -rf "$scratch"
mkdir -p "$scratch/tree/chapters/01_force" "$scratch/tree/chapters/02_torque" "$scratch/bin"
cp -R "$source/course" "$source/tools" "$scratch/tree"
for tool in bash awk basename cat date dirname env find getconf grep mkdir readlink rm sed tail tee touch wc; do
  ln -s "$(command -v $tool)" "$scratch/bin/$tool"
done
# The system that the copy believes to run on.
sed -i.bak "s|^system_file=.*|system_file='$scratch/os-release'|" "$scratch/tree/tools/packages.sh"

# And the memory that it believes to have.
sed -i.bak "s|^memory_file=.*|memory_file='$scratch/meminfo'|; s|^memory_limit_file=[^ ]*|memory_limit_file='$scratch/limit'|" \
  "$scratch/tree/tools/build.sh"

# stand_in NAME: a program that does what its standard input says.
stand_in() {
  { echo '#!/usr/bin/env bash' && cat; } >"$scratch/bin/$1"
  chmod +x "$scratch/bin/$1"
}

# stand_in_python COMMAND: that runs what is to end with the shell as the tool for it does, and does the command for any other tool.
stand_in_python() {
  stand_in python3 <<<"[[ \${3-} != */kept.py ]] || exec \"\${@:5}\"; $1"
}

fresh() { # SYSTEM VERSION: a machine with apt and no package
  printf 'ID=%s\nVERSION_ID="%s"\n' "$1" "$2" >"$scratch/os-release"
  rm -rf "$scratch/tree/build" "$scratch/called"
  rm -f "$scratch"/bin/{sudo,g++,cmake}
  stand_in id <<<'echo 0'
  stand_in dpkg-query <<<'exit 1'
  stand_in apt-get <<<'echo "apt-get $*" >>"$CALLED"'
  stand_in cmake <<<'echo "cmake $*" >>"$CALLED"; cd build
    mkdir -p default/{checks,programs/simulate,programs/advise,costs/bench}; cd ..
    for program in 01_force_checks 01_force.force; do
      printf "#!/usr/bin/env bash\necho checked\nexit ${CHECKS:-0}\n" >build/default/checks/$program
      chmod() { "$CHMOD" "$@"; }; chmod +x build/default/checks/$program
    done
    for program in simulate/simulate advise/advise; do
      printf "%s\n" "#!/usr/bin/env bash" "echo \$PWD \"\${@@Q}\"" "exit 130" >build/default/programs/$program
      chmod +x build/default/programs/$program
    done
    bench=build/default/costs/bench/many_bodies_bench
    printf "%s\n" "#!/usr/bin/env bash" "echo Running; echo ns per body and step; echo \$@" >$bench
    chmod +x $bench'
}

course() { # ARGUMENT...: what it printed as `output`, what it called as `called`, and `code`
  output=$(cd "${caller:-/}" && CALLED=$scratch/called CHMOD=$(command -v chmod) CHECKS=${checks:-0} PATH=$scratch/bin \
    "$scratch/tree/course" "$@" 2>&1 </dev/null)
  code=$?
  called=$(cat "$scratch/called" 2>/dev/null)
  errors="it called $called"
}

called() { [[ $called == *"$1"* ]]; }
called_nothing() { [ -z "$called" ]; }

fresh debian 12
course
verify "alone it prints a menu of six lines" [ "$(wc -l <<<"$output")" -eq 6 ]
course chekc
verify "the nearest command is offered" answers 2 "Did you mean check?"
course check fource
verify "the nearest chapter is offered" answers 2 "Did you mean force?"
verify "the chapters are listed" says "02_torque"
course check
verify "a missing chapter is asked for" says "which chapter?"
course book --pfd
verify "the nearest option is offered" says "Did you mean --pdf?"
for words in "bench extra" "book 01" "test 01" "run 01 --pdf" "check 01 --all" "book --show" "run 01 02" "run 01 --hepl" "book --shard 1/2" \
  "book --full --shard" "book --full --shard 1/2 --pdf" "book merge" "book merge --resume a.part" "test --shard 1/2"; do
  # shellcheck disable=SC2086  # a list of words
  course $words
  verify "$words is refused" ends_with 2
done
verify "no mistake of the reader's starts anything" called_nothing
mkdir "$scratch/links"
ln -s "$scratch/tree/course" "$scratch/links/absolute"
ln -s ../links/absolute "$scratch/links/course"
output=$(cd / && PATH=$scratch/bin "$scratch/links/course" check fource 2>&1 </dev/null) code=$?
verify "a link to it finds the course" says "02_torque"

mkdir -p "$scratch/tree/chapters/01_force/tumble"
touch "$scratch/tree/chapters/01_force/tumble/force.hpp"
for word in 1 01 force 01_force chapters/01_force/ /a/b/chapters/01_force/tumble/force.hpp; do
  course check $word
  verify "check understands $word" says "The checks of 01_force hold."
done
course check chapters/01_force/tumble/fource.hpp
verify "a file that is not there is no file to check" answers 2 "Did you mean force.hpp?"
touch "$scratch/tree/chapters/01_force/force_checks.cpp"
for word in chapters/01_force/tumble/force.hpp /a/b/chapters/01_force/force_checks.cpp; do
  course check $word
  verify "check $word compiles the checks of that file alone" called "--target 01_force.force"
  verify "and says so" says "The checks of 01_force/force hold."
  rm "$scratch/called"
done
checks=3 course check 1
verify "a failed check ends with an error" ends_with 2

mkdir -p "$scratch/tree/exercises/01_force/moon" "$scratch/tree/work"
touch "$scratch/tree/exercises/01_force/moon/exercise.json"
stand_in_python 'echo "python3 ${*@Q}"; exit 7'
for word in moon 01_force/moon work/01_force/moon/moon.hpp /a/b/work/01_force/moon/moon.hpp; do
  course check "$word"
  verify "check takes $word for the exercise" says "toolchain.json' 'check' '$word'"
done
verify "and ends as its verdict does" ends_with 7
course check moon --show
verify "and passes --show on" says "'check' 'moon' '--show'"
course check moom
verify "the nearest exercise is offered too" says "Did you mean moon?"
course check
verify "without an exercise in hand, check asks for a chapter" says "which chapter?"
touch "$scratch/tree/work/progress.txt"
course check
verify "with one in hand, check is about that" says "toolchain.json' 'check'"
for command in start watch hint next progress reset compare; do
  course $command moon --key "a b"
  verify "$command gives its words to the students' tool" says "'$command' 'moon' '--key' 'a b'"
done
course grade "a class/ada" --format json
verify "grade gives its words to its own tool" says "grade.py' '--root'"
verify "and all of them" says "'a class/ada' '--format' 'json'"
mkdir -p "$scratch/class/--no-install"
caller=$scratch/class course grade ada --no-install
verify "and a student's folder that is called as an option is" says "'ada' '--no-install'"
rm "$scratch/called"
course hint moon
verify "what needs no compiler configures nothing" called_nothing
course grade merge "a part"
verify "merging configures nothing" called_nothing
verify "and gives its words to grade" says "'merge' 'a part'"
verify "no variable of the caller's changes what Python imports" says "python3 '-E' '-B'"
rm -r "$scratch/tree/exercises" "$scratch/tree/work" "$scratch/bin/python3"

course simulate "a scene.json" --csv "a file.csv" --no-install --all
verify "simulate gives its options to the simulator, in the caller's folder" \
  says "/ 'a scene.json' '--csv' 'a file.csv' '--all'"
verify "and ends as it does" ends_with 130
verify "simulate compiles the simulator alone" called "--target simulate"
(CALLED=$scratch/called CHMOD=$(command -v chmod) PATH=$scratch/bin "$scratch/tree/course" simulate t_handle --no-install <&- >&- 2>&-)
code=$? output="" errors="with everything closed"
verify "whose exit code it has also where neither a word nor a complaint can be written" ends_with 130
course simulate t_handle --live page.html --no-install
verify "and for a page that computes, its engine" called "--target simulate live_figure_scene"
stand_in_python 'echo "python3 $PWD ${*@Q}"; exit 7'
course sweep "a sweep.json" --shard 3/16 --no-install
verify "sweep gives its options to its tool, in the caller's folder" says "python3 / "
verify "and all of them" answers 7 "programs/simulate/simulate' 'a sweep.json' '--shard' '3/16'"
course book --full --shard 3/16 --part "a part" --resume --no-install
verify "a share of the measurements is measured in the caller's folder" says "python3 / "
verify "with its options" answers 7 "default/long_programs.json' '--shard=3/16' '--part=a part' '--resume'"
verify "and makes no book" says_not "Set the book"
course book merge "a part" b.part --no-install
verify "parts are put together" answers 1 "default/measured' '--merge' 'a part' 'b.part'"
stand_in_python 'exit 0'
course book merge a.part b.part --no-install
verify "the book is set from what they make" called "-DTUMBLE_FULL=ON -DTUMBLE_MEASURED:PATH=$scratch/tree/build/default/measured"
course book --no-install
verify "and the next one measures for itself" called "-DTUMBLE_FULL=OFF -DTUMBLE_MEASURED:PATH= "
rm "$scratch/bin/python3"
course advise --spin -1,2,3 --json --no-install
verify "advise gives its options to the adviser" answers 130 "/ '--spin' '-1,2,3' '--json'"
verify "advise compiles the adviser alone" called "--target advise"
verify "advise needs cxxopts" says "libcxxopts-dev"

fresh debian 12
course bench
verify "bench installs the libraries that it compares with" called "libbullet-dev libode-dev"
verify "bench compiles the benchmark alone" called "--target many_bodies_bench"
verify "bench measures the full set and shows its tables" says $'ns per body and step\n--full build/bench'
verify "and nothing before them" [ "${output/Running/}" = "$output" ]
verify "bench names the log" says "log: build/log/bench.txt"

fresh debian 12
for tool in cmp ls mv paste sort tr uniq; do ln -s "$(command -v $tool)" "$scratch/bin/$tool"; done
stand_in git <<<'case "$*" in "rev-parse HEAD") echo 0123abcd ;; status*) [ -z "${DIRTY-}" ] || echo "M course" ;; esac'
stand_in ctest <<<'echo "ctest $*" >>"$CALLED"; [[ $* != *-N* ]] || printf "  Test #%s\n" "1: build.races" "2: book.browser.dark"
  [ -z "${RED-}" ] || [[ $* = *-N* ]] || exit 8; echo "1/2 Test #1: build.races ......   Passed   12.50 sec"'
stand_in_python 'echo "python3 $*" >>"$CALLED"; exit 0'
mkdir -p "$scratch/tree/tests" "$scratch/tree/build/clang/tests/scenes"
for stood_for in tests/try_compilers build/clang/tests/scenes/fuzz_scene; do
  cp "$scratch/bin/git" "$scratch/tree/$stood_for"
done
course test --no-install
verify "test runs the quick tests" called "--label-exclude ^(slow|in_book)$"
verify "and without --all no others" [ "${called/--label-regex/}" = "$called" ]
verify "whose book goes without the bench" called "-DTUMBLE_BENCH=OFF"
course test --all races --no-install
verify "--all WORD runs the slow tests whose name holds it" called "--tests-regex ^(build\\.races)\$"
verify "and tells the time of each" says "12.5 s  Passed: build.races"
verify "and nothing else" says_not "sanitizers"
course test --all nothing --no-install
verify "a word that no slow test's name holds is refused" answers 2 "build.races book.browser.dark layout sanitizers tidy"
DIRTY=yes course test --exhaustive --no-install
verify "an exhaustive run is one of a commit" says "commit first what has changed"
RED=yes course test --exhaustive --no-install
verify "one that finds something writes nothing" [ ! -e "$scratch/tree/tests/exhaustive.txt" ]
course test --exhaustive --no-install
verify "one that holds names its commit" [ "$(cut -d' ' -f1 "$scratch/tree/tests/exhaustive.txt" 2>/dev/null)" = 0123abcd ]
verify "and has tried every mutant" called "tests/mutations/mutations.py build/default --jobs"
rm -r "$scratch/tree/tests" "$scratch/bin/python3" "$scratch"/bin/{git,ctest}

fresh debian 12
course bits ARM64
verify "bits installs compilers for other machines" called "g++-aarch64-linux-gnu"
verify "and one word chooses among them" says "Compiled and compared for every machine"

fresh debian 12
course check 1
verify "the administrator gets what is missing" called "install -y --no-install-recommends g++ make"
verify "check needs nothing of the book" [ "${called/doxygen/}" = "$called" ]
verify "and nothing of scene files" [ "${called/nlohmann/}" = "$called" ]
verify "the lists are fetched before" called "apt-get update"
verify "the work goes on after the installation" ends_with 0

fresh debian 12
stand_in dpkg-query <<<'for package in "${@:4}"; do echo -n "installed:$package "; done'
course check 1
verify "where nothing is missing, apt is left alone" [ "${called/apt-get/}" = "$called" ]

fresh debian 12
stand_in id <<<'echo 1000'
course book
verify "without rights it ends with an error" answers 2 "sudo apt-get install --no-install-recommends g++ make"
verify "without rights nothing is started" called_nothing
stand_in sudo <<<'exit 1'
course book
verify "a sudo that would ask for a password nobody can give is no right" says "The one command"
stand_in sudo <<<'while [[ ${1-} == -* ]]; do shift; done; [ $# -eq 0 ] || "$@"'
course check 1
verify "a sudo that works is used" called "install -y"

fresh debian 12
course check 1 --no-install
verify "--no-install says what is missing" says "not installed because of --no-install: g++ make"
verify "--no-install installs nothing" [ "${called/apt-get/}" = "$called" ]
verify "--no-install goes on" called "cmake --build"

if command -v flock >/dev/null; then
  fresh debian 12
  for tool in flock rmdir sleep; do ln -s "$(command -v $tool)" "$scratch/bin/$tool"; done
  stand_in cmake <<<'mkdir "$CALLED.at_work" || echo "two at once" >>"$CALLED"; sleep 0.3; rmdir "$CALLED.at_work"; exit 1'
  (course check 1) &
  course check 1
  wait
  verify "two first checks at once configure one after the other" [ "${called/two at once/}" = "$called" ]
fi

fresh debian 12
rm "$scratch/bin/getconf"
stand_in getconf <<<'echo 8'
for case in "12500000:max:8" "2500000:max:2" "300000:max:1" "12500000:3221225472:3" "::8"; do
  IFS=: read -r memory limit jobs <<<"$case"
  rm -f "$scratch/called" "$scratch/meminfo" "$scratch/limit"
  [ -z "$memory" ] || printf 'MemFree:  1 kB\nMemAvailable:   %s kB\n' "$memory" >"$scratch/meminfo"
  [ -z "$limit" ] || echo "$limit" >"$scratch/limit"
  course check 1
  verify "with 8 cores, ${memory:-an unknown number of} kB free and a limit of ${limit:-none}, $jobs compile at a time" \
    called "--parallel $jobs --"
done

fresh ubuntu 22.04
course check 1
verify "an Ubuntu before 24.04 is not touched" [ "${called/apt-get/}" = "$called" ]
verify "and is told so" says "nothing is installed here"
fresh ubuntu 24.04
course book --pdf
verify "Ubuntu 24.04 gets its packages" called "doxygen"
verify "but not its Chromium" [ "${called/chromium/}" = "$called" ]
fresh debian 11
course check 1
verify "a Debian before 12 is not touched" [ "${called/apt-get/}" = "$called" ]

fresh debian 12
stand_in apt-get <<<'echo "E: Unable to locate package"; exit 100'
course check 1
verify "a failed installation ends with an error" answers 1 "E: Unable to locate package"

fresh debian 12
stand_in cmake <<<'echo "one line of many"; echo "force.hpp:3:1: error: expected a semicolon"; exit 1'
course check 1
verify "a failed compilation ends with an error" answers 1 "error: expected a semicolon"
verify "and nothing of what went well" [ "${output/one line of many/}" = "$output" ]
verify "and names the log" says "build/log/check.txt"

[ "$failures" -eq 0 ]
