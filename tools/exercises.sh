# shellcheck shell=bash disable=SC2154
# A student's way through the exercises. Sourced by ../course, which sets root, caller, word and passed_on. Python gets -E, for a
# PYTHONSAFEPATH or PYTHONPATH of the caller's would hide or replace the tools' own files.

exercise_packages="python3:python3"
toolchain=$root/build/default/exercises/toolchain.json

# is_exercise WORD: whether it names an exercise, or a file of one. No exercise is called as a chapter is.
is_exercise() {
  local word=$1 folder
  for folder in exercises/[0-9][0-9]_*/*/; do
    [ -f "$folder/exercise.json" ] || continue
    folder=${folder#exercises/} folder=${folder%/}
    case /$word/ in "/${folder#*/}/" | */"$folder"/*) return 0 ;; esac
  done
  return 1
}

exercise_names() {
  local file
  for file in exercises/[0-9][0-9]_*/*/exercise.json; do
    [ -f "$file" ] && file=${file%/exercise.json} && echo "${file##*/}"
  done
}

# exercise COMMAND WORD...: what tools for students answer. Only what compiles needs the build.
exercise() {
  case $1 in start | check | watch) configure_exercises ;; *) ensure "$exercise_packages" "" ;; esac
  exec python3 -E -B exercises/tools/student.py --root "$root" --toolchain "$toolchain" "$@"
}

# instructor COMMAND WORD...: their folders are the caller's. What is printed is theirs to read by a program. Only merging compiles
# nothing.
instructor() {
  case $1 in release | package) ensure "git:git" "" >&2 ;; esac
  if [ "$1 ${2-}" = "grade merge" ]; then ensure "$exercise_packages" ""; else configure_exercises; fi >&2
  cd -- "$caller" || exit 1
  exec python3 -E -B "$root/exercises/tools/$1.py" --root "$root" --toolchain "$toolchain" "${@:2}"
}

configure_exercises() {
  local file
  ensure "$base_packages $exercise_packages" "$speed_packages"
  # A build folder may be older than the exercises, or than a chapter that has come since; only CMake itself would notice.
  [ -f "$toolchain" ] || rm -f build/default/configured
  for file in CMakeLists.txt common/CMakeLists.txt chapters/CMakeLists.txt chapters/*/CMakeLists.txt exact/CMakeLists.txt exercises/CMakeLists.txt; do
    if [ "$file" -nt build/default/configured ]; then rm -f build/default/configured; fi
  done
  [ -f build/default/configured ] || echo "Once, the build has to be configured:"
  configure default || exit 1
}
