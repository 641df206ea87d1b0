"""The program, run from Python."""
import os
import pathlib
import shlex
import subprocess

from .folder import ResultsError, RunFolder

DESCRIPTION = {1: "wrong input", 2: "not solved", 3: "stopped"}   # exit status


def program():
    """The binary: GEARFILM, the one built in the source tree, or the one on the path."""
    built = pathlib.Path(__file__).resolve().parents[2] / "build/release/bin/gearfilm"
    return os.environ.get("GEARFILM") or (str(built) if built.exists() else "gearfilm")


def _text(value):
    if isinstance(value, bool):
        return "yes" if value else "no"
    return str(value)


def run(case, command, output_dir=None, processes=1, **options):
    """Runs a command on a case file and opens its results. Options are named as on the command line, grid_nx=65, or as
    in a case file, **{"grid.nx": 65}; True and False are yes and no. Raises ResultsError with the program's own message
    where it does not end well."""
    folder = pathlib.Path(output_dir or pathlib.Path("output") / f"{pathlib.Path(case).stem}-{command}")
    launcher = shlex.split(os.environ.get("GEARFILM_LAUNCHER", "")) or (
        ["mpiexec", "-n", str(processes)] if processes > 1 else [])
    words = [*launcher, program(), command, str(case), "-output_dir", str(folder)]
    for name, value in options.items():
        words += [f"-{name.replace('.', '_')}", _text(value)]
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=False)
    except OSError as error:
        raise ResultsError(f"cannot run {words[0]}: {error.strerror}; set GEARFILM to the binary") from None
    if done.returncode != 0:
        kind = DESCRIPTION.get(done.returncode, f"status {done.returncode}")
        raise ResultsError(f"{shlex.join(words)}: {kind}: {done.stderr.strip()}")
    return RunFolder(folder)
