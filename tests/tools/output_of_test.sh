#!/usr/bin/env bash
# What tools/lib.sh says about the folder for results; the rule that `moraine run` follows too.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../tools/lib.sh"

failures=0
expect() {
  local wanted=$1 found
  shift
  found=$(output_of "$@")
  if [[ $found != "$wanted" ]]; then
    say "output_of $*: $found instead of $wanted"
    failures=$((failures + 1))
  fi
}

expect out/sod cases/sod/case.toml
expect out/foo foo.toml
expect out/foo some/where/foo.toml --threads 2
expect out/lib "$root/tools/../../tools/lib.sh"
expect here foo.toml --output here
expect here foo.toml -o here
expect here foo.toml -ohere
expect here foo.toml -t 2 --output=here
expect "a b" foo.toml --output "a b"
exit $((failures > 0))
