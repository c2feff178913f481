# shellcheck shell=bash disable=SC2154
# Stages: each prints one calm line with the time it took; what it says goes to the log. Sourced by ../course, which
# sets root and log.

now() { # in tenths of a second
  local time=${EPOCHREALTIME-}
  if [ -n "$time" ]; then
    time=${time/[.,]/}
    echo "${time%?????}"
  else
    echo "$(date +%s)0"
  fi
}

started=$(now)

seconds() { printf '%d.%d' $(($1 / 10)) $(($1 % 10)); }

# stage SENTENCE COMMAND...: runs it with its output in the log, and says how long it took.
stage() {
  local sentence=$1 begin status=0 before took
  shift
  before=$(wc -l <"$log")
  begin=$(now)
  printf '%-62s' "$sentence"
  printf '\n--- %s\n+ %s\n' "$sentence" "$*" >>"$log"
  "$@" >>"$log" 2>&1 </dev/null || status=$?
  took=$(($(now) - begin))
  if [ "$status" -eq 0 ]; then
    printf '%8s s\n' "$(seconds "$took")"
  else
    printf '  failed after %s s\n\n' "$(seconds "$took")"
    failing_part "$before"
    printf '\nThe full log is %s\n' "$log"
  fi
  return "$status"
}

# The first thing that went wrong after a line of the log; ninja's repetition of a command is no part of it.
failing_part() {
  tail -n "+$(($1 + 4))" "$log" | awk '
    { line[NR] = $0 }
    !first && /^FAILED: |error: |CMake Error|^E: |\*\*\*(Failed|Not Run|Timeout|Exception)/ { first = NR }
    END {
      if (!first) first = NR > 25 ? NR - 24 : 1
      for (i = first; i <= NR && shown < 30; ++i) {
        if (i > 1 && line[i - 1] ~ /^FAILED: /) continue
        print substr(line[i], 1, 300); ++shown
      }
    }'
}

finish() {
  printf '%s (%s s; log: %s)\n' "$1" "$(seconds $(($(now) - started)))" "${log#"$root"/}"
}
