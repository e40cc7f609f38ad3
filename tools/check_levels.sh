#!/usr/bin/env bash
# tools/check_levels.sh [--self-test | SOURCE_FOLDER]
#
# Includes flow one way: a file includes only files of its own or a lower level. Prints file:line of
# every include that does not and fails. A file's room is the first folder of its path below src/.
#
# The folders beside src (tests, verify, bench) are above all levels: their files include anything of
# src and files of their own folder, named from src/, from their folder or from beside themselves.
# They include nothing of each other, and src includes nothing of them.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

# The one table of levels. A new room is one word here.
levels="
0 base blast
1 store smoothing matter surface exact records sloshing
2 search parallel
3 terms walls bodies motion
4 coupling probes
5 step
6 output setup report watch sweep
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

# Prints every quoted include below ROOT/{tests,verify,bench} that is no file of src or of the
# folder itself.
check_beside() {
  local tree=$1 folder file line target count=0 failures=0
  for folder in tests verify bench; do
    while IFS= read -r file; do
      count=$((count + 1))
      while IFS=: read -r line target; do
        target=${target#*\"}
        target=${target%%\"*}
        if [[ $target != *..* && (-e $tree/src/$target || -e $tree/$folder/$target ||
          -e $(dirname "$file")/$target) ]]; then continue; fi
        printf '%s:%s: "%s" is no file below src/ or %s/\n' "${file#"$tree/"}" "$line" "$target" \
          "$folder"
        failures=$((failures + 1))
      done < <(grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' "$file")
    done < <(find "$tree/$folder" -type f -regex '.*\.\(h\|hpp\|cpp\|cu\|cuh\)' 2>/dev/null | sort)
  done
  if [[ $failures -gt 0 ]]; then return 1; fi
  say "levels: $count files beside src include only src and their own folder"
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

# Makes FILE with one include in a tree that has src/base/text.hpp, tests/support/model.hpp and
# bench/state.hpp, and checks the outcome.
expect_beside() {
  local outcome=$1 file=$2 include=$3 tree output status=0
  tree=$(mktemp -d)
  mkdir -p "$tree"/{src/base,tests/support,verify,bench} "$tree/$(dirname "$file")"
  touch "$tree"/{src/base/text.hpp,tests/support/model.hpp,bench/state.hpp}
  printf '#pragma once\n#include %s\n' "$include" >"$tree/$file"
  output=$(check_beside "$tree" 2>&1) || status=$?
  rm -r "$tree"
  case $outcome in
    allowed) [[ $status -eq 0 ]] ;;
    refused) [[ $status -ne 0 && $output == *"$file:2:"* ]] ;;
  esac || fail "self-test: $file with $include should be $outcome; got: $output"
}

self_test() {
  expect_beside allowed tests/unit/text_test.cpp '"base/text.hpp"'
  expect_beside allowed tests/unit/text_test.cpp '"support/model.hpp"'
  expect_beside allowed tests/support/other.cpp '"model.hpp"'
  expect_beside allowed tests/unit/text_test.cpp '<gtest/gtest.h>'
  expect_beside allowed verify/exact/sod/check.cpp '"base/text.hpp"'
  expect_beside refused verify/exact/sod/check.cpp '"support/model.hpp"'
  expect_beside refused tests/unit/text_test.cpp '"state.hpp"'
  expect_beside refused bench/parts.cpp '"../tests/support/model.hpp"'
  expect_beside refused tests/unit/text_test.cpp '"attic/text.hpp"'
  expect refused base/text.hpp '"support/model.hpp"'
  expect refused verify/check.cpp '"tests/support/model.hpp"'
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
  "")
    status=0
    (check_levels "$root/src") || status=1
    check_beside "$root" || status=1
    exit $status
    ;;
  *) check_levels "$1" ;;
esac
