#!/usr/bin/env bash
# All checks beside the tests: clang-tidy, sanitizers, valgrind.
#   scripts/check.sh
set -euo pipefail
cd "$(dirname "$0")"
./tidy.sh
./sanitize.sh
./memcheck.sh
