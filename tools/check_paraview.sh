#!/usr/bin/env bash
# tools/check_paraview.sh MORAINE
#
# Runs a coarse, short TNT case with the program MORAINE and renders it with ParaView, without a
# screen. Exits with 77 (skipped) where ParaView or Xvfb is not installed: Debian packages paraview,
# python3-paraview, xvfb and xauth, about 730 MB.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

if [[ $# -ne 1 || $1 == -* ]]; then
  print_help "${BASH_SOURCE[0]}"
  exit 2
fi
if ! command -v pvbatch xvfb-run xauth >/dev/null ||
  ! /usr/bin/python3 -c 'import paraview' 2>/dev/null; then
  say "skipped: ParaView (paraview, python3-paraview) or Xvfb (xvfb, xauth) is not installed"
  exit 77
fi

folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
sed -e 's/^spacing = .*/spacing = "2.5 cm"/' -e 's/^end = .*/end = "100 us"/' \
  "$root/cases/tnt-in-water/case.toml" >"$folder/case.toml"
"$1" run "$folder/case.toml" --output "$folder/out" >"$folder/run.log" || {
  cat "$folder/run.log" >&2
  fail "the run to be rendered failed"
}
xvfb-run -a pvbatch "$root/tools/render_with_paraview.py" "$folder/out" "$folder/frame.png"
