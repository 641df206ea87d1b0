"""The installed copy: programs of others build against it alone, and get what the program itself gets.

Environment as for cli_test.py, and GEARFILM_BUILD, the build folder, GEARFILM_CC and GEARFILM_CXX, its compilers.
"""
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

import h5py

from films import BARBIERI, CIRCULAR, SAME, summary_in
from program import MPIEXEC, PROGRAM, SOURCE, Run, environment_of

BUILD = pathlib.Path(os.environ.get("GEARFILM_BUILD", SOURCE / "build/release"))
CC = os.environ.get("GEARFILM_CC", "cc")
CXX = os.environ.get("GEARFILM_CXX", "c++")
EXAMPLES = ["bare_contact", "observed_march", "own_result"]
# A march of half a mesh period, on a grid that just carries the case's films.
SHORT = ["-grid_nx", 65, "-grid_ny", 33, "-time_dt", 0.1, "-mesh_periods", 0.5]
# Examples print six decimals of a micrometre or GPa, the smallest number being a tenth of one.
PRINTED = 5e-6


def output_of(words, **options):
    done = subprocess.run([*map(str, words)], capture_output=True, text=True, check=False, timeout=300, **options)
    if done.returncode != 0:
        raise AssertionError(f"{shlex.join(map(str, words))}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def number(name, text):
    return float(re.search(rf"{name} = ([\d.]+)", text)[1])


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.prefix = cls.folder / "prefix"
        output_of(["cmake", "--build", BUILD, "--target", "gearfilm_library"])
        # A staged installation, which is then moved: nothing may remember where it was installed.
        output_of(["cmake", "--install", BUILD, "--prefix", cls.folder / "staged"], env=environment_of(1, cls.folder))
        (cls.folder / "staged").rename(cls.prefix)
        # Away from the sources, so that nothing there can be found by chance.
        shutil.copytree(SOURCE / "docs/examples", cls.folder / "examples")

    def only(self, name):
        found = sorted(self.prefix.rglob(name))
        self.assertEqual(len(found), 1, f"{name}: {found}")
        return found[0]

    def flags(self, *kinds):
        path = f"{self.only('gearfilm.pc').parent}:{os.environ.get('PKG_CONFIG_PATH', '')}"
        return shlex.split(output_of(["pkg-config", *kinds, "gearfilm"], env=os.environ | {"PKG_CONFIG_PATH": path}))

    def run_example(self, program, *arguments, processes=1):
        launcher = [*MPIEXEC, str(processes)] if processes > 1 else []
        with tempfile.TemporaryDirectory() as scratch:
            return output_of([*launcher, program, *arguments], env=environment_of(processes, scratch), cwd=self.folder)

    def result_of(self, command, case, *options, processes=1):
        run = Run([command, case, *options, "-output_dir", "own"], processes, self.folder)
        self.assertEqual(run.status, 0, run)
        return summary_in(self.folder / "own")

    def assert_same(self, text, name, value):
        self.assertAlmostEqual(number(name, text) / value, 1, delta=PRINTED, msg=text)

    def assert_bare_contact(self, text, expected):
        self.assert_same(text, "h_central", 1e6 * expected["h_central"])
        self.assert_same(text, "h_min", 1e6 * expected["h_min"])
        self.assert_same(text, "p_max", 1e-9 * expected["p_max"])
        line = [float(value) for value in re.findall(r"  p = ([\d.]+) GPa$", text, re.MULTILINE)]
        self.assertGreater(len(line), 5)
        self.assertLessEqual(max(line), 1e-9 * expected["p_max"] * (1 + SAME) + 1e-4)
        self.assertGreater(max(line), 0.85e-9 * expected["p_max"])

    def assert_own_result(self, text, processes):
        """A pair, a figure and a field that are not the program's, beside results that are the program's."""
        values = re.findall(r'\{"(\w+)\.(\w+)", "([^"]+)"\}', (SOURCE / "docs/examples/own_result.cpp").read_text(encoding="utf-8"))
        values += [(gear, key, value) for gear in ("pinion", "wheel")
                   for key, value in (("crowning", "8e-6"), ("youngs_modulus", "206e9"), ("poisson_ratio", "0.3"))]
        case = self.folder / "own_pair.yaml"
        sections = dict.fromkeys(section for section, _, _ in values)
        case.write_text("".join(f"{section}:\n" + "".join(f"  {key}: {value}\n" for name, key, value in values if name == section)
                                for section in sections), encoding="utf-8")
        periodic, steady = self.result_of("periodic", case, processes=processes), self.result_of("steady", case)
        folder = self.folder / "output/own_pair"
        summary = summary_in(folder)
        self.assertAlmostEqual(summary["floquet_modulus"], periodic["floquet_modulus"], delta=periodic["floquet_modulus_error"])
        for name in ("h_min", "p_max", "force_ratio_max"):
            self.assertAlmostEqual(summary[name] / periodic[name], 1, delta=SAME, msg=name)
        self.assert_same(text, "h_min", 1e6 * periodic["h_min"])
        self.assert_same(text, "mean", 1e-9 * summary["mean_pressure"])
        self.assertLess(summary["mean_pressure"], periodic["p_max"])
        with h5py.File(folder / "results.h5") as file:
            flow = file["pitch/flow"]
            self.assertEqual(flow.attrs["unit"], "m^2/s")
            velocity = self.result_of("info", case)["entrainment_velocity"]
            self.assertAlmostEqual(flow[()].min() / (velocity * steady["h_min"]), 1, delta=SAME)

    def test_examples_with_find_package(self):
        output_of(["cmake", "-S", self.folder / "examples", "-B", self.folder / "build", "-G", "Ninja",
                   f"-DCMAKE_PREFIX_PATH={self.prefix}", f"-DCMAKE_C_COMPILER={CC}", f"-DCMAKE_CXX_COMPILER={CXX}",
                   "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"])
        output_of(["cmake", "--build", self.folder / "build", "-j", "2"])
        for command in json.loads((self.folder / "build/compile_commands.json").read_text(encoding="utf-8")):
            self.assertNotIn(str(SOURCE), command["command"])
        film = self.result_of("steady", CIRCULAR)
        march = self.result_of("transient", BARBIERI, *SHORT)
        for processes in (1, 2):
            with self.subTest(processes=processes):
                self.assert_bare_contact(self.run_example(self.folder / "build/bare_contact", processes=processes), film)
                text = self.run_example(self.folder / "build/observed_march", BARBIERI, *SHORT, processes=processes)
                self.assert_same(text, "h_min", 1e6 * march["h_min"])
                self.assertGreater(int(text.split()[0]), 30)
                text = self.run_example(self.folder / "build/own_result", processes=processes)
                self.assert_own_result(text, processes)

    def test_examples_with_pkg_config(self):
        flags = self.flags("--cflags", "--libs")
        self.assertNotIn(str(SOURCE), " ".join(flags))
        for example in EXAMPLES:
            output_of([CXX, "-std=c++20", "-Wall", "-Wextra", "-Wshadow", "-Werror", self.folder / f"examples/{example}.cpp", *flags,
                       "-o", self.folder / example])
        film = self.result_of("steady", CIRCULAR, "-grid_nx", 33, "-grid_ny", 33)
        march = self.result_of("transient", BARBIERI, *SHORT)
        self.assert_bare_contact(self.run_example(self.folder / "bare_contact", "-nx", 33, "-ny", 33, processes=2), film)
        self.assert_same(self.run_example(self.folder / "observed_march", BARBIERI, *SHORT), "h_min",
                         1e6 * march["h_min"])

    def test_every_header_compiles_with_what_is_installed(self):
        """No installed header includes one that is not."""
        include = self.only("error.hpp").parents[1]
        headers = sorted((path.relative_to(include) for path in include.rglob("*.hpp")))
        self.assertEqual([header.name for header in headers],
                         ["case.hpp", "error.hpp", "oil.hpp", "periodic_state.hpp", "results.hpp", "simulation.hpp",
                          "stationary_film.hpp"])
        text = "".join(f'#include "{header}"\n' for header in headers)
        (self.folder / "headers.cpp").write_text(text, encoding="utf-8")
        flags = self.flags("--cflags")
        output_of([CXX, "-std=c++20", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", *flags, self.folder / "headers.cpp"])

    def test_versions_and_languages_are_asked_for(self):
        """Another minor version, or a project without C, is refused in words that say what to do."""
        for find, languages, words in (("1.1", "C CXX", "1.1"), ("1.0", "CXX", "LANGUAGES C CXX")):
            project = self.folder / f"project-{find}"
            project.mkdir()
            (project / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.16)\n"
                                                    f"project(user LANGUAGES {languages})\n"
                                                    f"find_package(gearfilm {find} REQUIRED)\n", encoding="utf-8")
            done = subprocess.run(["cmake", "-S", project, "-B", project / "build", "-G", "Ninja",
                                   f"-DCMAKE_PREFIX_PATH={self.prefix}", f"-DCMAKE_C_COMPILER={CC}",
                                   f"-DCMAKE_CXX_COMPILER={CXX}"],
                                  capture_output=True, text=True, check=False, timeout=120)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(words, done.stderr)

    def test_program_has_its_manual_page_and_completion(self):
        version = output_of([self.prefix / "bin/gearfilm", "-version"], env=environment_of(1, self.folder))
        self.assertEqual(version, output_of([PROGRAM, "-version"], env=environment_of(1, self.folder)))
        for name, kind in (("share/man/man1/gearfilm.1", "man"), ("share/bash-completion/completions/gearfilm", "completion")):
            text = (self.prefix / name).read_text(encoding="utf-8")
            self.assertEqual(text, output_of([sys.executable, "-B", SOURCE / "scripts/packaging/manual.py", kind, PROGRAM],
                                             env=environment_of(1, self.folder)))


if __name__ == "__main__":
    unittest.main()
