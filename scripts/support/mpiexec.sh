#!/usr/bin/env bash
# Starts a program on so many processes; a launcher of one's own ("srun -n") may take its place.
#   scripts/support/mpiexec.sh PROCESSES [-x VARIABLE ...] PROGRAM [ARGUMENT...]
# On Linux with Open MPI every process has a core of its own where there are enough, of those that no other run of this
# script has, as far as there are such: only so do its waits leave the core to other programs. More processes than
# cores share all of them. MPIEXEC names another mpiexec.
set -euo pipefail
mpiexec=${MPIEXEC:-mpiexec}
processes=$1
shift
if [ "$(id -u)" = 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi

# One processor of every core that this process may use. Open MPI by itself heeds neither taskset nor other runs.
usable_cores() {
  local allowed
  allowed=$(sed -n 's/^Cpus_allowed_list:[[:space:]]*//p' /proc/self/status)
  lscpu -p=CPU,CORE,SOCKET | awk -F, -v allowed="$allowed" '
    BEGIN {
      for (n = split(allowed, ranges, ","); n > 0; n--) {
        last = split(ranges[n], ends, "-")
        for (cpu = ends[1] + 0; cpu <= ends[last] + 0; cpu++) may[cpu]
      }
    }
    /^[0-9]/ && ($1 in may) && !(($2, $3) in seen) { seen[$2, $3]; print $1 }'
}

# Sets `cores`, one for each process, and keeps them locked for as long as mpiexec runs; those that others have come
# last. Empty where there are too few.
choose_cores() {
  local all taken=() core lock
  cores=()
  [ "$processes" -gt 1 ] || return 0
  for tool in lscpu awk taskset flock; do command -v "$tool" >/dev/null || return 0; done
  mapfile -t all < <(usable_cores)
  [ "$processes" -le "${#all[@]}" ] || return 0
  for core in "${all[@]}"; do
    [ "${#cores[@]}" -lt "$processes" ] || break
    # The lock is on the file in which Linux describes the core, so that nothing is left behind.
    if exec {lock}<"/sys/devices/system/cpu/cpu$core/topology/core_id" && flock -n "$lock"; then
      cores+=("$core")
    else
      taken+=("$core")
    fi
  done
  cores+=("${taken[@]:0:processes-${#cores[@]}}")
}

# What each process begins with: the cores of this machine as $0, then the program.
# shellcheck disable=SC2016
in_a_core='cores=($0)
  [ "$OMPI_COMM_WORLD_LOCAL_SIZE" = "$OMPI_COMM_WORLD_SIZE" ] || exec "$@"
  exec taskset -c "${cores[OMPI_COMM_WORLD_LOCAL_RANK]}" "$@"'

options=()
while [ "${1:-}" = -x ]; do
  options+=("$1" "$2")
  shift 2
done
case $("$mpiexec" --version) in
*'Open MPI'* | *OpenRTE*)
  choose_cores
  # Open MPI by default refuses more processes than cores.
  options+=(--map-by :OVERSUBSCRIBE --bind-to none)
  if ((${#cores[@]})); then set -- bash -c "$in_a_core" "${cores[*]}" "$@"; fi
  ;;
esac
exec "$mpiexec" "${options[@]}" -n "$processes" "$@"
