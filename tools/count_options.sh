#!/usr/bin/env bash
# tools/count_options.sh [STEPS]
#
# What options cost, in instructions per pair and step, for machines without performance counters:
# runs STEPS steps (default 3) of the shipped dam break in 3D under valgrind --tool=callgrind,
# as it is and with one option at a time, and prints a table of docs/performance.md. The AVX2 build
# (preset avx2, folder build-avx2) is made and counted, as by tools/count_instructions.sh. Needs
# valgrind.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
case ${1:-} in -h | --help) print_help "${BASH_SOURCE[0]}" ;; esac
steps=${1:-3}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

# with TABLE LINE...: the lines under a table of the case.
with() {
  local table=$1 line
  shift
  for line; do sed -i "/^\[$table\]/a $line" "$folder/case.toml"; done
}

# count NAME: a row of the table, for the case as it now is.
count() {
  valgrind --tool=callgrind --callgrind-out-file="$folder/out" \
    --toggle-collect='moraine::Simulation::advance()' \
    "$root/build-avx2/moraine" bench "$folder/case.toml" --warm-up 0 --steps "$steps" --threads 1 \
    --json >"$folder/json" 2>"$folder/log" || { cat "$folder/log" >&2; fail "valgrind failed"; }
  local pairs
  pairs=$(awk -F '[:,]' '/"neighbour_interactions"/ { printf "%.0f", $2 }' "$folder/json")
  awk -v pairs="$pairs" -v name="$1" -v base="${base:-0}" '
    /^(summary|totals):/ { count = $2 / pairs }
    END { printf "| %s | %.1f | %+.1f |\n", name, count, base ? count - base : 0 }' "$folder/out"
}

# option NAME TABLE LINE...
option() {
  cp "$root/cases/dam-break-3d/case.toml" "$folder/case.toml"
  local name=$1
  shift
  with material.water 'dynamic_viscosity = "1 mPa s"' # counts only where it is asked for
  with "$@"
  count "$name"
}

(cd "$root" && cmake --preset avx2 >/dev/null && cmake --build --preset avx2 --target moraine)
say "callgrind: $steps steps of cases/dam-break-3d on one thread, AVX2"
echo "| option | instructions per pair | more |"
echo "|---|---|---|"
plain=$(option none numerics)
base=$(awk '{ print $4 }' <<<"$plain")
echo "$plain"
option '`continuity = "volume"`, `momentum = "mixed"`' numerics 'continuity = "volume"' 'momentum = "mixed"'
option '`density = "summation"`' numerics 'density = "summation"'
option '`smoothing = { mode = "density" }`' resolution 'smoothing = { mode = "density" }'
option '`xsph = 0.5`' numerics 'xsph = 0.5'
option '`physical_viscosity = "morris"`' numerics 'physical_viscosity = "morris"'
option '`density_diffusion_form = "gradient"`' numerics 'density_diffusion_form = "gradient"'
option '`gradient_correction = "bonet_lok"`' numerics 'gradient_correction = "bonet_lok"'
option '`shifting = 30`' numerics 'shifting = 30'
option '`penalty = { strength = 1 }`' numerics 'penalty = { strength = 1 }'
option 'elastic strength' material.water 'strength = { kind = "elastic", shear_modulus = "10 kPa" }'
