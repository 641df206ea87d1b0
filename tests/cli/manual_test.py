"""The manual page and the completion name what the program knows. Environment as for cli_test.py."""
import re
import shutil
import subprocess
import sys
import unittest

from films import BARBIERI
from program import PROGRAM, SOURCE, ProgramTest, environment_of


def names_in_help(text):
    return (re.findall(r"^  ([a-z]+)  ", text, re.MULTILINE), re.findall(r"^  (-\w+) ", text, re.MULTILINE))


def made(kind, folder):
    """What scripts/packaging/manual.py makes of the program."""
    return subprocess.run([sys.executable, "-B", SOURCE / "scripts/packaging/manual.py", kind, PROGRAM], capture_output=True,
                          text=True, check=True, timeout=60, env=environment_of(1, folder)).stdout


class Manual(ProgramTest):
    def setUp(self):
        super().setUp()
        self.commands, self.options = names_in_help(self.run_well("-help").stdout)
        self.assertGreater(len(self.commands), 8)
        self.assertGreater(len(self.options), 50)

    def test_page_names_every_command_and_option_once(self):
        page = made("man", self.folder).replace("\\-", "-")
        for name in [*self.commands, *self.options, "-help", "-version"]:
            self.assertEqual(len(re.findall(rf"^\\fB{name}\\fR", page, re.MULTILINE)), 1, name)

    @unittest.skipUnless(shutil.which("groff"), "groff is not installed")
    def test_page_is_typeset_without_warnings(self):
        page = made("man", self.folder)
        done = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z"], input=page, capture_output=True, text=True,
                              check=True, timeout=60)
        self.assertEqual(done.stderr, "")

    def test_two_processes_print_it_once(self):
        for command in ("-help", "parameters"):
            self.assertEqual(self.run_well(command, processes=2).stdout, self.run_well(command).stdout)

    def test_nothing_else_is_taken(self):
        for command in ("figures", "parameters"):
            self.assert_wrong([BARBIERI.name, f"the command {command} takes nothing"], command, BARBIERI)
            self.assert_wrong(["unknown option '-grid_nz 65'", "-grid_nx"], command, "-grid_nz", 65)


@unittest.skipUnless(shutil.which("bash"), "bash is not installed")
class Completion(ProgramTest):
    def setUp(self):
        super().setUp()
        self.commands, self.options = names_in_help(self.run_well("-help").stdout)
        self.script = self.folder / "completion.bash"
        self.script.write_text(made("completion", self.folder), encoding="utf-8")

    def proposed(self, *words):
        """What bash proposes for the last of the words."""
        text = ('source "$1"; shift; COMP_WORDS=(gearfilm "$@"); COMP_CWORD=$#; _gearfilm; '
                'for word in "${COMPREPLY[@]}"; do printf "%s\\n" "$word"; done')
        done = subprocess.run(["bash", "--norc", "-u", "-c", text, "bash", self.script, *words], cwd=self.folder,
                              capture_output=True, text=True, check=False, timeout=60)
        self.assertEqual(done.stderr, "")
        return sorted(done.stdout.splitlines())

    def test_commands(self):
        self.assertEqual(self.proposed(""), sorted(self.commands))
        self.assertEqual(self.proposed("pe"), ["periodic"])
        self.assertEqual(self.proposed("-log_view", "x", "tr"), ["transient"])

    def test_options(self):
        self.assertEqual(self.proposed("steady", "case.yaml", "-"), sorted([*self.options, "-help", "-version"]))
        self.assertEqual(self.proposed("steady", "case.yaml", "-grid_n"), ["-grid_nx", "-grid_ny"])

    def test_choices_of_an_option(self):
        self.assertEqual(self.proposed("transient", "case.yaml", "-model", ""),
                         ["dry", "dynamic", "quasistatic", "simplified"])
        self.assertEqual(self.proposed("transient", "case.yaml", "-model", "q"), ["quasistatic"])
        self.assertEqual(self.proposed("transient", "case.yaml", "-restart", "-mesh_p"), ["-mesh_periods"])

    def test_numbers_are_left_to_the_user(self):
        self.assertEqual(self.proposed("steady", "case.yaml", "-grid_nx", ""), [])

    def test_case_files_and_folders(self):
        for name in ("one.yaml", "two words.yml", "* star.yaml", "other.txt"):
            (self.folder / name).touch()
        (self.folder / "cases").mkdir()
        self.assertEqual(self.proposed("steady", ""), ["* star.yaml", "cases", "one.yaml", "two words.yml"])
        self.assertIn("other.txt", self.proposed("steady", "one.yaml", "-load_sharing_file", "o"))
        self.assertEqual(self.proposed("figures", ""), [])

    @unittest.skipUnless(shutil.which("shellcheck"), "shellcheck is not installed")
    def test_script_is_free_of_findings(self):
        done = subprocess.run(["shellcheck", "-s", "bash", self.script], capture_output=True, text=True, check=False,
                              timeout=60)
        self.assertEqual(done.stdout, "")


if __name__ == "__main__":
    unittest.main()
