#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Sets up Slurm on this machine as its only node, for this user and for as long as a command runs: all files are in a
# temporary folder, and no service of the system is touched. Needs Debian's packages slurm-wlm and munge.
#
#   scripts/with_slurm.sh COMMAND ...
#   scripts/with_slurm.sh sbatch --wait --array=1-4 scripts/batch_array.sh meshes -o results
#
# The exit code is that of the command; 77 if Slurm is not installed or does not start here, after a line that says why.
set -euo pipefail

if [ $# -eq 0 ]; then
  echo "usage: $0 COMMAND ..." >&2
  exit 2
fi

unavailable() {
  echo "Slurm cannot be used here: $1" >&2
  exit 77
}

PATH="$PATH:/usr/sbin:/sbin"
for program in munged slurmctld slurmd sbatch sinfo; do
  command -v "$program" > /dev/null || unavailable "$program is not installed (packages slurm-wlm and munge)"
done

work=$(mktemp -d "${TMPDIR:-/tmp}/slurm_XXXXXX")
daemons=()
is_ready=false
stop() {
  if "$is_ready"; then
    # jobs that the command has left behind
    scancel --quiet --user="$user" || true
    for _ in {1..50}; do
      [ -n "$(squeue --noheader 2> /dev/null)" ] || break
      sleep 0.1
    done
  fi
  for process in "${daemons[@]}"; do
    kill "$process" 2> /dev/null || true
    wait "$process" 2> /dev/null || true
  done
  rm -rf "$work"
}
# the node goes first, then those that it talks to
trap stop EXIT

start() { # NAME COMMAND ...
  local name=$1
  shift
  "$@" > "$work/$name.out" 2>&1 < /dev/null &
  daemons=($! "${daemons[@]}")
}

wait_for() { # NAME COMMAND ...
  local name=$1
  shift
  for _ in {1..150}; do
    "$@" > /dev/null 2>&1 && return
    kill -0 "${daemons[0]}" 2> /dev/null || break
    sleep 0.1
  done
  unavailable "$name does not start: $(tail -n 1 "$work/$name.out" | tr -d '\n')"
}

free_ports() {
  python3 -c '
import socket
sockets = [socket.socket() for _ in range(2)]
for s in sockets:
    s.bind(("127.0.0.1", 0))
print(*(s.getsockname()[1] for s in sockets))'
}

user=$(id -un)
node=$(hostname -s)
read -r controller_port node_port <<< "$(free_ports)"
mkdir "$work/state" "$work/spool"
(umask 077 && head -c 1024 /dev/urandom > "$work/munge.key")
cat > "$work/slurm.conf" <<- EOT
	ClusterName=one_node
	SlurmctldHost=$node(127.0.0.1)
	SlurmctldPort=$controller_port
	SlurmdPort=$node_port
	SlurmUser=$user
	SlurmdUser=$user
	AuthType=auth/munge
	AuthInfo=socket=$work/munge.socket
	StateSaveLocation=$work/state
	SlurmdSpoolDir=$work/spool
	SlurmctldPidFile=$work/slurmctld.pid
	SlurmdPidFile=$work/slurmd.pid
	ProctrackType=proctrack/linuxproc
	SelectType=select/cons_tres
	SelectTypeParameters=CR_CPU
	SchedulerParameters=sched_interval=1,batch_sched_delay=0
	ReturnToService=2
	NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
	PartitionName=all Nodes=ALL Default=YES State=UP
EOT
# Control groups belong to the system. Before version 23.11 there had to be a plugin for them, if an idle one.
version=$(slurmd -V | tr -cd '0-9.')
if [ "$(printf '%s\n' 23.11 "$version" | sort --version-sort | head -n 1)" = 23.11 ]; then
  echo "CgroupPlugin=disabled" > "$work/cgroup.conf"
else
  echo "CgroupPlugin=cgroup/v1" > "$work/cgroup.conf"
fi
export SLURM_CONF="$work/slurm.conf"

start munged munged --foreground --force --key-file="$work/munge.key" --socket="$work/munge.socket" \
  --pid-file="$work/munge.pid" --log-file="$work/munge.log" --seed-file="$work/munge.seed"
wait_for munged test -S "$work/munge.socket"
start slurmctld slurmctld -D
wait_for slurmctld scontrol ping
start slurmd slurmd -D
is_idle() { [ "$(sinfo --noheader --format=%T)" = idle ]; }
wait_for slurmd is_idle
is_ready=true

"$@"
