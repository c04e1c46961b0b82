#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Read the sources of the modules with clang-tidy, as .clang-tidy says: sh Utilities/tidy.sh [FILE]...
# Compiles nothing; it configures build-tidy/ and generates headers. Default: all of Modules; about four seconds a file and core.
set -eu
. "$(dirname "$0")/setup.sh"

install_packages build tidy
cd "$root"
tidy="$root/build-tidy"
mkdir -p "$tidy"
cmake -S . -B "$tidy" -G Ninja -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER=clang \
  -DCMAKE_CXX_COMPILER=clang++ -DSHADOWCONES_BUILD_TESTING=OFF -DSHADOWCONES_BUILD_EXAMPLES=OFF -DSHADOWCONES_WRAP_PYTHON=OFF \
  -DSHADOWCONES_BATCH_TESTS=OFF \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >"$tidy/configure.log" 2>&1 || fail "configuring failed: see $tidy/configure.log"
cmake --build "$tidy" --target Modules/Page/scPageTemplate.h Modules/Page/scPageViewer.h >"$tidy/headers.log" 2>&1 ||
  fail "headers could not be generated: see $tidy/headers.log"
if [ $# -eq 0 ]; then
  # shellcheck disable=SC2046
  set -- $(find Modules -name '*.cxx' ! -path '*/Testing/*' ! -path '*/ParaViewPlugin/*' | sort)
fi
printf '%s\n' "$@" | xargs -P "$(nproc)" -n 4 clang-tidy -p "$tidy" --quiet >"$tidy/report.log" 2>"$tidy/errors.log" ||
  printf 'error: clang-tidy ended early or could not read a file: see %s\n' "$tidy/errors.log" >>"$tidy/report.log"
# What a header has is said once for each file that includes it.
grep -hE '(warning|error): ' "$tidy/report.log" "$tidy/errors.log" | sed "s|$root/||" | sort -u || true
count=$(grep -hE '(warning|error): ' "$tidy/report.log" "$tidy/errors.log" | sort -u | wc -l)
printf '%s files, %s findings\n' "$#" "$count"
[ "$count" -eq 0 ]
