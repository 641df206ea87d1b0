#!/usr/bin/env bash
# Runs the short tests under the address and undefined-behaviour sanitizers, the parallel ones on 2 processes, without
# those of whole faces, whose rows film_tests have too.
#   scripts/checks/sanitize.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
scripts/setup.sh debug gearfilm unit_tests input_tests film_tests
ctest --preset debug -L 'unit|film|short' -LE slow -E '_np[134]$|face_tests'
