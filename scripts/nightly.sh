#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The long runs: soak, all proofs, instances of other parameters, coverage, mutation, fuzzing, upsets. Takes hours
# of CPU time; everything goes to build/nightly. usage: scripts/nightly.sh [FRAMES OF THE SOAK]
set -uo pipefail
cd "$(dirname "$0")/.."

scripts/build.sh
out=build/nightly
mkdir -p $out
status=0
step() {
  local name=$1
  shift
  "$@" >$out/"$name".log 2>&1 || { echo "$name: FAILED, see $out/$name.log"; status=1; return; }
  echo "$name: $(tail -1 $out/"$name".log)"
}

step soak build/release/sw/cli/trihedron verify --frames "${1:-100000}" --seed 1000000 \
  --jobs "$(nproc)" --pictures testvectors/scenes testvectors/photographs \
  --junit $out/soak.xml --coverage $out/soak.json
step proofs tests/formal/prove.sh
RUNS=100 step parameters tests/parameters/parameters.sh
step coverage tests/coverage/coverage.sh 6000
step mutation tests/mutation/mutation.sh
step fuzz tests/fuzz/fuzz.sh --seconds 3600
step upsets tests/faults/upsets.sh --upsets 5000
exit $status
