#!/usr/bin/env bash
# tools/count_instructions.sh [WORKLOAD [STEPS]] | --loops PROGRAM
#
# Instructions per pair and function, for machines without performance counters: runs STEPS steps
# (default 3) of a workload (default dam-break-3d-1e4) under valgrind --tool=callgrind and divides
# by the pairs of those steps. Valgrind knows no AVX-512, so the AVX2 build (preset avx2, folder
# build-avx2) is made and counted: its registers are half as wide, and the pair loop needs about
# twice the instructions of the native build. Needs valgrind and binutils.
#
# --loops PROGRAM: instructions in the innermost loops of the pair sweep of any build, read from the
# program with objdump: every backward jump within a sweep function whose body takes a square root
# and holds no other such loop. One pass of a loop does as many pairs as its registers have lanes.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

show_loops() {
  objdump --disassemble --demangle --no-show-raw-insn --wide "$1" | awk '
    function report(  k, j, lines, nested, width, roots) {
      for (k = 1; k <= jumps; k++) {
        roots = lines = nested = 0
        width = ""
        for (j = 1; j <= jumps; j++)
          if (j != k && from[j] >= from[k] && to[j] <= to[k] && rooted[j]) nested = 1
        if (nested || !rooted[k]) continue
        for (j = from[k]; j <= to[k]; j++)
          if (text[j] ~ /sqrt/) {
            roots++
            width = text[j] ~ /zmm/ ? "zmm" : (text[j] ~ /ymm/ ? "ymm" : "xmm")
            type = text[j] ~ /pd/ ? "double" : "float"
          }
        printf "%5d instructions, %s %s: %s\n", to[k] - from[k] + 1, width, type, name
      }
    }
    /^[0-9a-f]+ <.*>:$/ {
      if (wanted) report()
      name = $0
      sub(/^[0-9a-f]+ </, "", name)
      sub(/>:$/, "", name)
      wanted = name ~ /PairBackendImpl.*(sweep|for_each_sum)|sum_over_pairs/
      lines_in = jumps = 0
      split("", line_of)
      next
    }
    wanted && /^ *[0-9a-f]+:/ {
      address = $1
      sub(/:$/, "", address)
      text[++lines_in] = $0
      line_of[address] = lines_in
      # A conditional jump to an address of this function that was seen before closes a loop.
      if ($2 ~ /^j/ && ($3 in line_of)) {
        from[++jumps] = line_of[$3]
        to[jumps] = lines_in
        rooted[jumps] = 0
        for (j = from[jumps]; j <= lines_in; j++)
          if (text[j] ~ /sqrtp/) rooted[jumps] = 1
      }
    }
    END { if (wanted) report() }' | sort | uniq | sed 's|void ||; s|moraine::||g; s|(PairField)||g; s|, Broadcast<.*||'
}

count_functions() {
  local workload=$1 steps=$2 folder pairs
  (cd "$root" && cmake --preset avx2 >/dev/null && cmake --build --preset avx2 --target moraine)
  folder=$(mktemp -d)
  trap "rm -r '$folder'" EXIT
  say "callgrind: $steps steps of $workload on one thread, AVX2"
  # One workload alone runs in the process that valgrind watches. Only the steps are counted.
  valgrind --tool=callgrind --callgrind-out-file="$folder/out" \
    --toggle-collect='moraine::Simulation::advance()' \
    "$root/build-avx2/moraine" bench "$workload" --warm-up 0 --steps "$steps" --threads 1 --json \
    >"$folder/json" 2>"$folder/log" || { cat "$folder/log" >&2; fail "valgrind failed"; }
  pairs=$(awk -F '[:,]' '/"neighbour_interactions"/ { printf "%.0f", $2 }' "$folder/json")
  say "pairs: $pairs"
  callgrind_annotate --threshold=99 "$folder/out" | awk -v pairs="$pairs" '
    /^ *[0-9,]+ \(/ {
      count = $1
      gsub(/,/, "", count)
      name = $0
      sub(/^ *[0-9,]+ \([^)]*\) */, "", name)
      sub(/^[^:]*:/, "", name)  # the file
      sub(/ \[[^]]*\]$/, "", name)
      printf "%9.3f  %s\n", count / pairs, name
    }' |
    sed 's/moraine:://g; s/(PairField)//g; s/{lambda.*//' |
    cut -c1-150
}

case ${1:-} in
  -h | --help) print_help "${BASH_SOURCE[0]}" ;;
  --loops) show_loops "${2:?a program is needed}" ;;
  *) count_functions "${1:-dam-break-3d-1e4}" "${2:-3}" ;;
esac
