"""Every case in input says what it shows and with which command; the command runs. Environment as for cli_test.py."""
import re
import shlex
import unittest

from films import summary_in
from program import INPUT, SOURCE, ProgramTest
from shortened import SHORT, shortened

CASES = sorted(INPUT.glob("*.yaml"))
DOCUMENTS = [SOURCE / "docs/guide/README.md", SOURCE / "docs/gallery.md"]

LARGEST_IMAGE = 150_000  # bytes


class NoCommand(Exception):
    """A case file that does not begin as the others do."""


def command_in(text, name):
    """The words behind 'gearfilm' in the second line of a case file; the first one says what it shows."""
    lines = [*text.splitlines(), "", ""]
    if not re.match(r"# [A-Z].*[.]$", lines[0]):
        raise NoCommand(f"{name}: the first line is not a comment with a sentence")
    found = re.match(r"#   gearfilm (.+)$", lines[1])
    if not found:
        raise NoCommand(f"{name}: the second line is not '#   gearfilm COMMAND input/{name} ...'")
    words = shlex.split(found[1])
    if len(words) < 2 or words[0] not in SHORT or words[1] != f"input/{name}":
        raise NoCommand(f"{name}: '{found[1]}' is no command on input/{name}")
    return words


class Examples(ProgramTest):
    def test_every_case_begins_with_what_it_shows_and_a_command_that_runs(self):
        self.assertGreaterEqual(len(CASES), 8)
        for path in CASES:
            with self.subTest(case=path.name):
                words = command_in(path.read_text(encoding="utf-8"), path.name)
                run = self.run_program(*shortened([words[0], path, *words[2:]]), "-output_dir", path.stem)
                self.assertEqual(run.status, 0, run)
                self.assertGreater(len(summary_in(self.folder / path.stem)), 3)

    def test_full_commands_have_no_wrong_option(self):
        """The options that the short run replaces are known too: `info` takes all of them."""
        for path in CASES:
            with self.subTest(case=path.name):
                words = command_in(path.read_text(encoding="utf-8"), path.name)
                run = self.run_program("info", path, *words[2:], "-output_dir", "info")
                self.assertEqual(run.status, 0, run)

    def test_documents_have_every_case_with_its_command(self):
        for document in DOCUMENTS:
            text = document.read_text(encoding="utf-8")
            for path in CASES:
                with self.subTest(document=document.name, case=path.name):
                    words = command_in(path.read_text(encoding="utf-8"), path.name)
                    self.assertTrue(f"gearfilm {shlex.join(words)}" in text, shlex.join(words))

    def test_gallery_has_a_figure_of_every_case_and_the_command_that_draws_it(self):
        text = DOCUMENTS[1].read_text(encoding="utf-8")
        for path in CASES:
            with self.subTest(case=path.name):
                plot = re.search(rf"^    PYTHONPATH=scripts python3 -m gearfilm plot (\w+) output/{path.stem}$", text,
                                 re.MULTILINE)
                self.assertTrue(plot and (SOURCE / f"scripts/gearfilm/drawing/{plot[1]}.py").exists())
                image = f"figures/gallery_{path.stem}.png"
                self.assertTrue(f"]({image})" in text)
                self.assertLess((SOURCE / "docs" / image).stat().st_size, LARGEST_IMAGE)

    def test_a_case_without_them_is_found(self):
        case = CASES[0].read_text(encoding="utf-8")
        name = CASES[0].name
        without_command = re.sub(r"\n#   gearfilm .*", "", case, count=1)
        of_another = case.replace(f"input/{name}", "input/other.yaml", 1)
        for text in ("", case.partition("\n")[2], without_command, of_another):
            self.assertNotEqual(text, case)
            with self.assertRaises(NoCommand):
                command_in(text, name)


if __name__ == "__main__":
    unittest.main()
