"""Runs scripts in children of this process, which have what it has imported: most of their time, with Matplotlib."""
import os
import runpy
import signal
import subprocess
import sys
import tempfile
import traceback

from drawn import check_saved_figures
from program import SECONDS, SOURCE


def end_as_interpreter(end):
    """What Python makes of sys.exit's argument: the status; a message is printed."""
    if end.code is None or isinstance(end.code, int):
        return end.code or 0
    print(end.code, file=sys.stderr)
    return 1


def run_in_child(begin, words, out, err):
    signal.alarm(SECONDS)  # ends it
    os.dup2(out.fileno(), 1)
    os.dup2(err.fileno(), 2)
    sys.argv = words
    status = 1
    check_saved_figures()
    try:
        begin()
        status = 0
    except SystemExit as end:
        status = end_as_interpreter(end)
    except BaseException:  # pylint: disable=broad-except
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)


def run(begin, words):
    """As subprocess.run would: exit status, stdout, stderr."""
    sys.stdout.flush()
    sys.stderr.flush()
    with tempfile.TemporaryFile("w+", encoding="utf-8") as out, tempfile.TemporaryFile("w+", encoding="utf-8") as err:
        child = os.fork()
        if child == 0:
            run_in_child(begin, words, out, err)
        _, ended = os.waitpid(child, 0)
        out.seek(0)
        err.seek(0)
        return subprocess.CompletedProcess(words, os.waitstatus_to_exitcode(ended), out.read(), err.read())


def run_script(path, *arguments):
    """A script by its path."""
    def begin():
        sys.path.insert(0, str(path.parent))
        runpy.run_path(str(path), run_name="__main__")

    return run(begin, [str(path), *map(str, arguments)])


def plot(kind, *arguments):
    """python3 -m gearfilm plot KIND ..."""
    def begin():
        sys.path.insert(0, str(SOURCE / "scripts"))
        runpy.run_module("gearfilm", run_name="__main__")

    return run(begin, ["gearfilm", "plot", kind, *map(str, arguments)])
