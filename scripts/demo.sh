#!/usr/bin/env bash
# Builds gearfilm where needed and computes the case study of Barbieri, Lubrecht, Pellicano 2013: the stationary film
# at the pitch point, the first two mesh periods from there, their figures, and a table beside the paper's values.
#   scripts/demo.sh [FOLDER]              results go to FOLDER; output/demo by default
# PYTHON names the Python with h5py and matplotlib; by default one that has them (scripts/support/python.sh).
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-output/demo}
case_file=input/barbieri2013.yaml
gearfilm=build/release/bin/gearfilm

cores=$(nproc)
processes=$((cores < 2 ? cores : 2))

# run COMMAND [options]: one command of gearfilm on the case; its results go to FOLDER/COMMAND.
run() {
  local command=$1
  shift
  scripts/support/mpiexec.sh "$processes" "$gearfilm" "$command" "$case_file" -output_dir "$folder/$command" "$@"
}

python() {
  PYTHONPATH=scripts scripts/support/python.sh "$@"
}

scripts/setup.sh release gearfilm

# Isothermal films on 129 x 65 nodes, as in the paper: what both cost is known (docs/verification.md).
paper=(-thermal_model none -grid_accuracy 0.1)
# The force on one contact passes 1.33 of the static one, where the ellipse leaves the paper's |y| <= 1.1 b.
wide=(-grid_nx 145 -grid_ny 81 -grid_x_min -2.25 -grid_x_max 1.5 -grid_y_half 1.4)

echo "demo: gearfilm info, steady and transient on $case_file, $processes process(es)"
run info >/dev/null
run steady "${paper[@]}"
python -m gearfilm plot film "$folder/steady"
run transient "${paper[@]}" "${wide[@]}" -time_dt 0.026 -mesh_periods 2
python -m gearfilm plot march "$folder/transient"

echo
python scripts/studies/paper/report.py "$folder"
