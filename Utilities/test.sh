#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Install what is missing, build everything and run every test: sh Utilities/test.sh [options for ctest]
set -eu
. "$(dirname "$0")/setup.sh"

install_packages build demo test
build_project -DSHADOWCONES_BUILD_TESTING=ON -DSHADOWCONES_BUILD_EXAMPLES=ON -DSHADOWCONES_WARNINGS_AS_ERRORS=ON
(cd "$build" && ctest --output-on-failure -j2 "$@")
# A suite of GoogleTest is one test of CTest, whose log has the numbers of each.
for word in PASSED SKIPPED; do
  sed -n "s/^\[  *$word  *\] \([0-9]*\) tests\{0,1\}[.,].*/\1/p" "$build/Testing/Temporary/LastTest.log" |
    awk -v word="$word" '{ sum += $1 } END { printf "%s %d tests of C++\n", word, sum }'
done
# The plugin is a build of its own for another VTK: it is tested where it has been built.
sh "$root/Utilities/paraview.sh" --if-there
printf 'Not tried here: sanitizers, clang, clang-tidy and fresh systems (sh Utilities/matrix.sh)\n'
