#!/usr/bin/env bash
# Runs a Python that has what the scripts need: the one that PYTHON names, else python3 of the path, else Debian's.
#   scripts/support/python.sh [ARGUMENT...]
set -euo pipefail
if [ -n "${PYTHON:-}" ]; then exec "$PYTHON" "$@"; fi
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import h5py, matplotlib, numpy, PIL' 2>/dev/null; then exec "$python" "$@"; fi
done
echo "python.sh: no python3 has h5py, matplotlib, numpy and pillow; run scripts/setup.sh, or name one in PYTHON" >&2
exit 1
