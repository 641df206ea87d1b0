"""Runs the program under test, as a user would, in a folder of its own."""
import os
import pathlib
import re
import shlex
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
INPUT = SOURCE / "input"
# Of the cases that most tests take: coarse grids, the paper's isothermal films at speed, or their heat, Wang's equivalent load.
SAID_OF_CASES = re.compile(
    r"gearfilm: warning: (the films have an error|the error of the films|\w+ has an error of about"
    r"|the errors of the quantities|the film is computed as if its inlet were not heated|the film is as hot as|the largest Hertz pressure is|'gear.load_model' is line_equivalent)")
PROGRAM = os.path.abspath(os.environ.get("GEARFILM", SOURCE / "build/release/bin/gearfilm"))
# What runs the program, with its options: a memory checker, for example.
RUNNER = shlex.split(os.environ.get("GEARFILM_RUNNER", ""))
MPIEXEC = shlex.split(os.environ.get("GEARFILM_MPIEXEC", str(SOURCE / "scripts/support/mpiexec.sh")))
RESULT_FILES = {"results.h5", "results.xmf", "summary.json"}
SECONDS = 600
# Grids of tests are small, and all processes are to share them.
TOGETHER = {"PETSC_OPTIONS": "-solver_processes all"}
# Open MPI: a process alone needs neither a daemon nor a network, which take two thirds of its start.
ALONE = {"OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_btl": "self"}
# Open MPI: where a process returns another status than 0, mpiexec waits twice for so many seconds (1 by default).
AT_ONCE = {"OMPI_MCA_odls_base_sigkill_timeout": "0"}


def command_of(arguments, processes):
    return [*([*MPIEXEC, str(processes)] if processes > 1 else []), *RUNNER, PROGRAM, *map(str, arguments)]


def environment_of(processes, scratch):
    """With a temporary folder that no other run has: where two of Open MPI begin at once, one may fail."""
    own = ALONE if processes == 1 else TOGETHER
    return own | os.environ | {"TMPDIR": str(scratch)}


class Outcome:
    """How a run ended: status, stdout, and what the program itself wrote to stderr."""

    def __init__(self, arguments, processes, status, stdout, stderr):
        self.words = shlex.join(map(str, arguments))
        self.status = status
        self.stdout = stdout
        # mpiexec adds a notice of its own when a process returns another status than 0.
        said = stderr if processes == 1 else before_notice_of_mpiexec(stderr)
        of_case = [line for line in said.splitlines(keepends=True) if SAID_OF_CASES.match(line)]
        # Coarse grids are what most tests want: what is said of them is kept apart.
        self.of_case = "".join(of_case)
        self.stderr = "".join(line for line in said.splitlines(keepends=True) if line not in of_case)

    def __str__(self):
        return f"gearfilm {self.words[:1000]}: status {self.status}\n{self.stdout}{self.stderr}"


class Run(Outcome):
    """One finished run."""

    def __init__(self, arguments, processes, folder, seconds=SECONDS):
        with tempfile.TemporaryDirectory() as scratch:
            done = subprocess.run(command_of(arguments, processes), cwd=folder, timeout=seconds, check=False,
                                  env=AT_ONCE | environment_of(processes, scratch), capture_output=True, text=True)
        super().__init__(arguments, processes, done.returncode, done.stdout, done.stderr)


# What mpiexec and its event library say on their own.
OF_MPIEXEC = ("mpiexec: Forwarding signal", "[warn] Epoll ")


# Of a daemon whose process has gone before it could be told so.
OF_DAEMON = re.compile(r"\[[^]]*\] PMIX ERROR: ")


def before_notice_of_mpiexec(text):
    lines = []
    inside_notice = False
    for line in text.splitlines(keepends=True):
        if line.startswith("-----") and line.strip("-\n") == "":
            inside_notice = not inside_notice
        elif not inside_notice and not line.startswith(OF_MPIEXEC) and not OF_DAEMON.match(line):
            lines.append(line)
    return "".join(lines)


def names_below(folder):
    """Names of everything in a folder, nested."""
    return sorted(str(path.relative_to(folder)) for path in pathlib.Path(folder).rglob("*"))


class ProgramTest(unittest.TestCase):
    """A test that works in a new folder, self.folder."""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)

    def run_program(self, *arguments, processes=1):
        return Run(arguments, processes, self.folder)

    def run_well(self, *arguments, processes=1):
        run = self.run_program(*arguments, processes=processes)
        self.assertEqual(run.status, 0, run)
        self.assertEqual(run.stderr, "", run)
        return run

    def assert_wrong(self, words, *arguments, processes=1):
        """Exit status 1: one line on stderr with these words, nothing written."""
        before = self.content()
        run = self.run_program(*arguments, processes=processes)
        self.assert_message(run, 1, "gearfilm: wrong input: ", words)
        self.assertEqual(self.content(), before, run)

    def assert_message(self, run, status, beginning, words):
        """A failed run: its exit status, and one line on stderr alone, with this beginning and these words."""
        self.assertEqual(run.status, status, run)
        self.assertEqual(run.stdout, "", run)
        self.assertEqual(run.stderr.count("\n"), 1, run)
        self.assertTrue(run.stderr.startswith(beginning), run)
        for word in words:
            self.assertIn(word, run.stderr)

    def content(self):
        return names_below(self.folder)

    def write_case(self, text, name="case.yaml"):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path
