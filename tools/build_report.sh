#!/usr/bin/env bash
# tools/build_report.sh [--check]
#
# Makes report/dist, which the program writes its report pages from, out of report/src. Needs Node 18 or
# later with npm; users need neither, as report/dist is part of the sources. With --check it builds into
# a temporary folder and fails where report/dist differs: the same sources give the same bytes.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in
  "" | --check) ;;
  --help)
    print_help "${BASH_SOURCE[0]}"
    exit 0
    ;;
  *) fail "unknown option: $1" ;;
esac
if ! command -v npm >/dev/null; then fail "npm is missing: install Node 18 or later"; fi

cd "$root/report"
npm ci --no-audit --no-fund --silent
npm run --silent typecheck
if [[ ${1:-} != --check ]]; then
  npm run --silent build
  exit 0
fi

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
npm run --silent build -- --out "$out"
diff -r -q "$out" dist || fail "report/dist is not what report/src gives: run tools/build_report.sh"
say "report: dist is up to date"
