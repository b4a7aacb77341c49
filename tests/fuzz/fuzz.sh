#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the fuzzing harnesses with clang, ASan and UBSan and runs them, each from its kept corpus.
# usage: fuzz.sh [--seconds N | --short] [--build DIR] [HARNESS...]
#   HARNESS      scene, mesh, results, stream; all without
#   --seconds N  processor time for each (default 60), whatever else the machine does
#   --short      the corpus and some thousand inputs more, with the programs in DIR: for CTest
# New inputs, findings and logs go to DIR/fuzz/HARNESS. Exit code 1 with a finding, 77 without clang.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=60 short= build=build/sanitize harnesses=()
while [ $# -gt 0 ]; do
  case $1 in
    --seconds) seconds=$2; shift ;;
    --build) build=$2; shift ;;
    --short) short=yes ;;
    scene | mesh | results | stream) harnesses+=("$1") ;;
    *) echo "fuzz.sh: $1 is neither an option nor a harness; see its first lines" >&2; exit 2 ;;
  esac
  shift
done
[ ${#harnesses[@]} -gt 0 ] || harnesses=(scene mesh results stream)
if [ -z "$short" ]; then
  command -v clang++ >/dev/null || { echo "fuzz.sh: skipped, clang is not installed"; exit 77; }
  [ -f "$build/build.ninja" ] || cmake --preset sanitize >/dev/null
  cmake --build "$build" --target "${harnesses[@]/#/trihedron_fuzz_}" >/dev/null
fi
export UBSAN_OPTIONS=print_stacktrace=1
# Inputs become files for the readers: thousands a second, better in memory.
[ ! -w /dev/shm ] || export TMPDIR=${TMPDIR:-/dev/shm}

# cpu: processor seconds of the children that have ended. Not in a subshell, which has its own.
count_cpu() {
  times >"$work/times"
  cpu=$(awk 'NR == 2 { for (i = 1; i <= 2; i++) { split($i, t, /[ms]/); s += 60 * t[1] + t[2] } print int(s) }' \
    "$work/times")
}

# run NAME OPTIONS...: the harness with its corpora.
run() {
  local name=$1
  shift
  [ ! -f "tests/fuzz/$name.dict" ] || set -- "$@" "-dict=tests/fuzz/$name.dict"
  "$build/tests/fuzz/trihedron_fuzz_$name" "$@" -timeout=60 -rss_limit_mb=4096 -max_len=4096 \
    -print_final_stats=1 "-artifact_prefix=$work/" "$work/corpus" "tests/fuzz/corpus/$name" \
    >>"$work/log" 2>&1
}

status=0
for name in "${harnesses[@]}"; do
  work=$build/fuzz/$name
  mkdir -p "$work/corpus"
  : >"$work/log"
  found=
  count_cpu
  start=$cpu
  if [ -n "$short" ]; then
    run "$name" -runs="$([ "$name" = stream ] && echo 150 || echo 3000)" -seed=1 || found=yes
    count_cpu
  fi
  # In rounds, since libFuzzer's limit is the clock on the wall.
  while [ -z "$short$found" ] && [ $((cpu - start)) -lt "$seconds" ]; do
    left=$((seconds - cpu + start))
    run "$name" -max_total_time=$((left < 300 ? left : 300)) || found=yes
    count_cpu
  done
  inputs=$(awk '/number_of_executed_units/ { n += $2 } END { print n + 0 }' "$work/log")
  echo "$name: ${found:+FINDING, }$inputs inputs, $((cpu - start)) s of processor time," \
    "corpus $(find "$work/corpus" -type f | wc -l); log $work/log"
  if [ -n "$found" ]; then
    status=1
    grep -E -A8 '^==[0-9]+==ERROR|^fuzz:|runtime error|^SUMMARY|Test unit written' "$work/log" | tail -30
  fi
done
exit $status
