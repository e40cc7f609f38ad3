#!/usr/bin/env bash
# tools/check_format.sh [--fix]
#
# Compares all C++ sources, tracked or not, with .clang-format; --fix rewrites them. The version is
# fixed because each version of clang-format has its own idea of the same style.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

formatter=clang-format-14
if ! command -v "$formatter" >/dev/null; then
  fail "$formatter is missing: tools/install_packages.sh format"
fi

mode=(--dry-run -Werror)
if [[ ${1:-} == --fix ]]; then mode=(-i); fi

cd "$root"
mapfile -t files < <(find src tests bench verify -type f \
  \( -name '*.[ch]pp' -o -name '*.cu' -o -name '*.cuh' \) | sort)
if [[ ${#files[@]} -eq 0 ]]; then fail "no sources found below $root"; fi
"$formatter" "${mode[@]}" "${files[@]}"
say "format: ${#files[@]} files"
