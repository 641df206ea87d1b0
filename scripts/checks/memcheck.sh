#!/usr/bin/env bash
# Runs every command of the program for a moment under valgrind's memcheck, on 1 and 2 processes.
#   scripts/checks/memcheck.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
scripts/support/install.sh valgrind
scripts/setup.sh memcheck gearfilm
# hwloc, a part of Open MPI, would say on stderr that it cannot ask the processor under valgrind.
export HWLOC_COMPONENTS=-x86
export GEARFILM=build/memcheck/bin/gearfilm
export GEARFILM_RUNNER="valgrind --quiet --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite,possible
  --show-leak-kinds=definite,possible --num-callers=40 --suppressions=$PWD/tests/suppressions/valgrind.supp"
export OMPI_MCA_mpi_yield_when_idle=1
grep -o '\<test_\w*' tests/cli/short_test.py |
  xargs -P "$(nproc)" -I{} scripts/support/python.sh -B tests/cli/short_test.py Short.{}
echo "memcheck: no findings"
