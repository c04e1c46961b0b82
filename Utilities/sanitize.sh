#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Build everything with the address and undefined-behaviour sanitizers and run every test:
# sh Utilities/sanitize.sh [options for ctest]
set -eu
. "$(dirname "$0")/setup.sh"

install_packages build test
cd "$root"
# Faults that lie in other people's libraries, and nothing else.
suppressions="$root/Utilities/sanitize"
export ASAN_OPTIONS="detect_stack_use_after_return=1:strict_string_checks=1"
export LSAN_OPTIONS="suppressions=$suppressions/leaks.txt:print_suppressions=0"
export UBSAN_OPTIONS="print_stacktrace=1:suppressions=$suppressions/undefined.txt"

cmake --preset sanitize || fail "configuring failed; the reason stands above"
cmake --build --preset sanitize -j "$(nproc)" || fail "building failed; the reason stands above"
ctest --preset sanitize -j2 "$@"
