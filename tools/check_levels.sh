#!/usr/bin/env bash
# tools/check_levels.sh [--self-test | SOURCE_FOLDER]
#
# Includes flow one way: a file includes only files of its own or a lower level. Prints file:line of
# every include that does not and fails. A file's room is the first folder of its path below src/.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

# The one table of levels. A new room is one word here.
levels="
0 base
1 store smoothing matter surface exact
2 search parallel
3 terms walls bodies motion
4 coupling probes
5 step
6 output setup
7 app python bench verify
"

check_levels() {
  local source_folder=$1 files
  cd "$source_folder"
  mapfile -t files < <(find . -type f -regex '.*\.\(h\|hpp\|cpp\|cu\|cuh\)' | sort)
  if [[ ${#files[@]} -eq 0 ]]; then fail "no sources found in $source_folder"; fi
  awk -v levels="$levels" '
    function complain(text) {
      printf "src/%s:%d: %s\n", file, FNR, text
      failures++
    }
    function room_of(path) {
      return index(path, "/") ? substr(path, 1, index(path, "/") - 1) : ""
    }
    BEGIN {
      rows = split(levels, row, "\n")
      for (r = 1; r <= rows; r++) {
        words = split(row[r], word, " ")
        for (w = 2; w <= words; w++) level[word[w]] = word[1]
      }
    }
    FNR == 1 {
      file = substr(FILENAME, 3)
      room = room_of(file)
      if (!(room in level)) complain("room \"" room "\" is not in the table of levels")
    }
    /^[ \t]*#[ \t]*include[ \t]*["<]/ {
      quoted = ($0 ~ /include[ \t]*"/)
      target = $0
      sub(/^[^"<]*["<]/, "", target)
      sub(/[">].*$/, "", target)
      other = room_of(target)
      if (!(other in level)) {
        if (quoted) complain("\"" target "\" is not a path below src/ (other code: <...>)")
      } else if (room in level && level[other] > level[room]) {
        complain(room " (level " level[room] ") includes \"" target "\" (level " level[other] ")")
      }
    }
    END { exit failures > 0 }' "${files[@]}" || return 1
  say "levels: ${#files[@]} files include only their own or lower levels"
}

# Makes src/FILE with one include after a first line and checks the outcome.
expect() {
  local outcome=$1 file=$2 include=$3 folder output status=0
  folder=$(mktemp -d)
  mkdir -p "$folder/$(dirname "$file")"
  printf '#pragma once\n#include %s\n' "$include" >"$folder/$file"
  output=$(check_levels "$folder" 2>&1) || status=$?
  rm -r "$folder"
  case $outcome in
    allowed) [[ $status -eq 0 ]] ;;
    refused) [[ $status -ne 0 && $output == *"src/$file:"* ]] ;;
  esac || fail "self-test: $file with $include should be $outcome; got: $output"
}

self_test() {
  expect allowed step/loop.hpp '"terms/pair.hpp"'
  expect allowed store/particles.hpp '"matter/eos/eos.hpp"'
  expect allowed base/text.hpp '<string>'
  expect allowed base/text.hpp '<fmt/format.h>'
  expect refused base/text.hpp '"store/field.hpp"'
  expect refused base/text.hpp '<store/field.hpp>'
  expect refused matter/eos/tait.cpp ' "terms/pair.hpp"  // comment'
  expect refused output/writer.cpp '"app/main.hpp"'
  expect refused base/text.hpp '"error.hpp"'
  expect refused base/text.hpp '"../base/error.hpp"'
  expect refused base/text.hpp '"attic/error.hpp"'
  expect refused attic/error.hpp '"base/text.hpp"'
  say "levels: self-test passed"
}

case ${1:-} in
  --self-test) self_test ;;
  *) check_levels "${1:-$root/src}" ;;
esac
