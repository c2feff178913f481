#!/usr/bin/env bash
# How long one waits for the book and for a verdict. Measured in a copy of the tree, without the compiler's cache.
set -eu
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

copy=build/timings
page=chapters/03_inertia/chapter.md
header=chapters/03_inertia/tumble/inertia.hpp

rm -rf "$copy"
mkdir -p "$copy"
tar -cf - --exclude=./build --exclude=./work --exclude=./.git --exclude=node_modules . | tar -xf - -C "$copy"
cd "$copy"
export CCACHE_DISABLE=1

# measure CASE ARGUMENT...: what ./course says about a case, and a line of the table.
table=""
measure() {
  local begin took
  echo
  echo "$1:"
  begin=$(date +%s%N)
  ./course "${@:2}" --no-install
  took=$((($(date +%s%N) - begin) / 10000000))
  table+=$(printf '%-58s %5d.%02d s' "$1" $((took / 100)) $((took % 100)))$'\n'
}

measure "A clean build of the book" book
measure "Nothing changed" book
printf '\nOne sentence more.\n' >>"$page"
measure "One sentence of chapter 03 changed, the book again" book
printf '\n// One line more.\n' >>"$header"
measure "One header of chapter 03 changed, the verdict of its checks" check "$header"
measure "The verdict of all of chapter 03's checks on it" check 03

printf '\n%s' "$table"
