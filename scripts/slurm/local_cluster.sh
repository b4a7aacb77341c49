#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A Slurm cluster of this one machine, for trying scripts/slurm: munged, slurmctld and slurmd from
# Debian's slurm-wlm and munge (scripts/install.sh slurm), everything in a scratch folder, nothing
# in /etc. Needs root, as slurmd does; no cgroups, so it runs in a container too.
# usage: scripts/slurm/local_cluster.sh COMMAND...   starts it, runs COMMAND there, stops it
set -euo pipefail
[ "$(id -u)" -eq 0 ] || { echo "error: slurmd needs root" >&2; exit 2; }
for tool in munged slurmctld slurmd sinfo; do
  command -v $tool >/dev/null || { echo "error: no $tool; expected: scripts/install.sh slurm" >&2; exit 2; }
done

folder=$(mktemp -d)
chmod 755 "$folder"
mkdir -m 700 "$folder/munge" "$folder/key"
mkdir "$folder/state" "$folder/spool"
pids=()
stop() {
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
  rm -rf "$folder"
}
trap stop EXIT

dd if=/dev/urandom of="$folder/key/munge.key" bs=1024 count=1 status=none
chmod 600 "$folder/key/munge.key"
munged --foreground --force --socket="$folder/munge.socket" --key-file="$folder/key/munge.key" \
  --pid-file="$folder/munge/pid" --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" >"$folder/munge.out" 2>&1 &
pids+=($!)

cat >"$folder/slurm.conf" <<CONF
ClusterName=local
SlurmctldHost=$(hostname -s)
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CryptoType=crypto/munge
SlurmUser=root
SlurmctldPort=${SLURM_PORT:-16817}
SlurmdPort=$((${SLURM_PORT:-16817} + 1))
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
ReturnToService=2
SchedulerParameters=sched_interval=5
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$folder/slurm.conf
slurmctld -D -i >"$folder/slurmctld.out" 2>&1 &
pids+=($!)
slurmd -D >"$folder/slurmd.out" 2>&1 &
pids+=($!)

for ((i = 0; ; ++i)); do
  [ "$(sinfo -h -o %T 2>/dev/null)" = idle ] && break
  if [ $i -eq 60 ]; then
    echo "error: the cluster does not come up:" >&2
    tail -n 5 "$folder"/*.out "$folder"/*.log >&2
    exit 1
  fi
  read -rt 1 <> <(:) || true  # a second
done
"$@"
