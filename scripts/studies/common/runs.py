"""Runs of gearfilm, for the studies.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it, for example "mpiexec -n 2".
"""
import contextlib
import dataclasses
import json
import os
import pathlib
import shlex
import subprocess
import sys
import time

SOURCE = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = os.environ.get("GEARFILM", str(SOURCE / "build/release/bin/gearfilm"))
LAUNCHER = shlex.split(os.environ.get("GEARFILM_LAUNCHER", ""))
OUT_OF_TIME = "time"           # status of a run that was ended at its time limit


class RunError(Exception):
    """A run that cannot be made; the text is for the user."""


@contextlib.contextmanager
def one_line_errors(script, folder):
    """Exit status 1 with one line, where a run cannot be made or a file not be written to the folder."""
    try:
        yield
    except RunError as error:
        sys.exit(f"{script}: {error}")
    except OSError as error:
        sys.exit(f"{script}: cannot write to {folder}: {error}")


@dataclasses.dataclass
class Run:
    """What became of a run: its exit status, how long it took, what it said on stderr, its summary if it left one."""
    words: list
    status: object
    seconds: float
    errors: str
    summary: dict

    @property
    def message(self):
        """The last line of what it said."""
        return self.errors.strip().rpartition("\n")[2]


def attempt(command, case, folder, *options, time_limit=None, launcher=LAUNCHER):
    """One run, however it ends; longer than its time limit [s] it is ended, with the status OUT_OF_TIME."""
    words = [*launcher, PROGRAM, command, str(case), "-output_dir", str(folder), *map(str, options)]
    begin = time.monotonic()
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=False, timeout=time_limit)
        status, errors = done.returncode, done.stderr
    except subprocess.TimeoutExpired:
        status, errors = OUT_OF_TIME, f"not done after {time_limit} s"
    except OSError as error:
        raise RunError(f"cannot run {words[0]}: {error.strerror}; set GEARFILM or run scripts/setup.sh") from None
    seconds = time.monotonic() - begin
    # With status 1 the folder is as it was.
    place = folder / "summary.json"
    summary = json.loads(place.read_text(encoding="utf-8")) if status != 1 and place.exists() else None
    return Run(words, status, seconds, errors, summary)


def timed(*words, **options):
    """A run as attempt() makes it, and the seconds of processors that it took, which other programs hardly change."""
    before = os.times()
    run = attempt(*words, **options)
    after = os.times()
    return run, after.children_user + after.children_system - before.children_user - before.children_system


def solved(command, case, folder, *options):
    """Summary of a run that must be solved."""
    run = attempt(command, case, folder, *options)
    if run.status != 0:
        raise RunError(f"{pathlib.Path(case).name}, {' '.join(map(str, options))}: {run.message}")
    return run.summary


def domain_options(folder):
    """Options that keep the domain of a run, which the program chose, on another grid."""
    import h5py  # pylint: disable=import-outside-toplevel  (few studies need it)
    with h5py.File(folder / "results.h5") as results:
        return [word for name in ("x_min", "x_max", "y_half")
                for word in (f"-grid_{name}", repr(float(results.attrs[name])))]


def gearfilm(command, case, folder, *options):
    """Summary of one run; None, with the message on stderr, where it was not solved (exit status 2)."""
    run = attempt(command, case, folder, *options)
    if run.status == 2:
        print(run.errors.strip(), file=sys.stderr)
        return None
    if run.status != 0:
        raise RunError(f"'{' '.join(run.words)}' failed: {run.errors.strip()}")
    return run.summary
