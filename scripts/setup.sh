#!/usr/bin/env bash
# Installs what gearfilm needs from Debian's packages where it is missing, configures, and builds.
#   scripts/setup.sh [release|debug [TARGET]]     the build preset, release by default; all targets by default
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
target=${2:-all}

packages=(g++ cmake ninja-build pkg-config openmpi-bin libopenmpi-dev petsc-dev slepc-dev libhdf5-openmpi-dev
          libfftw3-dev libyaml-cpp-dev nlohmann-json3-dev libgtest-dev python3 python3-numpy python3-h5py
          python3-matplotlib)
missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
done
if ((${#missing[@]})); then
  echo "setup: installing ${missing[*]}"
  sudo=()
  if [ "$(id -u)" != 0 ]; then sudo=(sudo); fi
  export DEBIAN_FRONTEND=noninteractive
  "${sudo[@]}" apt-get update -qq
  "${sudo[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
fi

cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" --target "$target"
