#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Build everything with sanitizers and run every test:
# sh Utilities/sanitize.sh [options for ctest]         address and undefined behaviour; then the lines that the tests reached
# sh Utilities/sanitize.sh thread [options for ctest]  threads, with the backend STDThread of VTK
set -eu
. "$(dirname "$0")/setup.sh"

preset=sanitize
if [ "${1:-}" = thread ]; then
  preset=thread
  shift
fi

install_packages build test sanitize
cd "$root"
# Faults that lie in other people's libraries, and nothing else.
suppressions="$root/Utilities/sanitize"
# One definition of a constant in two libraries is no fault where both are the same: fuzz-replay has sources of Words of its own.
export ASAN_OPTIONS="detect_stack_use_after_return=1:strict_string_checks=1:detect_odr_violation=1"
export LSAN_OPTIONS="suppressions=$suppressions/leaks.txt:print_suppressions=0"
export UBSAN_OPTIONS="print_stacktrace=1:suppressions=$suppressions/undefined.txt"
export TSAN_OPTIONS="halt_on_error=0:exitcode=66:second_deadlock_stack=1:suppressions=$suppressions/threads.txt"
if [ "$preset" = thread ]; then
  # Threads of TBB are started by code that was built without the sanitizer: what they wait for is not seen.
  export VTK_SMP_BACKEND_IN_USE=STDThread
fi

cmake --preset "$preset" || fail "configuring failed; the reason stands above"
cmake --build --preset "$preset" -j "$(nproc)" || fail "building failed; the reason stands above"
find "build-$preset" -name '*.gcda' -delete
status=0
# Left out: tests that take disks or addresses away, of which the sanitizers and the counts of lines need some themselves.
ctest --preset "$preset" -j2 --exclude-regex '^Robustness.(faults|files)$' "$@" || status=$?
[ "$preset" = thread ] || python3 "$root/Utilities/sanitize/reached_lines.py" "build-$preset"
exit "$status"
