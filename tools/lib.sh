# What ./run, ./test, .ci/run and the scripts in tools/ share. To be sourced, not run.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
build="$root/build"
jobs=$(nproc)

say() { printf -- '-- %s\n' "$*"; }

fail() {
  printf -- '-- error: %s\n' "$*" >&2
  exit 1
}

# The comment at the top of a script is its help text.
print_help() { sed -n '2,/^[^#]/{s/^# \{0,1\}//p}' "$1"; }

# ./run and ./test must agree on these, or each would recompile everything after the other.
# Warnings are errors in both: the compiler is the one that the packages name.
build_options=(CMAKE_BUILD_TYPE=Release MORAINE_TESTS=ON "MORAINE_WERROR=${MORAINE_WERROR:-ON}")

# Folder for the results of `moraine run CASE OPTIONS`: that of the last --output among the options, or
# else out/<name of the case>: the name of the folder for a file "case.toml", the file's own for others.
output_of() {
  local path output
  path=$(realpath -m -- "$1")
  output=$(basename "$path")
  output=${output%.*}
  if [[ $output == case ]]; then output=$(basename "$(dirname "$path")"); fi
  output="out/$output"
  shift
  while [[ $# -gt 0 ]]; do
    case $1 in
      -o | --output)
        output=${2:-}
        shift
        ;;
      --output=*) output=${1#--output=} ;;
      -o?*) output=${1#-o} ;;
    esac
    shift
  done
  printf '%s\n' "$output"
}

cache_has() { grep -Eqs "^$1:[A-Z]*=$2\$" "$build/CMakeCache.txt"; }

is_configured() {
  [[ -e $build/build.ninja || -e $build/Makefile ]] || return 1
  local option
  for option in "${build_options[@]}"; do
    cache_has "${option%%=*}" "${option#*=}" || return 1
  done
}

configure() {
  local arguments=(-S "$root" -B "$build" "${build_options[@]/#/-D}")
  if ! grep -Fqsx "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
    arguments+=(--fresh -G Ninja)  # no cache yet, or one that belongs to another folder
  elif is_configured; then
    return 0
  fi
  say "configure: ${build_options[*]}"
  cmake "${arguments[@]}" --log-level=NOTICE >"$build/configure.log" 2>&1 || {
    cat "$build/configure.log" >&2
    fail "configuring failed; the same text is in $build/configure.log"
  }
}

# Everything that is needed to run: packages, configuration, program and tests.
prepare() {
  "$root/tools/install_packages.sh" "$@"
  mkdir -p "$build"
  configure
  say "build: $build"
  cmake --build "$build" --parallel "$jobs"
}
