#!/usr/bin/env bash
# tools/bench_compare.sh A B [WORKLOAD [ROUNDS [OPTION...]]]
#
# Compares two builds of the program on a machine that others use too: runs the benchmark of A and B
# in turn, ROUNDS times (default 5) on one workload (default dam-break-3d), and prints the ratio B/A
# of every round and the median. Noise that lasts longer than a round hits both alike. More options,
# such as --steps 100 --threads 1, go to `moraine bench`.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

if [[ $# -lt 2 ]]; then
  print_help "${BASH_SOURCE[0]}"
  exit 2
fi
a=$1 b=$2 workload=${3:-dam-break-3d} rounds=${4:-5}
shift $(($# < 4 ? $# : 4))

# Neighbour interactions per second and core, in millions.
speed_of() {
  "$1" bench "$workload" --json "${@:2}" |
    awk -F '[:,]' '/"neighbour_interactions_per_second_per_core"/ {
      printf "%.2f\n", $2 / 1e6
      found = 1
    }
    END { exit !found }' || fail "$1 bench $workload gives no figure"
}

printf '%5s  %10s  %10s  %8s   million pairs per second and core, %s\n' round A B B/A "$workload"
ratios=()
for ((round = 1; round <= rounds; round++)); do
  # The order changes from round to round: what runs second may find a warmer or a hotter machine.
  if ((round % 2)); then
    speed_a=$(speed_of "$a" "$@")
    speed_b=$(speed_of "$b" "$@")
  else
    speed_b=$(speed_of "$b" "$@")
    speed_a=$(speed_of "$a" "$@")
  fi
  ratio=$(awk -v a="$speed_a" -v b="$speed_b" 'BEGIN { printf "%.4f", b / a }')
  ratios+=("$ratio")
  printf '%5s  %10s  %10s  %8s\n' "$round" "$speed_a" "$speed_b" "$ratio"
done
printf '%s\n' "${ratios[@]}" | sort -n | awk '
  { value[NR] = $1 }
  END {
    median = NR % 2 ? value[(NR + 1) / 2] : (value[NR / 2] + value[NR / 2 + 1]) / 2
    printf "median B/A %.4f, from %.4f to %.4f\n", median, value[1], value[NR]
  }'
