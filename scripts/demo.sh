#!/usr/bin/env bash
# Builds gearfilm where needed and computes the case study of Barbieri, Lubrecht, Pellicano 2013: the stationary film
# at the pitch point, its figure, and a table beside the paper's values.
#   scripts/demo.sh [FOLDER]              results go to FOLDER; output/demo by default
# PYTHON names the Python with h5py and matplotlib; Debian's own by default.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-output/demo}
case_file=input/barbieri2013.yaml
python=${PYTHON:-/usr/bin/python3}
gearfilm=build/release/bin/gearfilm

cores=$(nproc)
processes=$((cores < 2 ? cores : 2))
# Processes may share a core where hardware threads count as cores.
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none
if [ "$(id -u)" = 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi

# run COMMAND [options]: one command of gearfilm on the case; its results go to FOLDER/COMMAND.
run() {
  local command=$1
  shift
  mpiexec -n "$processes" "$gearfilm" "$command" "$case_file" -output_dir "$folder/$command" "$@"
}

scripts/setup.sh

echo "demo: gearfilm info and steady on $case_file, $processes process(es)"
run info >/dev/null
run steady
"$python" scripts/plot_film.py "$folder/steady"

echo
"$python" scripts/report.py "$folder"
