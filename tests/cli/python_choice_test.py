"""A Python that lacks packages: one line from the package, and scripts that go on with another Python.

Python without its site folders (-S) has none of Debian's packages; that is the one which lacks them here.
"""
import os
import pathlib
import subprocess
import sys
import unittest

from films import BARBIERI
from program import SECONDS, SOURCE, ProgramTest

SCRIPTS = SOURCE / "scripts"
BARE = [sys.executable, "-S", "-B"]
HAS_NONE = subprocess.run([*BARE, "-c", "import numpy"], capture_output=True, check=False).returncode != 0
DEBIAN = pathlib.Path("/usr/bin/python3")


def call(*words, **environment):
    return subprocess.run([*map(str, words)], capture_output=True, text=True, timeout=SECONDS, check=False,
                          env={**os.environ, "PYTHONPATH": str(SCRIPTS), **environment})


@unittest.skipUnless(HAS_NONE, "this Python has numpy even without site folders")
class Lacking(ProgramTest):
    def test_the_package_says_what_is_missing_in_a_line(self):
        for words in (["export", "folder"], ["report", "folder"], []):
            done = call(*BARE, "-m", "gearfilm", *words)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (1, "", 1), done)
            self.assertRegex(done.stderr, r"\Agearfilm: \S+ has no h5py, numpy; pip install h5py numpy, or use \S+")

    def test_figures_need_more_than_tables(self):
        program = ("import importlib.util as util, sys; find = util.find_spec\n"
                   "util.find_spec = lambda name, *more: None if name == 'matplotlib' else find(name, *more)\n"
                   f"sys.argv = ['gearfilm', {{}}, '{self.folder}']\n"
                   "import runpy; runpy.run_module('gearfilm', run_name='__main__')")
        (self.folder / "summary.json").write_text("{}", encoding="utf-8")
        done = call(sys.executable, "-B", "-c", program.format("'report'"))
        self.assertRegex(done.stderr, r"\Agearfilm: \S+ has no matplotlib; pip install matplotlib, or use .*\n\Z")
        done = call(sys.executable, "-B", "-c", program.format("'export'"))
        self.assertIn("has no tables", done.stderr)

    def test_importing_the_package_needs_nothing(self):
        done = call(*BARE, "-c", "import gearfilm; print(gearfilm.__all__)")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        done = call(*BARE, "-c", "import gearfilm; gearfilm.nothing")
        self.assertIn("module 'gearfilm' has no attribute 'nothing'", done.stderr)

    def test_figures_and_studies_go_on_with_a_python_that_has_them(self):
        self.run_well("steady", BARBIERI, "-grid_nx", 65, "-grid_ny", 33, "-grid_y_half", 1.4, "-output_dir", "steady")
        done = call(*BARE, "-m", "gearfilm", "plot", "film", self.folder / "steady", "--format", "png",
                    PYTHON=sys.executable)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, f"figure: {self.folder}/steady/film.png\n", ""))
        for study in ("catalogue", "film_errors"):
            done = call(*BARE, SCRIPTS / "studies" / study / "run", "--help", PYTHON=sys.executable)
            self.assertEqual((done.returncode, done.stderr), (0, ""))


class Shell(ProgramTest):
    """scripts/support/python.sh, which shell scripts call."""

    def test_the_named_one_comes_first(self):
        other = self.folder / "other"
        other.write_text("#!/bin/sh\necho other \"$@\"\n", encoding="utf-8")
        other.chmod(0o755)
        self.assertEqual(call(SCRIPTS / "support/python.sh", "-x", "a b", PYTHON=str(other)).stdout, "other -x a b\n")

    @unittest.skipUnless(DEBIAN.exists() and call(DEBIAN, "-c", "import h5py, matplotlib").returncode == 0,
                         "no Python of Debian's with the packages")
    def test_one_on_the_path_that_lacks_them_is_passed_over(self):
        lacking = self.folder / "python3"
        lacking.write_text("#!/bin/sh\nexit 1\n", encoding="utf-8")
        lacking.chmod(0o755)
        done = call(SCRIPTS / "support/python.sh", "-c", "import h5py, matplotlib, sys; print(sys.executable)", PYTHON="",
                    PATH=f"{self.folder}:{os.environ['PATH']}")
        self.assertEqual((done.stdout, done.stderr), (f"{DEBIAN}\n", ""))


if __name__ == "__main__":
    unittest.main()
