#!/usr/bin/env bash
# Runs clang-tidy over the program with the checks of .clang-tidy; a finding is an error.
#   scripts/checks/tidy.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
scripts/support/install.sh clang-tidy
scripts/setup.sh release gearfilm
# Without what is no finding: each command, and how many warnings other people's headers have.
run-clang-tidy -quiet -p build/release "$PWD/build/release/src/" 2>&1 | sed '/^clang-tidy/d; /warnings generated/d'
echo "tidy: no findings"
