#!/usr/bin/env bash
# tools/install_packages.sh [GROUP...]
#
# Installs those Debian packages of tools/packages.txt that are missing. GROUP: build (default),
# reader, schema, browser, node, format, tidy, clang. When nothing is missing it returns at once and needs neither network nor rights.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

groups=" ${*:-build} "
wanted=()
while read -r group package; do
  if [[ $groups == *" $group "* ]]; then wanted+=("$package"); fi
done < <(grep -v '^#' "$root/tools/packages.txt")
if [[ ${#wanted[@]} -eq 0 ]]; then fail "no package group named:$groups"; fi

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  fail "this script knows Debian's apt only. Install what these Debian packages hold:" \
    "${wanted[*]} - and build with: cmake -S . -B build && cmake --build build"
fi

present=" $(dpkg-query -W -f '${Package}:${db:Status-Status} ' "${wanted[@]}" 2>/dev/null || true)"
missing=()
for package in "${wanted[@]}"; do
  if [[ $present != *" $package:installed "* ]]; then missing+=("$package"); fi
done
if [[ ${#missing[@]} -eq 0 ]]; then
  say "packages: all ${#wanted[@]} are installed"
  exit 0
fi

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    fail "packages are missing and there is no sudo. As root: apt-get install ${missing[*]}"
  fi
  as_root=(sudo)
fi

say "packages: installing ${missing[*]}"
mkdir -p "$build"
log="$build/install_packages.log"
apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q "$@" >>"$log" 2>&1; }
: >"$log"
# An outdated index is no reason to stop, as long as the packages can be had.
apt update || say "packages: 'apt-get update' failed, trying with the index as it is"
if ! apt install -y --no-install-recommends "${missing[@]}"; then
  tail -n 20 "$log" >&2
  fail "apt-get install failed; the whole output is in $log"
fi
