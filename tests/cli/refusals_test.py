"""Wrong input from outside: one message, exit status 1, nothing written.

tests/bad_input/expected.json holds the corpus: by group, command lines (of paths from the source folder) and the words
their messages must have. What is too large or no file to be kept there is made here.
"""
import concurrent.futures
import json
import os
import shlex
import tempfile
import unittest

from films import BARBIERI, CIRCULAR
from program import INPUT, SOURCE, ProgramTest, Run, names_below
from vibration import barbieri_with_inertias

BAD_INPUT = SOURCE / "tests/bad_input"
LONG = 10_000_000
PLASTIC = INPUT / "plastic_wheel.yaml"  # its modulus is no metal's, which is warned of
TOO_LARGE = ["larger than 1 MB"]


def without_repetitions(pairs):
    table = dict(pairs)
    if len(table) < len(pairs):
        raise ValueError("two entries of the corpus are the same")
    return table


CORPUS = json.loads((BAD_INPUT / "expected.json").read_text(encoding="utf-8"), object_pairs_hook=without_repetitions)
MADE = {
    "10 MB of comments": (b"# the pair of the paper\n" * (LONG // 24), TOO_LARGE),
    "10 MB of keys": (b"pinion.teeth: 28\n" * (LONG // 17), TOO_LARGE),
    "10 MB in one line": (b"case.name: " + b"x" * LONG, TOO_LARGE),
    "10 MB of zero bytes": (bytes(LONG), TOO_LARGE),
    "1 MB of keys": (b"".join(b"key%d: 1\n" % n for n in range(70_000)), ["unknown key 'key0'"]),
    "1 MB in one value": (b"pinion.teeth: " + b"2" * 1_000_000, ["pinion.teeth", "not a whole number", "bytes"]),
    "10000 brackets": (b"[" * 10_000, ["list"]),
    "10000 braces": (b"{" * 10_000, ["key"]),
    "10000 nested braces": (b"pinion: " + b"{a: " * 10_000, ["nested too deeply"]),
    "10000 nested lists": (b"- " * 10_000, ["list"]),
    "1000 nested blocks": (b"".join(b" " * n + b"a:\n" for n in range(1000)), ["nested too deeply"]),
    "10000 question marks": (b"? " * 10_000, ["key"]),
    "10001 quotes": (b"'" * 10_001, ["malformed YAML", "quote"]),
}


def words_of(command_line):
    """Words of a command line; paths from the source folder become absolute."""
    return [str(SOURCE / word) if word.startswith(("input", "tests/")) else word for word in shlex.split(command_line)]


def run_alone(arguments):
    """A run in a folder of its own, and what it left there."""
    with tempfile.TemporaryDirectory() as folder:
        return Run(arguments, 1, folder), names_below(folder)


class WrongInput(ProgramTest):
    """Exit status 1: one line on stderr that says what to do, nothing written."""

    def test_corpus(self):
        entries = [(line, words) for group in CORPUS.values() for line, words in group.items()]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            runs = pool.map(run_alone, [words_of(line) for line, _ in entries])
            for (line, words), (run, written) in zip(entries, runs):
                with self.subTest(line):
                    self.assert_message(run, 1, "gearfilm: wrong input: ", words)
                    self.assertLess(len(run.stderr), 1500)
                    self.assertEqual(written, [])

    def test_two_processes_say_the_same_once(self):
        for group, entries in CORPUS.items():
            line = list(entries)[1]
            with self.subTest(group=group, line=line):
                alone, together = (self.run_program(*words_of(line), processes=n) for n in (1, 2))
                self.assertEqual((alone.status, alone.stderr), (together.status, together.stderr))
                self.assertEqual(self.content(), [])

    def test_every_file_is_in_the_corpus(self):
        named = {word for group in CORPUS.values() for line in group for word in shlex.split(line)}
        for file in BAD_INPUT.iterdir():
            if file.name != "expected.json":
                self.assertIn(str(file.relative_to(SOURCE)), named)

    def test_large_and_deep_files(self):
        for name, (content, words) in MADE.items():
            with self.subTest(name):
                case = self.folder / "case.yaml"
                case.write_bytes(content)
                self.assert_wrong(words, "info", case)

    def test_large_options(self):
        value = "x" * 100_000
        for option, words in (("-grid_nx", ["whole number"]), ("-case_name", ["-output_dir"]),
                              (f"-{value[:10_000]}", ["unknown option", "did you mean"])):
            with self.subTest(option=option[:20]):
                self.assert_wrong([*words, "bytes"], "info", BARBIERI, option, value)

    def test_a_pipe_is_no_file(self):
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        self.assert_wrong(["not a regular file"], "info", pipe)
        self.assert_wrong(["not a regular file"], "info", BARBIERI, "-model", "quasistatic", "-load_sharing_kind",
                          "table", "-load_sharing_file", pipe)

    @unittest.skipIf(os.geteuid() == 0, "root reads every file")
    def test_a_file_without_permission(self):
        case = self.write_case("case.name: secret\n")
        case.chmod(0)
        self.assert_wrong(["cannot be opened", "permissions"], "info", case)

    @unittest.skipIf(os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGESIZE") > 80e9, "the grid would fit")
    def test_grid_larger_than_the_memory(self):
        for processes in (1, 2):
            self.assert_wrong(["16385 x 16385 nodes", "GB", "grid.nx"], "info", BARBIERI, "-grid_nx", 16385,
                              "-grid_ny", 16385, processes=processes)

    def test_mass_of_a_sweep_beside_inertias(self):
        with_inertias = self.write_case(barbieri_with_inertias(pinion=1e-3, wheel=4e-3))
        for values in (["-sweep_values", "0.3, 0.4"], ["-sweep_from", 0.3, "-sweep_to", 0.4]):
            self.assert_wrong(["equivalent_mass", "inertias"], "sweep", with_inertias, "-sweep_over", "equivalent_mass",
                              *values)

    def test_output_folder_that_cannot_be_made(self):
        below_a_file = self.write_case("not a folder", "file") / "deeper"
        for command in ("info", "steady", "bench"):
            for processes in (1, 2):
                self.assert_wrong(["deeper", "-output_dir"], command, BARBIERI, "-output_dir", below_a_file,
                                  processes=processes)

    def test_more_processes_than_rows(self):
        few_rows = ["-grid_ny", 9, "-grid_y_half", 1.1]
        self.assert_wrong(["ny = 9", "10 processes"], "steady", CIRCULAR, *few_rows, processes=10)
        self.assert_wrong(["ny = 9", "10 processes"], "sweep", BARBIERI, *few_rows, "-sweep_values", 15000,
                          "-sweep_groups", 1, processes=10)


class RightInput(ProgramTest):
    """What looks odd, but is right."""

    def test_line_ends_byte_order_mark_and_decimal_zeros(self):
        original = BARBIERI.read_bytes()
        usual = self.run_well("info", BARBIERI).stdout
        for name, content in (("CRLF", original.replace(b"\n", b"\r\n")), ("BOM", b"\xef\xbb\xbf" + original),
                              ("zeros", original.replace(b"teeth: 28", b"teeth: 0028")),
                              ("quotes", original.replace(b"teeth: 28", b"teeth: '28'"))):
            with self.subTest(name):
                case = self.folder / "case.yaml"
                case.write_bytes(content)
                self.assertEqual(self.run_well("info", case).stdout, usual)

    def test_every_case_is_usual_but_the_plastic_and_the_undercut_wheel(self):
        unusual = {PLASTIC: "softer than the metals of gears", INPUT / "fzg_a.yaml": "undercuts the teeth of the wheel"}
        for case in sorted(set(INPUT.glob("*.yaml")) - set(unusual)):
            self.run_well("info", case)
        for case, word in unusual.items():
            run = self.run_program("info", case)
            self.assertEqual((run.status, run.stderr.count("\n")), (0, 1), run)
            self.assertIn(word, run.stderr)


if __name__ == "__main__":
    unittest.main()
