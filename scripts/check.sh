#!/usr/bin/env bash
# All checks beside the tests: clang-tidy, pages of the public headers, sanitizers, valgrind.
#   scripts/check.sh
set -euo pipefail
cd "$(dirname "$0")"
checks/tidy.sh
./pages.sh
checks/sanitize.sh
checks/memcheck.sh
