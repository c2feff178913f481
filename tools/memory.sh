# shellcheck shell=bash disable=SC2154
# How much memory things take, for --timings. Sourced by ../course and timings.sh.

memory_log=""

# watch_memory FILE: from now on, as long as this shell runs; without Python nothing is watched.
watch_memory() {
  command -v python3 >/dev/null 2>&1 || return 0
  memory_log=$1
  : >"$memory_log"
  python3 -B tools/memory.py $$ "$memory_log" </dev/null >/dev/null 2>&1 &
}

memory_lines() { if [ -n "$memory_log" ]; then wc -l <"$memory_log"; else echo 0; fi; }

# peak_since LINE: two columns in MB: the largest process, and all together.
peak_since() {
  if [ -z "$memory_log" ]; then
    printf '%13s %13s' - -
  else
    tail -n "+$(($1 + 1))" "$memory_log" | awk '
      NF == 2 { if ($1 > one) one = $1; if ($2 > all) all = $2 }
      END { printf "%10.0f MB %10.0f MB", one / 1024, all / 1024 }'
  fi
}
