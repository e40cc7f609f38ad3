#!/usr/bin/env bash
# tools/run_clang_tidy.sh [SOURCE.cpp...]
#
# Runs clang-tidy with .clang-tidy over the given sources, or over all of src/. For developers: it
# takes longer than a build and is no part of .ci/run. Needs a configured build folder (./test).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

"$root/tools/install_packages.sh" tidy
if [[ ! -e $build/compile_commands.json ]]; then
  fail "there is no $build/compile_commands.json: run ./test first"
fi
if [[ $# -gt 0 ]]; then
  mapfile -t files < <(realpath -- "$@")
else
  mapfile -t files < <(find "$root/src" -name '*.cpp' | sort)
fi

# Clang reads commands meant for GCC: flags that it does not know are no finding, and omp.h is among
# GCC's own headers, to be looked for after all others.
printf '%s\0' "${files[@]}" |
  xargs -0 -n 1 -P "$jobs" clang-tidy-14 -p "$build" --quiet \
    --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-ignored-optimization-argument \
    "--extra-arg=-idirafter$(g++ -print-file-name=include)"
say "clang-tidy: ${#files[@]} sources without findings"
