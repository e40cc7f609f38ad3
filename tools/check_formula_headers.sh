#!/usr/bin/env bash
# tools/check_formula_headers.sh [--self-test | HEADER...]
#
# Headers with formulas must also work in device code: each has to compile alone, without exceptions
# and without run-time type information. Checks all headers of the folders below, or those given.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

folders=(smoothing matter/burn matter/eos terms)

# Checks one header in a process of its own, see below. Device compilers skip the pragmas of OpenMP.
check_header() {
  printf '#include "%s"\n' "$1" |
    "${CXX:-g++}" -x c++ -std=c++20 -fsyntax-only -fno-exceptions -fno-rtti \
      -Wall -Wextra -Werror -Wno-unknown-pragmas "-I$root/src" - ||
    { printf '%s: does not compile alone as a formula header\n' "$1" >&2 && return 1; }
}
export -f check_header
export root

check_headers() {
  printf '%s\0' "$@" | xargs -0 -n 1 -P "$jobs" bash -c 'check_header "$1"' check_header ||
    return 1
  say "formula headers: $# compile alone without exceptions and run-time type information"
}

self_test() {
  samples=$(mktemp -d)
  trap 'rm -r "$samples"' EXIT
  printf '#pragma once\ninline double twice(double x) { return 2 * x; }\n' >"$samples/good.hpp"
  printf '#pragma once\ninline void stop() { throw 1; }\n' >"$samples/throws.hpp"
  printf '#pragma once\ninline std::string name();\n' >"$samples/forgets_include.hpp"
  check_headers "$samples/good.hpp" || fail "self-test: a sound header was refused"
  local bad
  for bad in throws forgets_include; do
    if check_headers "$samples/$bad.hpp" 2>/dev/null; then
      fail "self-test: $bad.hpp got through"
    fi
  done
  say "formula headers: self-test passed"
}

if [[ ${1:-} == --self-test ]]; then
  self_test
elif [[ $# -gt 0 ]]; then
  check_headers "$@"
else
  cd "$root/src"
  mapfile -t headers < <(find "${folders[@]}" -type f -name '*.hpp' | sort)
  if [[ ${#headers[@]} -eq 0 ]]; then fail "no headers found in ${folders[*]}"; fi
  check_headers "${headers[@]}"
fi
