#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Give bytes that libFuzzer finds to whatever reads data and texts of strangers, with the sanitizers for addresses and undefined behaviour:
# sh Utilities/fuzz.sh [--seconds N] [--runs N] [HARNESS]...    default: 60 seconds of each harness; with --runs alone no limit of time
# Harnesses: words options field-data light mesh chain vectors cone-set volume density (Testing/Fuzz).
# Inputs that broke something lie in build-fuzz/found; mend it, and add them with Testing/Fuzz/corpus.py.
set -eu
. "$(dirname "$0")/setup.sh"

seconds=60
runs=-1
while [ $# -gt 0 ]; do
  case "$1" in
    --seconds | --runs)
      expr "${2:-}" : '[0-9][0-9]*$' >/dev/null || fail "$1 wants a number"
      [ "$1" = --runs ] || seconds=$2
      if [ "$1" = --runs ]; then
        runs=$2
        seconds=0
      fi
      shift 2
      ;;
    *) break ;;
  esac
done
[ $# -gt 0 ] || set -- words options field-data light mesh chain vectors cone-set volume density

install_packages build fuzz
cd "$root"
if [ ! -e build-fuzz/build.ninja ]; then
  cmake --preset fuzz || fail "configuring failed; the reason stands above"
fi
cmake --build --preset fuzz -j "$(nproc)" || fail "building failed; the reason stands above"

# Freed memory is kept long enough to find its use, and short enough to stay in the cache of the processor.
export ASAN_OPTIONS="detect_leaks=0:allocator_may_return_null=1:quarantine_size_mb=16:malloc_context_size=1"
export UBSAN_OPTIONS="print_stacktrace=1"
found="$root/build-fuzz/found"
mkdir -p "$found"
python3 Testing/Fuzz/corpus.py unpack build-fuzz/seeds
lost=0
for harness in "$@"; do
  case "$harness" in
    words | options | field-data) program=fuzz-$harness length=256 ;;
    *) program=fuzz-data length=600 ;;
  esac
  corpus="$root/build-fuzz/corpus/$harness"
  mkdir -p "$corpus" "$root/build-fuzz/seeds/$harness"
  dictionary="$root/Testing/Fuzz/$harness.dict"
  options="-max_len=$length -timeout=120 -rss_limit_mb=3000 -print_final_stats=1 -max_total_time=$seconds -runs=$runs"
  if [ -e "$dictionary" ]; then
    options="$options -dict=$dictionary"
  fi
  # The limit of an input is by the clock: long enough for a machine that others use too.
  log="$root/build-fuzz/$harness.log"
  # shellcheck disable=SC2086
  SHADOWCONES_HARNESS=$harness "build-fuzz/bin/$program" $options -artifact_prefix="$found/$harness-" \
    "$corpus" "$root/build-fuzz/seeds/$harness" >"$log" 2>&1 || {
    lost=$((lost + 1))
    grep -hE 'broken promise|ERROR: |runtime error|Test unit written' "$log" || tail -n 3 "$log"
  }
  executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  rate=$(sed -n 's/^stat::average_exec_per_sec: *//p' "$log")
  printf '%-12s %12s executions, %8s a second\n' "$harness" "${executions:-?}" "${rate:-?}"
done
printf 'lost: %s\n' "$lost"
[ "$lost" -eq 0 ]
