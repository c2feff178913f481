# shellcheck shell=bash disable=SC2154
# What a test of a command's answers is made of: sourced, and ended with [ "$failures" -eq 0 ].
failures=0

# ARGUMENT...: what `program` answers, with PATH as `path` has it and within ulimit's `limit`, if these are set, as `output`, `errors`
# and `code`
run() {
  # shellcheck disable=SC2086
  output=$( ([ -z "${limit-}" ] || ulimit $limit; PATH=${path:-$PATH} "$program" "$@" 2>errors.txt </dev/null))
  code=$?
  errors=$(cat errors.txt)
  rm errors.txt
}

verify() { # SENTENCE CONDITION...
  local sentence=$1
  shift
  if "$@"; then
    echo "passed: $sentence"
  else
    failures=$((failures + 1))
    printf 'error: %s\n  exit code %s\n  it said: %s\n  and: %s\n' "$sentence" "$code" "$output" "${errors-}"
    [ -z "${TUMBLE_FIRST_FAILURE_ENDS-}" ] || exit 1
  fi
}

says() { [[ $output == *"$1"* ]]; }
says_not() { ! says "$1"; }
complains() { [[ $errors == *"$1"* ]]; }
ends_with() { [ "$code" -eq "$1" ]; }
answers() { ends_with "$1" && says "$2"; }
fails() { ends_with "$1" && complains "$2"; }
