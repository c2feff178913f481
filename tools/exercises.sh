# shellcheck shell=bash disable=SC2154
# A student's way through the exercises. Sourced by ../course, which sets root, word and passed_on.

exercise_packages="python3:python3"

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
  case $1 in
    start | check | watch)
      ensure "$base_packages $exercise_packages" "$speed_packages"
      [ -f build/default/configured ] || echo "Once, the build has to be configured:"
      configure default || exit 1
      ;;
    *) ensure "$exercise_packages" "" ;;
  esac
  exec python3 -B exercises/tools/student.py --root "$root" --toolchain "$root/build/default/exercises/toolchain.json" "$@"
}
