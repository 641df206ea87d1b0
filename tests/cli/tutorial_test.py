"""Every command of docs/tutorial.md runs, on the case that it has the reader write; tutorial and README say the numbers
that these commands give. Environment as for cli_test.py."""
import os
import re
import shlex
import subprocess
import sys
import unittest

from films import summary_in
from program import SOURCE, ProgramTest
from shortened import SHORT, shortened

TEXT = (SOURCE / "docs/tutorial.md").read_text(encoding="utf-8")
PLOTS = re.findall(r"^    python3 -m gearfilm plot (\w+) (\S+)$", TEXT, re.MULTILINE)
# Numbers of the tutorial: the words around each, the folder of the command that gives it, where it stands in the
# summary, and its unit.
SAID = ((r"`contact_ratio` \((\S+) here\)", "my_pair", ("contact_ratio",), 1),
        (r"`p_hertz` \((\S+) GPa\)", "my_pair", ("p_hertz",), 1e9),
        (r"`f_n` \((\S+) kHz\)", "my_pair", ("f_n",), 1e3),
        (r"`f_m` \((\S+) kHz\)", "my_pair", ("f_m",), 1e3),
        (r"the film to expect, (\S+) µm", "my_pair", ("nijenbanning_venner_moes_h_central",), 1e-6),
        (r"with a penetration of (\S+) µm", "bending", ("entry_penetration",), 1e-6),
        (r"instead of (\S+) µm", "bending", ("te_peak_to_peak",), 1e-6),
        (r"now swings by (\S+) µm", "relief", ("te_peak_to_peak",), 1e-6),
        (r"as if it were at rest: (\S+) µm", "steady", ("h_central",), 1e-6),
        (r"an error of at most about (\S+) µm", "steady", ("h_central_error",), 1e-6),
        (r"damping that films give: (\S+) % of", "eigen", ("film_damping_ratio",), 1e-2),
        (r"`periodic` below finds (\S+) %", "periodic", ("damping_ratio",), 1e-2),
        (r"the program \((\d+) x \d+ nodes\)", "periodic", ("nx",), 1),
        (r"the program \(\d+ x (\d+) nodes\)", "periodic", ("ny",), 1),
        (r"the smallest film is (\S+) ±", "first_look", ("h_min",), 1e-6),
        (r"± (\S+) µm on the first grid", "first_look", ("h_min_error",), 1e-6),
        (r"first grid and (\S+) ±", "periodic", ("h_min",), 1e-6),
        (r"± (\S+) µm on the second one", "periodic", ("h_min_error",), 1e-6),
        (r"largest force on a contact is (\S+) ±", "periodic", ("force_ratio_max",), 1),
        (r"± (\S+) times the static force on both", "periodic", ("force_ratio_max_error",), 1),
        (r"`floquet_modulus` \((\S+)\)", "periodic", ("floquet_modulus",), 1),
        (r"contact is first lost at (\S+) rpm", "branches", ("bifurcations", 0, "speed_rpm"), 1))


def folder_of(words):
    """Where a command of the tutorial writes: its -output_dir, or output/ and the name of the case."""
    if "-output_dir" in words:
        return words[words.index("-output_dir") + 1]
    return "output/" + words[1].rpartition("/")[2].removesuffix(".yaml")


def last_digit(number):
    """The unit of the last digit of a number that is written out."""
    return 10.0 ** -len(number.partition(".")[2])


class Tutorial(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write_case(re.search(r"```yaml\n(.*?)```", TEXT, re.DOTALL)[1], "my_pair.yaml")
        (self.folder / "input").symlink_to(SOURCE / "input")

    def commands(self):
        return [shlex.split(words) for words in re.findall(r"^    gearfilm (.*)$", TEXT, re.MULTILINE)]

    def test_the_tutorial_has_every_command_that_computes(self):
        self.assertEqual({words[0] for words in self.commands()}, set(SHORT))

    def test_commands_run_and_their_results_are_drawn(self):
        for words in self.commands():
            with self.subTest(command=words):
                run = self.run_program(*shortened(words))
                self.assertEqual(run.status, 0, run)
                self.assertTrue((self.folder / folder_of(words) / "summary.json").exists())
        self.assertGreater(len(PLOTS), 5)
        package = os.environ | {"PYTHONPATH": str(SOURCE / "scripts")}
        for kind, folder in PLOTS:
            with self.subTest(kind=kind, folder=folder):
                done = subprocess.run([sys.executable, "-B", "-m", "gearfilm", "plot", kind, folder], cwd=self.folder,
                                      env=package, timeout=120, capture_output=True, text=True, check=False)
                self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_numbers_are_those_of_the_commands(self):
        text, summaries = " ".join(TEXT.split()), {}
        commands = {folder_of(words).rpartition("/")[2]: words for words in self.commands()}
        for pattern, folder, place, unit in SAID:
            with self.subTest(pattern):
                if folder not in summaries:
                    self.assertEqual(self.run_program(*commands[folder]).status, 0)
                    summaries[folder] = summary_in(self.folder / folder_of(commands[folder]))
                value = summaries[folder]
                for step in place:
                    value = value[step]
                number = re.search(pattern, text)[1]
                self.assertAlmostEqual(value / unit, float(number), delta=0.6 * last_digit(number))


class Readme(ProgramTest):
    def test_its_pair_has_the_film_and_the_vibration_that_it_says(self):
        text = (SOURCE / "README.md").read_text(encoding="utf-8")
        self.write_case(re.search(r"```yaml\n(.*?)```", text, re.DOTALL)[1], "my_pair.yaml")
        self.assertEqual(self.run_program("periodic", "my_pair.yaml").status, 0)
        summary = summary_in(self.folder / "output/my_pair")
        said = re.search(r"smallest film of ([\d.]+) µm, a transmission error of ([\d.]+) µm .*? oscillation of "
                         r"([\d.]+) kHz with a damping ratio of ([\d.]+) %", " ".join(text.split()))
        for number, name, unit in zip(said.groups(), ("h_min", "transmission_error_peak_to_peak", "free_frequency",
                                                      "damping_ratio"), (1e-6, 1e-6, 1e3, 1e-2)):
            with self.subTest(name):
                self.assertAlmostEqual(summary[name] / unit, float(number), delta=0.6 * last_digit(number))


if __name__ == "__main__":
    unittest.main()
