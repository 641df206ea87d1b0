#!/usr/bin/env bash
# Builds gearfilm and runs all its tests.
#   scripts/test.sh [ctest options]       for example -L unit, or -R film
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
ctest --preset release "$@"
