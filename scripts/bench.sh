#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the benchmarks, runs them and prints their tables of ratios; the times go to a file.
# usage: scripts/bench.sh [front_end|recognition]...   default: both
set -euo pipefail
cd "$(dirname "$0")/.."

benches=("$@")
[ ${#benches[@]} -gt 0 ] || benches=(front_end recognition)
for name in "${benches[@]}"; do
  case $name in front_end | recognition) ;; *)
    echo "error: no benchmark '$name'; there are front_end and recognition" >&2
    exit 2
    ;;
  esac
done

targets=("${benches[@]/%/_bench}")
scripts/install.sh bench
cmake --preset release -DTRIHEDRON_BENCH=ON >/dev/null
cmake --build --preset release --target "${targets[@]/#/trihedron_}"
mkdir -p out
for name in "${benches[@]}"; do
  times=out/bench_$name.txt
  "build/release/bench/trihedron_${name}_bench" >"$times" 2>&1
  sed -n '/^ratio of times/,$p' "$times"
  echo "(times and stages: $times)"
done
