#!/usr/bin/env bash
# heal_test.sh SOURCE SCRATCH: breaks a build folder in every way that we have met or could think of. The next command
# heals it, or says in one sentence what to do. The tools are the real ones; what they build is one small program.
# shellcheck disable=SC2016  # what stands in single quotes belongs to other files
set -u
source=$1
scratch=$2
tree="$scratch/a tree"
# shellcheck source=tests/verify.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/../verify.sh"

rm -rf "$scratch"
mkdir -p "$tree/chapters/01_force"
mkdir "$tree/exercises"
cp -R "$source/course" "$source/tools" "$tree"
cp -R "$source/exercises/tools" "$tree/exercises"
cat >"$tree/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(Healed LANGUAGES CXX)
add_executable(01_force_checks main.cpp)
set_target_properties(01_force_checks PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/checks)
END
echo 'int main() {}' >"$tree/main.cpp"
cat >"$tree/CMakePresets.json" <<'END'
{"version": 6, "configurePresets": [{"name": "default", "binaryDir": "${sourceDir}/build/default"}]}
END
build="$tree/build/default"

course() { # its output and exit code go to `output` and `code`
  output=$("$tree/course" check 1 --no-install 2>&1 </dev/null)
  code=$?
}

told() { [ "$code" -eq 2 ] && [[ $output == *"$1"* && $output == *"Delete build"* ]]; }
heals() { [ "$code" -eq 0 ] && [[ $output == *"The checks of 01_force hold."* ]] && [ -x "$build/checks/01_force_checks" ]; }

course
verify "a new checkout is configured and built" heals
course
verify "what is configured is not configured again" [ "${output/Configured/}" = "$output" ]

rm "$build/configured"
touch "$build/of_before"
course
verify "without its mark it is configured again" heals
verify "and keeps what was compiled" [ -e "$build/of_before" ]

healed() { # CONDITION DAMAGE: what was done to the build folder, and that the next command heals it
  eval "$2"
  course
  verify "$1 it heals" heals
}
healed "without CMakeCache.txt, though it is marked as configured," 'rm "$build/CMakeCache.txt"'
healed "without the files of the build" 'rm -f "$build/build.ninja" "$build/Makefile"'
healed "with the files of the build cut off" \
  'for file in build.ninja Makefile; do [ ! -f "$build/$file" ] || echo "half a li" >"$build/$file"; done'
healed "with half a CMakeCache.txt" 'echo "half a li" >"$build/CMakeCache.txt"'
healed "without CMakeFiles" 'rm -rf "$build/CMakeFiles"'
healed "with an interrupted compiler's empty files" \
  'find "$build" -name "*.o" -exec truncate -s 0 {} +; rm -f "$build/.ninja_log" "$build/.ninja_deps"; touch "$tree/main.cpp"'
healed "with noise in Ninja's books" 'for file in .ninja_log .ninja_deps; do head -c 100 /dev/urandom >"$build/$file"; done'
healed "with a folder in the place of CMakeCache.txt" 'rm "$build/configured" "$build/CMakeCache.txt"; mkdir "$build/CMakeCache.txt"'
healed "with a file in the place of the build folder" 'rm -rf "$build"; echo >"$build"'
healed "configured for a compiler and a Ninja that are gone," \
  'sed -i.bak "s|^\(CMAKE_CXX_COMPILER\|CMAKE_MAKE_PROGRAM\):.*|\1:FILEPATH=/nowhere/gone|" "$build/CMakeCache.txt"; rm "$build/configured"'
healed "configured by another compiler," 'echo "another compiler 1.0; warnings as errors: " >"$build/configured"; touch "$build/of_the_other"'
verify "and nothing of the other one's is kept" [ ! -e "$build/of_the_other" ]
mv "$tree" "$scratch/moved"
tree=$scratch/moved build=$scratch/moved/build/default
course
verify "moved to another place, it heals" heals

# Whatever ends the command, what it has started ends too. What is compiled here never comes to its end.
if command -v python3 >/dev/null; then
  endless=$scratch/endless
  printf '#!/usr/bin/env bash\necho $$ >>"%s"\nexec sleep 1000000\n' "$endless.pids" >"$endless"
  chmod +x "$endless"
  cp "$tree/CMakeLists.txt" "$scratch/as_it_was"
  echo "add_custom_command(TARGET 01_force_checks PRE_LINK COMMAND '$endless' VERBATIM)" | tr "'" '"' >>"$tree/CMakeLists.txt"
  for signal in TERM HUP KILL; do
    touch "$tree/main.cpp"
    : >"$endless.pids"
    "$tree/course" check 1 --no-install >/dev/null 2>&1 </dev/null &
    until [ -s "$endless.pids" ] || ! kill -0 $! 2>/dev/null; do sleep 0.1; done
    running=$(cat "$endless.pids")
    kill "-$signal" $!
    wait $! 2>/dev/null
    code=$? output=""
    verify "SIG$signal ends the command" ends_with $((128 + $(kill -l "$signal")))
    for ((count = 0; count < 600; ++count)); do kill -0 "$running" 2>/dev/null || break; sleep 0.1; done
    verify "and nothing of it runs on" [ "$count" -lt 600 ]
    kill "$running" 2>/dev/null
  done
  mv "$scratch/as_it_was" "$tree/CMakeLists.txt"
  touch "$tree/CMakeLists.txt"
  course
  verify "and the next command makes the rest" heals
fi

rm -rf "$tree/build"
echo >"$tree/build"
course
verify "a file called build is told of" told "nothing can be written to build/log"
rm "$tree/build"
course

# Another user's build folder: who is root here becomes nobody for the moment.
as_another=()
[ "$(id -u)" -ne 0 ] || as_another=(setpriv --reuid 65534 --regid 65534 --clear-groups)
if [ "$(id -u)" -ne 0 ]; then chmod -R a-w "$tree/build"; else chmod 755 "$scratch" "$tree"; fi
if "${as_another[@]}" test -x "$tree/course" 2>/dev/null; then
  output=$("${as_another[@]}" "$tree/course" check 1 --no-install 2>&1 </dev/null)
  code=$?
  verify "a folder in which nothing may be written is told of in one sentence" \
    told "nothing can be written to build/log: Permission denied"
else
  echo "passed over: another user can't come as far as $tree"
fi
chmod -R u+w "$tree/build"

[ "$failures" -eq 0 ]
