#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Try this tree where it is to work, a line each: sh Utilities/matrix.sh [debian-12|debian-13|clang|tidy|paraview|sanitize|thread]...
set -eu
. "$(dirname "$0")/setup.sh"

usage()
{
  printf 'usage: sh Utilities/matrix.sh [debian-12|debian-13|clang|tidy|paraview|sanitize|thread]...\n'
  printf 'debian-12, debian-13  the test command in a fresh system below build-matrix/ (root, network, 4 GB)\n'
  printf 'clang                 build and test with clang, and hold what it computes against the build of test.sh\n'
  printf 'tidy                  clang-tidy over all modules\n'
  printf 'paraview              the plugin and its tests, in a real window\n'
  printf 'sanitize, thread      every test with the sanitizers for addresses and undefined behaviour, or for threads\n'
  printf 'Default: all of them; a machine with two cores takes hours. Logs stand in build-matrix/.\n'
}

matrix="$root/build-matrix"

# The tests of this tree in a fresh Debian of the release named.
try_release()
{
  make_system "$matrix/$1" "$1"
  # Not below /: the tests look for the tree's place in what they install.
  place=home/ShadowCones
  rm -rf "$matrix/$1/$place/Modules" "$matrix/$1/$place/Testing"
  copy_tree "$matrix/$1/$place"
  in_system "$matrix/$1" sh "/$place/Utilities/test.sh"
}

# The other compiler: the same tests, and the same bytes or a line about each difference.
try_clang()
{
  install_packages build demo test clang
  first="$root/build"
  build="$root/build-clang"
  build_project -DSHADOWCONES_BUILD_TESTING=ON -DSHADOWCONES_BUILD_EXAMPLES=ON -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++
  (cd "$build" && ctest --output-on-failure -j2)
  if [ -x "$first/bin/scattering-speed" ]; then
    /usr/bin/python3 "$root/Utilities/compare_builds.py" "$first" "$build"
  else
    printf 'Not compared: %s is not built (sh Utilities/test.sh)\n' "$first"
  fi
}

try_one()
{
  case "$1" in
    debian-12) try_release bookworm ;;
    debian-13) try_release trixie ;;
    clang) try_clang ;;
    tidy) sh "$root/Utilities/tidy.sh" ;;
    paraview) sh "$root/Utilities/paraview.sh" ;;
    sanitize) sh "$root/Utilities/sanitize.sh" ;;
    thread) sh "$root/Utilities/sanitize.sh" thread ;;
  esac
}

[ $# -gt 0 ] || set -- debian-12 debian-13 clang tidy paraview sanitize thread
for name in "$@"; do
  case "$name" in
    debian-12 | debian-13 | clang | tidy | paraview | sanitize | thread) ;;
    --help) usage; exit 0 ;;
    *) usage >&2; exit 2 ;;
  esac
done

mkdir -p "$matrix"
failed=0
for name in "$@"; do
  start=$(date +%s)
  result=passed
  # In a shell of its own: what fails in one place does not keep the others from being tried.
  set +e
  (set -e; try_one "$name") >"$matrix/$name.log" 2>&1
  status=$?
  set -e
  if [ "$status" -ne 0 ]; then
    result=FAILED
    failed=1
    tail -n 20 "$matrix/$name.log"
  fi
  printf '%-10s %-7s %5s s\n' "$name" "$result" "$(($(date +%s) - start))"
done
exit "$failed"
