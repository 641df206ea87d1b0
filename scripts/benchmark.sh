#!/usr/bin/env bash
# Measures gearfilm (`gearfilm bench` on the case study) on 1 and 2 processes, and compares with an earlier measurement.
#   scripts/benchmark.sh [FOLDER [STORED]]    results go to FOLDER/np1 and FOLDER/np2; output/benchmark by default.
#                                             STORED: the FOLDER of an earlier run, to compare with
# Nothing else should run meanwhile. PYTHON names the Python of the comparison (scripts/python.sh).
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-output/benchmark}
stored=${2:-}

scripts/setup.sh release gearfilm
for processes in 1 2; do
  echo "benchmark: $processes process(es)"
  scripts/mpiexec.sh "$processes" build/release/bin/gearfilm bench input/barbieri2013.yaml -output_dir "$folder/np$processes"
done
for processes in 1 2; do
  [ -z "$stored" ] || scripts/python.sh scripts/compare_benchmarks.py "$stored/np$processes" "$folder/np$processes"
done
