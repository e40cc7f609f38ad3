#!/usr/bin/env bash
# tools/make_pictures.sh
#
# Makes the pictures of runs, reports and sweeps in README and docs anew, from the shipped
# cases.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

"$root/tools/install_packages.sh" build browser
cd "$root"
images=docs/images
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
moraine() { "$build/moraine" "$@" >"$out/log" 2>&1 || { cat "$out/log"; fail "moraine $*"; }; }
picture() { /usr/bin/python3 tools/page_picture.py "$@"; }

moraine run cases/tnt-in-water/case.toml --output "$out/tnt-in-water"
moraine plot "$out/tnt-in-water"
cp "$out/tnt-in-water/plots/pressure_particles_000005.png" $images/tnt-in-water.png
picture "$out/tnt-in-water/report.html" $images/report-laptop.png --height 1500
picture "$out/tnt-in-water/report.html" $images/report-phone.png --phone --at '#curves'
picture "$out/tnt-in-water/report.html" $images/report-player.png --at '#particles' --frame 0.25 --own-range --dark

moraine run cases/dam-break-3d/case.toml --output "$out/dam-break-3d"
picture "$out/dam-break-3d/report.html" $images/report-player-3d.png --at '#particles' --frame 0.5 \
  --colour speed --own-range

moraine sweep cases/tnt-in-water/sweeps/smoothing-factors.toml --output "$out/smoothing-factors"
picture "$out/smoothing-factors/sweep.html" $images/sweep.png --at '#sweep' --height 860
# A frame of a shipped case, coloured by a field.
frame_of() {
  local case=$1 field=$2 frame=$3 image=$4
  moraine run "cases/$case/case.toml" --output "$out/$case"
  moraine plot "$out/$case" --field "$field"
  cp "$out/$case/plots/${field}_particles_$frame.png" "$images/$image.png"
}
frame_of surface-charge-6cm pressure 000003 soil-surface
frame_of crest-charge plastic_strain 000005 soil-slope
frame_of bed-charge material 000004 soil-bed
frame_of c4-in-soil velocity 000005 soil-c4
frame_of c4-in-soil-3d velocity 000004 soil-c4-air
say "pictures: $images"
