# shellcheck shell=sh
# Sourced by .ci/run, .ci/submit and .ci/full in the root of the repository. Defines the checks, and how a step is shown and timed.
jobs=$(nproc)
began=$(date +%s)
summary=
current=start
trap '[ $? -eq 0 ] || echo "== $current: FAILED" >&2' EXIT

# step NAME COMMAND...: runs a command under a name. The first failure ends the run through set -e, which "||" would disable
# inside the command.
step() {
  current=$1
  shift
  echo "== $current"
  started=$(date +%s)
  "$@"
  echo "== $current: ok, $(($(date +%s) - started)) s"
}

# tested NAME COMMAND...: runs a step that ends in ctest, and stores the total for the summary.
tested() {
  preset=$1
  shift
  mkdir -p build
  step "$preset: tests" logged "build/$preset-tests.log" "$@"
  tests=$("build/$preset/tests/percuss_tests" --gtest_list_tests | grep -c '^  ')
  summary="$summary$preset: $(grep 'tests passed' "build/$preset-tests.log"), with $tests test cases
"
}

# logged FILE COMMAND...: prints the output of a command, stores it in a file, and returns the exit status of the command; a
# plain pipe would return the status of tee.
logged() {
  log=$1
  shift
  { "$@" 2>&1 && echo 0 >"$log.status" || echo 1 >"$log.status"; } | tee "$log"
  status=$(cat "$log.status")
  rm -f "$log.status"
  return "$status"
}

totals() {
  printf '%s' "$summary"
  echo "all checks passed in $(($(date +%s) - began)) s"
}

build() {
  cmake --preset "$1" -DPERCUSS_WERROR=ON >/dev/null
  cmake --build --preset "$1" --parallel "$jobs"
}

all_sources() { git ls-files --cached --others --exclude-standard '*.cpp' '*.hpp'; }

# include_patterns PATH: the ways to write a header in an #include: its path, and the path without its first folder, without
# its first two folders, and so on.
include_patterns() {
  header=$1
  while printf '"%s"\n<%s>\n' "$header" "$header"; do
    case $header in
      */*) header=${header#*/} ;;
      *) return ;;
    esac
  done
}

# The changed .cpp and .hpp files. Without a commit to compare with, all files.
changed_files() {
  base=${CI_BASE:-$(git merge-base HEAD '@{upstream}' 2>/dev/null || true)}
  if [ -z "$base" ] || { [ -z "${CI_BASE:-}" ] && [ "$base" = "$(git rev-parse HEAD)" ]; }; then
    base=$(git rev-parse --verify --quiet HEAD~1) || { all_sources; return; }
  fi
  git diff --name-only --diff-filter=d "$base" -- '*.cpp' '*.hpp'
  git ls-files --others --exclude-standard '*.cpp' '*.hpp'
}

# The changed .cpp files, and for each changed header the .cpp file of the same name, or one file that includes the header.
changed_sources() {
  changed_files | while read -r file; do
    case $file in
      *.cpp) echo "$file" ;;
      *) if [ -f "${file%.hpp}.cpp" ]; then echo "${file%.hpp}.cpp"; else including "$file" | head -n 1; fi ;;
    esac
  done | sort -u
}

# The changed .cpp files, and all .cpp files that include a changed header.
affected_sources() {
  changed_files | while read -r file; do
    case $file in
      *.cpp) echo "$file" ;;
      *) including "$file" ;;
    esac
  done | sort -u
}

# including HEADER: the .cpp files that include it.
including() { all_sources | grep '\.cpp$' | xargs grep -lF "$(include_patterns "$1")" || true; }

# tidy FILES: runs clang-tidy on the compiled .cpp files of the list. Files of one unity unit are checked together, in a unit
# of only these files, because parsing the headers of libraries takes most of the time.
tidy() {
  cmake --preset tidy -B build/tidy-units -DPERCUSS_UNITY_BUILD=ON >/dev/null
  printf '%s\n' "$1" >build/tidy-units/files
  find build/tidy-units -name 'unity_*.cxx' | while read -r unit; do
    sed -n "s|^#include \"$PWD/\(.*\)\"\$|\1|p" "$unit" | { grep -xF -f build/tidy-units/files || true; } |
      sed "s|.*|#include \"$PWD/&\"|" >"$unit.wanted"
    mv "$unit.wanted" "$unit"
    [ ! -s "$unit" ] || echo "$unit"
  done | xargs -r -P "$jobs" -n 1 clang-tidy -p build/tidy-units --quiet --checks=-bugprone-suspicious-include \
    --header-filter='.*/(src|tools|tests|bench|python)/.*\.[ch]pp$'
}

check_layout() { all_sources | xargs clang-format --dry-run -Werror; }

check_scripts() { grep -lE '^#!/bin/(ba)?sh|shellcheck shell=' start .ci/* | xargs shellcheck; }

# Checks that percuss_accuracy makes all files docs/project/accuracy*, and that README.md shows the table of
# docs/project/accuracy.md.
check_accuracy_page() {
  made=$(mktemp -d)
  build/release/bench/percuss_accuracy --quick "$made" >/dev/null
  for file in docs/project/accuracy*; do
    [ -s "$made/${file#docs/project/}" ] || { echo "percuss_accuracy does not make $file" >&2; return 1; }
  done
  rm -rf "$made"
  sed -n '/^| from records with/,/^$/p' README.md | grep . >build/accuracy-rows
  [ "$(grep -cvxFf docs/project/accuracy.md build/accuracy-rows)" -eq 0 ] ||
    { echo "README.md and docs/project/accuracy.md show different figures" >&2; return 1; }
}

# Builds the Debian package from the release build, and runs the tool from the unpacked package.
check_package() {
  rm -rf build/package
  cpack --config build/release/CPackConfig.cmake -B build/package >/dev/null
  deb=$(ls build/package/percuss_*.deb)
  dpkg-deb -I "$deb" | sed -n '/Package\|Version\|Depends\|Installed-Size/p'
  dpkg-deb -c "$deb" >build/package/list
  for path in bin/percuss include/percuss/analysis.hpp 'lib.*/libpercuss_api.a' 'lib.*/percussConfig.cmake' share/doc/percuss/copyright \
    share/man/man1/percuss-model-beam.1 share/bash-completion/completions/percuss share/zsh/site-functions/_percuss share/fish/vendor_completions.d/percuss.fish; do
    grep -q " \./usr/$path\$" build/package/list || { echo "the package lacks /usr/$path" >&2; return 1; }
  done
  dpkg-deb -x "$deb" build/package/root
  build/package/root/usr/bin/percuss --version
}
