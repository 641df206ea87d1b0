"""Runs of gearfilm for the scripts that compute before they print or draw.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it, for example "mpiexec -n 2".
"""
import json
import os
import pathlib
import shlex
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[1]
PROGRAM = os.environ.get("GEARFILM", str(SOURCE / "build/release/bin/gearfilm"))
LAUNCHER = shlex.split(os.environ.get("GEARFILM_LAUNCHER", ""))


class RunError(Exception):
    """A run that cannot be made; the text is for the user."""


def gearfilm(command, case, folder, *options):
    """Summary of one run; None, with the message on stderr, where it was not solved (exit status 2)."""
    words = [*LAUNCHER, PROGRAM, command, str(case), "-output_dir", str(folder), *map(str, options)]
    try:
        run = subprocess.run(words, capture_output=True, text=True, check=False)
    except OSError as error:
        raise RunError(f"cannot run {words[0]}: {error.strerror}; set GEARFILM or run scripts/setup.sh") from None
    if run.returncode == 2:
        print(run.stderr.strip(), file=sys.stderr)
        return None
    if run.returncode != 0:
        raise RunError(f"'{' '.join(words)}' failed: {run.stderr.strip()}")
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))
