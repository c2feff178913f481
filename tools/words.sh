# shellcheck shell=bash
# What to answer to a word that nothing is called.

# nearest WORD CANDIDATE...: the candidate with the fewest letters to change, if they are few.
nearest() {
  printf '%s\n' "$@" | awk '
    NR == 1 { word = $0; next }
    {
      for (j = 0; j <= length($0); ++j) row[j] = j
      for (i = 1; i <= length(word); ++i) {
        diagonal = row[0]; row[0] = i
        for (j = 1; j <= length($0); ++j) {
          change = diagonal + (substr(word, i, 1) != substr($0, j, 1)); diagonal = row[j]
          if (row[j - 1] + 1 < change) change = row[j - 1] + 1
          if (row[j] + 1 < change) change = row[j] + 1
          row[j] = change
        }
      }
      if (best == "" || row[length($0)] < fewest) { best = $0; fewest = row[length($0)] }
    }
    END { if (fewest <= 2 || fewest * 3 <= length(best)) print best }'
}

did_you_mean() {
  local suggestion
  suggestion=$(nearest "$@")
  printf '%s' "${suggestion:+Did you mean $suggestion?}"
}
