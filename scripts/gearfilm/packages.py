"""Packages that the Python at hand may lack: which ones, and another Python that has them.

It imports none of them, so that a line can be said before any is missed.
"""
import importlib.util
import os
import pathlib
import subprocess
import sys

TABLES = ("h5py", "numpy")                          # by the names under which they are imported
FIGURES = ("h5py", "matplotlib", "numpy", "PIL")
DISTRIBUTED_AS = {"PIL": "pillow"}
DEBIAN = "/usr/bin/python3"                         # has all of them after scripts/setup.sh


def missing(packages):
    """The packages that this Python lacks, by the names under which they are installed."""
    return [DISTRIBUTED_AS.get(name, name) for name in packages if importlib.util.find_spec(name) is None]


def other_python(packages):
    """A Python that has them all, the variable PYTHON or Debian's; None where neither does."""
    for python in (os.environ.get("PYTHON"), DEBIAN):
        try:
            if python and subprocess.run([python, "-c", f"import {', '.join(packages)}"], capture_output=True,
                                         check=False).returncode == 0:
                return python
        except OSError:
            pass
    return None


def require(packages, program):
    """Ends the program with a line where this Python lacks one of them."""
    lacking = missing(packages)
    if not lacking:
        return
    other = other_python(packages)
    remedy = f"or use {other}, which has them" if other else "or use Debian's python3 after scripts/setup.sh"
    sys.exit(f"{program}: {sys.executable} has no {', '.join(lacking)}; pip install {' '.join(lacking)}, {remedy}")


def go_on_with(packages, program, module=None):
    """Begins a script, or a module, again with a Python that has them, where this one lacks one and there is such."""
    if not missing(packages):
        return
    other = other_python(packages)
    if other is None:
        require(packages, program)
    words = [other, *(["-B"] if sys.dont_write_bytecode else [])]
    if module is None:
        os.execv(other, [*words, *sys.argv])
    here = str(pathlib.Path(__file__).resolve().parents[1])     # the other Python may not know of this package
    path = os.pathsep.join(filter(None, (here, os.environ.get("PYTHONPATH"))))
    os.execve(other, [*words, "-m", module, *sys.argv[1:]], {**os.environ, "PYTHONPATH": path})
