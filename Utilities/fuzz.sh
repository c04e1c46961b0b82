#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Give bytes that libFuzzer finds to whatever reads data and texts of strangers, with the sanitizers for addresses and undefined behaviour:
# sh Utilities/fuzz.sh [--seconds N] [--runs N] [--total N] [--jobs N] [HARNESS]...
#   --seconds  time of each harness; 60 by default, and without a limit where --runs or --total stand alone
#   --runs     executions of each harness
#   --total    executions of each harness, those of all runs before counted too: a harness that has as many is left out
#   --jobs     harnesses side by side; 1 by default
# Harnesses, all by default: words options field-data light mesh chain vectors cone-set volume bricks density fog
# (Testing/Fuzz).
# How often each has been executed in all runs is kept in build-fuzz/executions, also where a run is ended by a signal. A new build
# goes on from Testing/Fuzz/executions.txt; build-fuzz/executions.txt takes its place where counts are to be handed on (by one machine after the other).
# Inputs that broke something lie in build-fuzz/found; mend it, and add them with Testing/Fuzz/corpus.py.
set -eu
. "$(dirname "$0")/setup.sh"

counts="$root/build-fuzz/executions"
every="words options field-data light mesh chain vectors cone-set volume bricks density fog"

# What a log says that was executed: its last line, or the last of those in between where the program had no time for it.
executions_of()
{
  [ -e "$1" ] || return 0
  said=$(sed -n 's/^stat::number_of_executed_units: *//p' "$1" | tail -n 1)
  [ -n "$said" ] || said=$(sed -n 's/^#\([0-9][0-9]*\).*/\1/p' "$1" | tail -n 1)
  printf '%s' "$said"
}

kept_of()
{
  kept=$(cat "$counts/$1" 2>/dev/null || true)
  printf '%s' "${kept:-0}"
}

# Add what the log of a harness says to what is kept of it, once: the log is another's from then on.
keep()
{
  log="$root/build-fuzz/$1.log"
  [ -e "$log" ] || return 0
  more=$(executions_of "$log")
  printf '%s\n' $(($(kept_of "$1") + ${more:-0})) >"$counts/$1.new"
  mv "$log" "$root/build-fuzz/$1.last.log"
  mv "$counts/$1.new" "$counts/$1"
}

# A harness as the variables SECONDS_EACH, RUNS and TOTAL say.
run_harness()
{
  harness=$1
  case "$harness" in
    words | options | field-data) program=fuzz-$harness length=256 ;;
    *) program=fuzz-data length=600 ;;
  esac
  keep "$harness"
  runs=$RUNS
  if [ "$TOTAL" -gt 0 ]; then
    missing=$((TOTAL - $(kept_of "$harness")))
    if [ "$missing" -le 0 ]; then
      printf '%-12s has its %s executions\n' "$harness" "$TOTAL"
      return 0
    fi
    if [ "$runs" -lt 0 ] || [ "$runs" -gt "$missing" ]; then
      runs=$missing
    fi
  fi
  corpus="$root/build-fuzz/corpus/$harness"
  mkdir -p "$corpus" "$root/build-fuzz/seeds/$harness"
  dictionary="$root/Testing/Fuzz/$harness.dict"
  # The limit of an input is by the clock: long enough for a machine that others use too.
  options="-max_len=$length -timeout=120 -rss_limit_mb=3000 -print_final_stats=1 -reload=0 -max_total_time=$SECONDS_EACH -runs=$runs"
  if [ "$program" = fuzz-data ]; then
    # Weights of inputs by how rare their paths are took a quarter of the time of density: these programs have many paths.
    options="$options -entropic=0"
  fi
  if [ -e "$dictionary" ]; then
    options="$options -dict=$dictionary"
  fi
  status=0
  # shellcheck disable=SC2086
  SHADOWCONES_HARNESS=$harness "build-fuzz/bin/$program" $options -artifact_prefix="$root/build-fuzz/found/$harness-" \
    "$corpus" "$root/build-fuzz/seeds/$harness" >"$root/build-fuzz/$harness.log" 2>&1 || status=1
  keep "$harness"
  log="$root/build-fuzz/$harness.last.log"
  if [ "$status" -ne 0 ]; then
    grep -hE 'broken promise|ERROR: |runtime error|Test unit written' "$log" || tail -n 3 "$log"
  fi
  executions=$(executions_of "$log")
  rate=$(sed -n 's/^stat::average_exec_per_sec: *//p' "$log")
  printf '%-12s %12s executions, %8s a second, %12s in all\n' "$harness" "${executions:-?}" "${rate:-?}" "$(kept_of "$harness")"
  return "$status"
}

# Freed memory is kept long enough to find its use, and short enough to stay in the cache of the processor.
export ASAN_OPTIONS="detect_leaks=0:allocator_may_return_null=1:quarantine_size_mb=16:malloc_context_size=1"
export UBSAN_OPTIONS="print_stacktrace=1"
if [ "${1:-}" = --alone ]; then # one of those side by side
  cd "$root"
  run_harness "$2"
  exit
fi

SECONDS_EACH=""
RUNS=-1
TOTAL=0
jobs=1
while [ $# -gt 0 ]; do
  case "$1" in
    --seconds | --runs | --total | --jobs)
      expr "${2:-}" : '[0-9][0-9]*$' >/dev/null || fail "$1 wants a number"
      case "$1" in
        --seconds) SECONDS_EACH=$2 ;;
        --runs) RUNS=$2 ;;
        --total) TOTAL=$2 ;;
        --jobs) jobs=$2 ;;
      esac
      shift 2
      ;;
    -*) fail "there is no option $1" ;;
    *) break ;;
  esac
done
if [ -z "$SECONDS_EACH" ]; then
  SECONDS_EACH=60
  if [ "$RUNS" -ge 0 ] || [ "$TOTAL" -gt 0 ]; then
    SECONDS_EACH=0
  fi
fi
export SECONDS_EACH RUNS TOTAL
# shellcheck disable=SC2086
[ $# -gt 0 ] || set -- $every

install_packages build fuzz
cd "$root"
if [ ! -e build-fuzz/build.ninja ]; then
  cmake --preset fuzz || fail "configuring failed; the reason stands above"
fi
cmake --build --preset fuzz -j "$(nproc)" || fail "building failed; the reason stands above"

mkdir -p build-fuzz/found "$counts"
for harness in $every; do
  [ -e "$counts/$harness" ] || sed -n "s/^$harness //p" Testing/Fuzz/executions.txt >"$counts/$harness"
done
python3 Testing/Fuzz/corpus.py unpack build-fuzz/seeds
lost=0
printf '%s\n' "$@" | xargs -P "$jobs" -n 1 sh Utilities/fuzz.sh --alone || lost=1
{
  sed -n '/^#/p' Testing/Fuzz/executions.txt
  for harness in $every; do
    printf '%s %s\n' "$harness" "$(kept_of "$harness")"
  done
} >build-fuzz/executions.txt
awk '!/^#/ { if ($1 ~ /words|options|field-data/) parsers += $2; else filters += $2 }
  END { printf "executions in all runs: parsers %.0f, filters %.0f\n", parsers, filters }' build-fuzz/executions.txt
[ "$lost" -eq 0 ] || fail "something was lost; what, stands above"
printf 'lost: 0\n'
