# shellcheck shell=bash disable=SC2154
# Configuring and building, whatever state the build folder was left in. Sourced by ../course, which sets root and log.

memory_file=/proc/meminfo
memory_limit_file=/sys/fs/cgroup/memory.max # a container's

# how_many_jobs: one for each core, but no more than fit into the free memory: most compilers need less than a gigabyte.
how_many_jobs() {
  local cores memory limit=""
  cores=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
  memory=$(sed -n 's/^MemAvailable: *\([0-9]*\) kB$/\1/p' "$memory_file" 2>/dev/null)
  read -r limit 2>/dev/null <"$memory_limit_file"
  [[ $limit =~ ^[0-9]+$ ]] && ((memory == 0 || limit / 1024 < memory)) && memory=$((limit / 1024))
  [ -z "$memory" ] || ((cores = memory / 1000000 < cores ? memory / 1000000 : cores))
  echo $((cores > 1 ? cores : 1))
}

# kept COMMAND...: runs it so that it ends, with all that it has started, when this shell ends, in whatever way; where Python is there.
kept() {
  if command -v python3 >/dev/null 2>&1; then python3 -E -B "$root/exercises/tools/kept.py" "$BASHPID" "$@"; else "$@"; fi
}

# writable FOLDER: makes it; where that can't be, or nothing can be written there, says so and ends.
writable() {
  local problem
  problem=$({ mkdir -p "$1" && : >"$1/.written" && rm "$1/.written"; } 2>&1) ||
    die "nothing can be written to $1: ${problem##*: }" \
      "Delete build if it is broken or another user's, free some space if the disk is full, or copy the course to a folder of your own."
}

# What the build was configured for: the compiler, and what the presets read from the environment.
asked_for() {
  local compiler=${CXX:-c++}
  case $1 in sanitize | clang) compiler=clang++ ;; esac
  printf '%s; warnings as errors: %s' "$("$compiler" --version 2>/dev/null | sed 1q)" "${TUMBLE_WARNINGS_AS_ERRORS-}"
}

# configure PRESET [NAME]: once, and again when packages have come or gone, the checkout has moved, the compiler is another
# one, or something that the build needs has been deleted.
configure() {
  local folder=$root/build/$1 wanted
  if [ -e "$folder" ] && ! [ -d "$folder" ]; then rm -f "$folder"; fi
  writable "$folder"
  [ ! -d "$folder/CMakeCache.txt" ] || start_afresh "$folder"
  wanted=$(asked_for "$1")
  if [ -f "$folder/CMakeCache.txt" ]; then
    grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt" || start_afresh "$folder"
    [ ! -f "$folder/configured" ] || [ "$(sed 's/;.*//' "$folder/configured")" = "${wanted%%;*}" ] || start_afresh "$folder"
  fi
  [ -f "$folder/CMakeCache.txt" ] && { [ -f "$folder/build.ninja" ] || [ -f "$folder/Makefile" ]; } &&
    [ "$(cat "$folder/configured" 2>/dev/null)" = "$wanted" ] &&
    ! [ /var/lib/dpkg/status -nt "$folder/configured" ] && return 0
  rm -f "$folder/configured"
  stage "Configured the ${2:-optimised build}" locked "$1" configure_or_heal "$1" && printf '%s\n' "$wanted" >"$folder/configured"
}

# What was compiled elsewhere or by another compiler is of no use.
start_afresh() {
  rm -rf "$1" 2>/dev/null
  writable "$1"
}

# locked PRESET COMMAND...: nobody else configures or builds there meanwhile; two at once spoil each other's precompiled headers.
locked() {
  {
    ! command -v flock >/dev/null 2>&1 || flock 9
    "${@:2}" 9>&-
  } 9>"build/$1.lock"
}

configure_or_heal() {
  local generator=()
  ! command -v ninja >/dev/null 2>&1 || generator=(-G Ninja)
  if [ -f "build/$1/CMakeCache.txt" ]; then
    kept cmake --preset "$1" && return
    echo "Once more, without what was found before."
  fi
  kept cmake --fresh --preset "$1" ${generator[@]+"${generator[@]}"}
}

# build PRESET SENTENCE TARGET...: the files of the build are mended where they turn out to be broken.
build() {
  stage "$2" locked "$1" build_or_heal "$1" "${@:3}"
}

# build_all PRESET SENTENCE TARGET...: goes on past what does not compile.
build_all() {
  keep_going=yes build "$@"
}

build_or_heal() {
  local preset=$1 begin options=()
  shift
  [ -z "${keep_going-}" ] || { options=(-- -k) && [ ! -f "build/$preset/build.ninja" ] || options=(-- -k 0); }
  begin=$(wc -l <"$log")
  kept cmake --build "build/$preset" --parallel "$jobs" --target "$@" ${options[@]+"${options[@]}"} && return
  is_broken "$begin" || return 1
  echo "The files of the build are damaged: making them anew."
  begin=$(wc -l <"$log")
  configure_or_heal "$preset" &&
    kept cmake --build "build/$preset" --parallel "$jobs" --target "$@" ${options[@]+"${options[@]}"} && return
  is_broken "$begin" && ! tail -n "+$begin" "$log" | grep -qE 'unknown target|No rule to make target' || return 1
  echo "That did not help: starting with an empty folder."
  rm -rf "build/$preset" && configure_or_heal "$preset" &&
    kept cmake --build "build/$preset" --parallel "$jobs" --target "$@" ${options[@]+"${options[@]}"}
}

# Whether the log says, after a line, that the build itself is broken, and not what it compiles.
is_broken() {
  tail -n "+$1" "$log" | grep -qE '^ninja: (error|fatal): |^CMake Error|could not load cache|^make[^:]*: \*\*\* (No |missing )|missing separator|^Error: .* is not a directory'
}

run_tests() { # PRESET SENTENCE CTEST-OPTION...
  local status=0 before usual=()
  # Started in the background, we may have been told to ignore signals; tests end what they start by them.
  if env --default-signal=INT true 2>/dev/null; then usual=(env "--default-signal=INT,HUP,PIPE"); fi
  before=$(wc -l <"$log")
  stage "$2" kept ${usual[@]+"${usual[@]}"} ctest --test-dir "build/$1" --parallel "$jobs" --output-on-failure --no-label-summary --no-tests=error \
    "${@:3}" || status=$?
  tail -n "+$((before + 1))" "$log" | sed -n '/% tests passed/,$p'
  return "$status"
}
