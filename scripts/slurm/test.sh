#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tries the job array on a real Slurm (scripts/slurm/local_cluster.sh): the bundled scenes and a
# regression in three shards each, merged, must give what one process gives; a second submission
# must skip every shard.
# usage: scripts/slurm/test.sh [WORK_FOLDER]   as root, after scripts/install.sh slurm
set -euo pipefail
cd "$(dirname "$0")/../.."
if [ -z "${SLURM_CONF:-}" ]; then exec scripts/slurm/local_cluster.sh "$0" "$@"; fi

work=${1:-$(mktemp -d)}
work=$(realpath -m "$work")
program=build/release/sw/cli/trihedron
evaluate=(evaluate testvectors/scenes --models testvectors/models10 --frontend golden --csv)
verify=(verify --frames 60 --seed 3)

wait_for() {  # until no job is left
  while [ -n "$(squeue -h -o %i)" ]; do read -rt 1 <> <(:) || true; done
}
without_times() { sed -e 's/,[^,]*$//' "$1"; }
fail() { echo "slurm test: $*" >&2; exit 1; }

mkdir -p "$work"
"$program" "${evaluate[@]}" "$work/whole.csv" >"$work/whole.txt"
"$program" "${verify[@]}" >"$work/verify.txt"
sinfo --version
for round in first second; do
  scripts/slurm/job_array.sh 3 "$work/evaluate" "${evaluate[@]}" "$work/merged.csv"
  scripts/slurm/job_array.sh 3 "$work/verify" "${verify[@]}"
  wait_for
  [ -s "$work/evaluate/merged.txt" ] || { cat "$work"/evaluate/*.log >&2; fail "no merged result"; }
  diff <(without_times "$work/whole.csv") <(without_times "$work/merged.csv") || fail "results differ"
  diff <(sed '/ms per scene/,$d' "$work/whole.txt") <(sed '/ms per scene/,$d' "$work/evaluate/merged.txt") ||
    fail "tables differ"
  diff <(sed 's/, [0-9.]* s$//' "$work/verify.txt") <(sed 's/, [0-9.]* s$//' "$work/verify/merged.txt") ||
    fail "regressions differ"
  if [ $round = second ]; then
    [ "$(grep -l 'done before' "$work"/*/task-*.log | wc -l)" -eq 6 ] || fail "a finished shard ran again"
  fi
done
echo "slurm test: 2 job arrays of 3 shards equal the whole runs; finished shards are skipped"
