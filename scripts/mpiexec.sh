#!/usr/bin/env bash
# Starts a program on so many processes, which may share cores; a launcher of one's own ("srun -n") may take its place.
#   scripts/mpiexec.sh PROCESSES PROGRAM [ARGUMENT...]
set -euo pipefail
mpiexec=${MPIEXEC:-mpiexec}
if [ "$(id -u)" = 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi
# Open MPI by default refuses more processes than cores, and binds those of two runs to the same cores.
flags=()
case $("$mpiexec" --version) in *'Open MPI'* | *OpenRTE*) flags=(--map-by :OVERSUBSCRIBE --bind-to none) ;; esac
exec "$mpiexec" "${flags[@]}" -n "$@"
