#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs evaluate, verify or simulate as a Slurm job array: a task per shard, then a job that merges.
# A task that is done already is skipped, so the same call goes on after a time limit or a failure.
#
# usage: scripts/slurm/job_array.sh SHARDS RESULTS COMMAND [OPTIONS]
#        TRIHEDRON=program (default: build/release/sw/cli/trihedron or the one in PATH)
#        SBATCH_OPTIONS="--time=1:00:00 --mem=2G --partition=..."  for the tasks and the merging
# e.g.   scripts/slurm/job_array.sh 8 shards evaluate scenes --models models --csv results.csv
# Prints the numbers of the two jobs; the merged output goes to RESULTS/merged.txt.
set -euo pipefail

if [ $# -lt 3 ] || ! [[ $1 =~ ^[1-9][0-9]*$ ]]; then
  echo "usage: $0 SHARDS RESULTS COMMAND [OPTIONS], such as: $0 8 shards evaluate scenes --models parts" >&2
  exit 2
fi
command -v sbatch >/dev/null || {
  echo "error: no sbatch; expected to run on a machine that submits to Slurm" >&2
  exit 2
}
shards=$1
results=$2
shift 2
program=${TRIHEDRON:-$(dirname "$0")/../../build/release/sw/cli/trihedron}
[ -x "$program" ] || program=$(command -v trihedron) || {
  echo "error: no program; expected a built Trihedron, or TRIHEDRON=program" >&2
  exit 2
}
mkdir -p "$results"
# Quoted once for the shell that runs the task.
command=$(printf '%q ' "$(realpath "$program")" "$@" --results "$results")
read -ra more <<<"${SBATCH_OPTIONS:-}"

array=$(sbatch --parsable --job-name=trihedron --array="1-$shards" --output="$results/task-%a.log" \
  ${more[@]+"${more[@]}"} --wrap "exec $command --shard \$SLURM_ARRAY_TASK_ID/$shards")
merge=$(sbatch --parsable --job-name=trihedron-merge --dependency="afterok:$array" \
  --kill-on-invalid-dep=yes --output="$results/merge.log" ${more[@]+"${more[@]}"} \
  --wrap "$(printf '%q merge %q >%q' "$(realpath "$program")" "$results" "$results/merged.txt")")
echo "array $array merge $merge"
