#!/bin/sh
# Runs examples/slurm as its users would, on a Slurm of its own with two processors of this machine: a census of all arrays
# over GF(4) of degree 6 and an evaluation, each in eight tasks, of which one is killed in the middle and requeued by Slurm.
# What is merged must be, to the byte, what one run makes. Ends with 2 where Slurm is not installed. Needs root.
set -eu
cd "$(dirname "$0")/.."
here=$(pwd)
PATH=$here/bin:$PATH:/usr/sbin:/sbin
presses=${PRESSES:-160}

refuse() { echo "pra-tactile: $*" >&2; exit 2; }
fail() { echo "pra-tactile: $*" >&2; exit 1; }
for program in slurmctld slurmd sbatch; do
  command -v "$program" >/dev/null 2>&1 || refuse "there is no $program; install slurm-wlm"
done
[ "$(id -u)" -eq 0 ] || refuse "slurmd is started as root"
[ -x bin/pra-tactile ] || refuse "run 'make build' first"

work=$(mktemp -d)
program=$(readlink -f bin/pra-tactile)
name=$(hostname -s)
mkdir "$work/state" "$work/spool"
daemons=
stop() {
  [ -z "$daemons" ] || kill $daemons 2>/dev/null || true
  wait
  rm -rf "$work"
}
trap stop EXIT
trap 'exit 1' INT TERM

export SLURM_CONF="$work/slurm.conf"
# A task whose program was killed by a signal (128 + 9) is requeued.
cat > "$SLURM_CONF" <<END
ClusterName=pra-tactile
SlurmctldHost=$name(127.0.0.1)
SlurmUser=root
AuthType=auth/none
CredType=cred/none
SlurmctldPort=${SLURM_PORT:-16817}
SlurmdPort=$((${SLURM_PORT:-16817} + 1))
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
RequeueExit=137
ReturnToService=2
SchedulerParameters=sched_interval=1,sched_min_interval=100000
NodeName=$name NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=check Nodes=$name Default=YES MaxTime=60 State=UP
END
slurmctld -D > "$work/slurmctld.log" 2>&1 &
daemons=$!
slurmd -D > "$work/slurmd.log" 2>&1 &
daemons="$daemons $!"

# until SECONDS COMMAND..: waits for it to succeed.
until_so() {
  left=$(($1 * 5))
  shift
  until "$@"; do
    left=$((left - 1))
    [ "$left" -gt 0 ] || return 1
    sleep 0.2
  done
}
idle() { sinfo -h -o %t 2>/dev/null | grep -q idle; }
ended() { [ -z "$(squeue -h -j "$1" 2>/dev/null)" ]; }
begun() { [ -e "$1" ] && [ "$(wc -l < "$1")" -gt 2 ]; }
waiting() { [ "$(squeue -h -t PD -o %r -j "$1" 2>/dev/null)" = BeginTime ]; }
until_so 60 idle || fail "Slurm does not start: $(tail -n 3 "$work"/slurm*.log)"

# check SCRIPT ENDING MERGED ARGUMENT..: in a folder of its own; the command of one run is named as the script.
check() {
  script=$1 ending=$2
  shift 2
  mkdir "$work/$script"
  cd "$work/$script"
  if [ "$script" = census ]; then
    pra-tactile census "$@" --output whole > one.log
  else
    pra-tactile evaluate "$@" --json > whole
  fi
  job=$(sbatch --parsable "$here/examples/slurm/$script.sh" "$@")
  until_so 60 begun "part-1.$ending" || fail "task 1 does not begin: $(cat "$script-1.log" "$work"/slurmd.log)"
  killed=
  for task in $(pgrep -f "$script .*--shard 1/8"); do
    [ "$(readlink "/proc/$task/exe")" = "$program" ] && [ "$(readlink "/proc/$task/cwd")" = "$work/$script" ] || continue
    kill -KILL "$task" && killed=$task
  done
  [ -n "$killed" ] || fail "there is no task 1 to kill"
  rows=$(wc -l < "part-1.$ending")
  # Slurm lets two minutes go by before a task that was requeued runs again.
  until_so 60 waiting "${job}_1" || fail "task 1 was not requeued: $(squeue -h)"
  scontrol update JobId="${job}_1" StartTime=now
  until_so 600 ended "$job" || fail "the tasks do not end: $(squeue -h)"
  grep -q Killed "$script-1.log" || fail "task 1 was not killed: $(cat "$script-1.log")"
  pra-tactile merge part-*."$ending" --output merged > merged.log
  cmp whole merged || fail "what is merged is not what one run makes"
  echo "$script: task 1 was killed with $rows lines written, requeued, and continued to $(wc -l < "part-1.$ending")"
  echo "$script: what 8 tasks made is merged to the $(wc -c < merged) bytes of one run"
  cd "$here"
}
check census csv --q 4 --degree 6
check evaluate json --presses "$presses" --seed 1
