#!/usr/bin/env bash
# Runs the short tests under the address and undefined-behaviour sanitizers, the parallel ones on 2 processes. Of films
# what the commands of short_test.py solve; GEARFILM_SANITIZE with all tests is left to who changes films.
#   scripts/checks/sanitize.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
scripts/setup.sh debug gearfilm unit_tests input_tests stress_tests
ctest --preset debug -L 'unit|film|short' -LE slow -E '_np[134]$|face_tests|film_tests'
