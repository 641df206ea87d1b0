"""Every command of docs/tutorial.md runs, on the case that it has the reader write; and the README's pair gives the
numbers that stand there. Environment as for cli_test.py."""
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


def folder_of(words):
    """Where a command of the tutorial writes: its -output_dir, or output/ and the name of the case."""
    if "-output_dir" in words:
        return words[words.index("-output_dir") + 1]
    return "output/" + words[1].rpartition("/")[2].removesuffix(".yaml")


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
                last_digit = unit * 10.0 ** -len(number.partition(".")[2])
                self.assertAlmostEqual(summary[name], unit * float(number), delta=0.6 * last_digit)


if __name__ == "__main__":
    unittest.main()
