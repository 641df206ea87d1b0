#!/usr/bin/env bash
# Installs what gearfilm needs from Debian's packages where it is missing, configures, and builds.
#   scripts/setup.sh [PRESET [TARGET...]]     a build preset: release (the default), debug, memcheck;
#                                             all targets by default
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
targets=("${@:2}")

scripts/support/install.sh g++ cmake ninja-build pkg-config openmpi-bin libopenmpi-dev petsc-dev slepc-dev \
  libhdf5-openmpi-dev libfftw3-dev libyaml-cpp-dev nlohmann-json3-dev libeigen3-dev libgtest-dev libgmock-dev \
  python3 python3-numpy python3-h5py python3-matplotlib

cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" --target "${targets[@]:-all}"
