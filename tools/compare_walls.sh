#!/usr/bin/env bash
# tools/compare_walls.sh [PROGRAM [SECONDS]]
#
# Compares the methods of walls and prints the table of docs/walls.md: error of the pressure in still
# water, front of a dam break, particles that leak from a tank of water that falls over, cost of a
# step. PROGRAM: build/moraine by default. SECONDS of the tank that falls over: 17 by default, in
# which every method makes 100 000 steps or more. Takes some minutes on one core.
set -euo pipefail
shopt -s inherit_errexit
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

program=$(realpath "${1:-$build/moraine}") seconds=${2:-17}
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1

# method_keys METHOD SLIP D: the keys of a wall.
method_keys() {
  printf 'method = "%s"\n' "$1"
  case $1 in *repulsive) printf 'repulsion = "%s m^2/s^2"\n' "$3" ;; esac
  case $1 in repulsive) ;; *) printf 'slip = "%s"\n' "$2" ;; esac
}

# with_method CASE METHOD SLIP D: the shipped case with these walls, as text.
with_method() {
  method_keys "$2" "$3" "$4" >keys
  sed -e '/^container/r keys' "$root/cases/$1/case.toml"
}

# run NAME: the case NAME.toml, its results in the folder NAME.
run() { "$program" run "$1.toml" --output "$1" >"$1.log" 2>&1 || fail "$(tail -n 3 "$1.log")"; }

# manifest_of FOLDER KEY: a number of the end of the run.
manifest_of() {
  awk -F '[:,]' -v key="\"$2\"" 'index($0, key ":") { value = $2 } END { print value + 0 }' \
    "$1/manifest.json"
}

# values_of FILE NAME...: columns of a table of results, by the names in its first line without
# their units; the columns of each row with spaces between them.
values_of() {
  local file=$1
  shift
  awk -F, -v wanted="$(printf '|%s' "$@")" '
    NR == 1 {
      for (k = 1; k <= NF; ++k) {
        sub(/ \[[^]]*\]$/, "", $k)
        at[$k] = k
      }
      count = split(substr(wanted, 2), names, "|")
      for (k = 1; k <= count; ++k)
        if (!(names[k] in at)) {
          print FILENAME ": no column " names[k] > "/dev/stderr"
          exit 1
        }
      next
    }
    { for (k = 1; k <= count; ++k) printf "%s%s", $at[names[k]], k < count ? " " : "\n" }' "$file"
}

# Largest error of the pressure on a line through still water from 1 cm above the floor to 5 cm below
# the surface, over rho g H, and ms of the processor per step.
still_water() {
  with_method hydrostatic-tank "$1" "$2" 24.5 |
    sed -e 's/^spacing = .*/spacing = "12.5 mm"/' -e 's/^end = .*/end = "0.5 s"/' \
      -e 's/^frames = .*//' -e '/^\[\[gauge\]\]/,$d' >still.toml
  cat >>still.toml <<'END'
[[gauge]]
name = "line"
kind = "line"
line = { from = ["25 cm", "1 cm"], to = ["25 cm", "45 cm"], points = 45 }
END
  rm -rf still
  TIMEFORMAT=%U
  { time run still; } 2>used
  local columns=()
  for point in {1..45}; do columns+=("line[$point] pressure"); done
  values_of still/gauges.csv "${columns[@]}" | tail -n 1 | awk '{
    for (k = 0; k < 45; ++k) {
      e = $(1 + k) / (9810 * 0.5) - (0.49 - 0.01 * k) / 0.5
      if (e < 0) e = -e
      if (e > worst) worst = e
    }
    printf "%.1f", 100 * worst }'
  awk -v seconds="$(cat used)" -v steps="$(manifest_of still steps)" \
    'BEGIN { printf " %.4f", 1000 * seconds / steps }'
}

# Error of the mean speed of the front of a dam break from x/a = 1.44 to 4.11, where Martin and Moyce
# measured 2.67 / 2.14.
front() {
  with_method dam-break-2d "$1" "$2" 5.6 |
    sed -e 's/^spacing = .*/spacing = "2.8575 mm"/' -e 's/^end = .*/end = "0.22 s"/' \
      -e 's/^frames = .*//' >front.toml
  rm -rf front
  run front
  values_of front/gauges.csv time "front front" | awk '{
    z = $2 / 0.05715
    t = $1 * sqrt(2 * 9.81 / 0.05715)
    if (z <= 1.44) begin = t
    if (z <= 4.11) end = t
  }
  END { printf " %+.1f", 100 * (2.14 / (end - begin) - 1) }'
}

# Particles that leak from the closed tank, of all, and steps: those beyond its walls by any distance,
# the most at any reading (every 10 ms), and those that have left for good, 1 mm beyond.
leaks() {
  with_method dam-break-2d "$1" "$2" 5.6 |
    sed -e 's/^spacing = .*/spacing = "5.715 mm"/' -e "s/^end = .*/end = \"$seconds s\"/" \
      -e 's/^frames = .*//' -e 's/^gauges = .*/gauges = "10 ms"/' -e 's/^sums = .*/sums = "1 s"/' \
      -e '/^open = /d' -e 's/"1.143 m"/"171.45 mm"/' -e '/^\[\[gauge\]\]/,$d' >leaks.toml
  sed -i '/^dimension = 2/a domain = { min = ["-1 mm", "-1 mm"], max = ["172.45 mm", "172.45 mm"] }' \
    leaks.toml
  cat >>leaks.toml <<'END'
[[gauge]]
name = "outside"
kind = "expression"
formula = "max(max(-x, x - 0.17145), max(-y, y - 0.17145)) > 0 ? 1 : 0"
reduce = "sum"
END
  rm -rf leaks
  run leaks
  local most
  most=$(values_of leaks/gauges.csv "outside sum" | sort -g | tail -n 1)
  values_of leaks/sums.csv lost_particles particles | tail -n 1 |
    awk -v most="$most" -v steps="$(manifest_of leaks steps)" \
      '{ printf " %d %d %d", $1 + most, $1 + $2, steps }'
}

printf '| walls | slip | still water, error / ρgH | dam break, speed of the front | leaks | steps | cost of a step |\n'
printf '|---|---|---|---|---|---|---|\n'
reference=''
for variant in 'dummy free' 'dummy none' 'mirror free' 'mirror none' 'repulsive free' \
  'mirror_and_repulsive free' 'mirror_and_repulsive none'; do
  read -r method slip <<<"$variant"
  numbers=$(
    still_water "$method" "$slip"
    front "$method" "$slip"
    leaks "$method" "$slip"
  )
  read -r error cost speed lost all steps <<<"$numbers"
  reference=${reference:-$cost}
  printf '| `%s` | %s | %s %% | %s %% | %s of %s | %s | %.2f |\n' "$method" "$slip" "$error" "$speed" \
    "$lost" "$all" "$steps" "$(awk -v a="$cost" -v b="$reference" 'BEGIN { print a / b }')"
done
