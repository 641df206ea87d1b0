"""Rules of the house that no compiler checks. Environment: GEARFILM, the binary."""
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[1]
PROGRAM = os.path.abspath(os.environ.get("GEARFILM", SOURCE / "build/release/bin/gearfilm"))
# In the order in which data flows: a room includes itself and the rooms to its left. app includes all.
ROOMS = ["gear", "lubricant", "roughness", "algebra", "contact", "train", "parallel", "numerics", "grid", "elasticity",
         "stress", "fatigue", "rating", "film", "solver", "traction", "mesh", "dynamics", "orbits", "input", "output",
         "results", "bench", "interface", "app"]
LONGEST_FILE = 400
MEDIAN_LENGTH = 150
MOST_ARGUMENTS = 6  # of a constructor
DOCUMENTS = [*(SOURCE / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")),
             *sorted((SOURCE / "docs").rglob("*.md"))]
GUIDE = sorted((SOURCE / "docs/guide").glob("*.md"))


def read(path):
    return path.read_text(encoding="utf-8")


def sources(*suffixes):
    folders = ("include", "src", "tests", "scripts", "docs")
    return sorted(path for folder in folders for path in (SOURCE / folder).rglob("*")
                  if (path.suffix in suffixes or path.name == "run" and ".py" in suffixes)
                  and "__pycache__" not in path.parts)


def relative(path):
    return str(path.relative_to(SOURCE))


def output_of(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=True, timeout=60).stdout


def names_of_info():
    """What `gearfilm info` writes of a gear pair with a mass."""
    with tempfile.TemporaryDirectory() as folder:
        output_of("info", str(SOURCE / "input/barbieri2013.yaml"), "-output_dir", folder)
        return set(json.loads(read(pathlib.Path(folder) / "summary.json")))


class Rooms(unittest.TestCase):
    def test_every_source_file_is_in_a_room(self):
        rooms = {path.name for path in (SOURCE / "src").iterdir() if path.is_dir()}
        self.assertEqual(rooms, set(ROOMS))

    def test_rooms_include_only_rooms_to_their_left(self):
        for room in ROOMS:
            allowed = ROOMS[:ROOMS.index(room) + 1]
            for path in sorted((SOURCE / "src" / room).rglob("*")):
                for other in re.findall(r'^\s*#\s*include\s*"(?!gearfilm/)(\w+)/', read(path), re.MULTILINE):
                    self.assertIn(other, allowed, f"{relative(path)} includes {other}/")

    def test_public_headers_include_no_private_ones(self):
        headers = sorted((SOURCE / "include/gearfilm").glob("*.hpp"))
        self.assertLessEqual(len(headers), 8)
        for path in headers:
            for other in re.findall(r'^\s*#\s*include\s*"(.*)"', read(path), re.MULTILINE):
                self.assertTrue((SOURCE / "include" / other).is_file(), f"{relative(path)} includes {other}")


class Rows(unittest.TestCase):
    def test_only_the_row_axis_knows_which_rows_are_edges_and_which_are_mirrored(self):
        known = re.compile(r"rows\(\) - 1|y_begin\(\) == 0|2 \* (?:\w+\.)*rows|ny\(\) / 2|local_row\(0\)")
        for path in sources(".hpp", ".cpp"):
            if path.stem == "row_axis" or path.parts[len(SOURCE.parts)] == "tests":
                continue
            for number, line in enumerate(read(path).splitlines(), 1):
                self.assertIsNone(known.search(line), f"{relative(path)}:{number}: {line.strip()}")


class Files(unittest.TestCase):
    def test_files_are_short(self):
        lengths = {path: read(path).count("\n") for path in sources(".hpp", ".cpp", ".py", ".sh", ".txt")}
        for path, length in lengths.items():
            self.assertLessEqual(length, LONGEST_FILE, relative(path))
        self.assertLessEqual(statistics.median(lengths.values()), MEDIAN_LENGTH)

    def test_constructors_take_few_arguments(self):
        counted = 0
        for path in sorted(path for folder in ("include", "src") for path in (SOURCE / folder).rglob("*.hpp")):
            text = re.sub(r"//.*", "", read(path))
            for name in set(re.findall(r"\b(?:class|struct) (\w+)[^;{]*\{", text)):
                for arguments in re.findall(r"^\s+(?:explicit )?" + name + r"\(([^;{}]*?)\)\s*(?:[:;{]|= d)", text,
                                            re.MULTILINE):
                    outer = re.sub(r"<[^<>]*>|\([^()]*\)|\{[^{}]*\}", "", arguments)
                    self.assertLessEqual(outer.count(",") + 1, MOST_ARGUMENTS, f"{relative(path)}: {name}")
                    counted += 1
        self.assertGreater(counted, 30)

    def test_headers_are_guarded_once(self):
        for path in sources(".hpp", ".in"):
            if ".hpp" not in path.suffixes:
                continue
            self.assertEqual(len(re.findall(r"^#pragma once$", read(path), re.MULTILINE)), 1, relative(path))

    def test_no_words_of_old_cpp(self):
        for path in sources(".hpp", ".cpp"):
            self.assertNotRegex(read(path), r"\btypedef\b|\bNULL\b", relative(path))

    def test_text_is_clean(self):
        for path in [*sources(".hpp", ".cpp", ".py", ".sh", ".txt", ".in"), *DOCUMENTS]:
            content = read(path)
            self.assertTrue(content.endswith("\n"), f"{relative(path)}: no line feed at the end")
            for number, line in enumerate(content.splitlines(), 1):
                self.assertNotIn("\t", line, f"{relative(path)}:{number}: tab")
                self.assertEqual(line, line.rstrip(), f"{relative(path)}:{number}: blank at the end")

    def test_shell_scripts_stop_at_the_first_error(self):
        for path in sources(".sh"):
            self.assertIn("\nset -euo pipefail\n", read(path), relative(path))
            self.assertTrue(os.access(path, os.X_OK), f"{relative(path)} is not executable")


class Studies(unittest.TestCase):
    def test_every_study_has_one_command_and_says_what_it_shows(self):
        folders = [path for path in sorted((SOURCE / "scripts/studies").iterdir())
                   if path.is_dir() and path.name not in ("common", "__pycache__")]
        self.assertGreater(len(folders), 10)
        listed = read(SOURCE / "scripts/studies/README.md")
        for folder in folders:
            with self.subTest(study=folder.name):
                self.assertTrue(os.access(folder / "run", os.X_OK))
                text = read(folder / "README.md")
                self.assertRegex(text, r"(?m)(^    scripts/studies/\w+/|`)run\b")
                self.assertLess(len(text.splitlines()), 25)
                self.assertIn(f"]({folder.name}/README.md)", listed)
                self.assertIn(f"scripts/studies/{folder.name}/run", read(folder / "run"))

    def test_every_table_of_the_documents_is_named_by_the_study_that_writes_it(self):
        texts = [read(path) for path in sorted((SOURCE / "scripts/studies").glob("*/README.md"))]
        for table in sorted((SOURCE / "docs/data").glob("*.md")):
            with self.subTest(table=table.name):
                self.assertEqual(sum(bool(re.search(rf"[`/]{table.name}`", text)) for text in texts), 1)
                self.assertRegex(read(table), r"\A<!-- gearfilm [^,]+, .+, .+ -->\n")

    def test_the_top_of_scripts_has_doors_alone(self):
        files = {path.name for path in (SOURCE / "scripts").iterdir() if path.is_file() and not path.is_symlink()}
        self.assertEqual(files, {"README.md", "pyproject.toml", "setup.sh", "demo.sh", "test.sh", "check.sh", "pages.sh"})


class Documents(unittest.TestCase):
    def test_parameter_page_is_what_the_program_prints(self):
        self.assertEqual(read(SOURCE / "docs/parameters.md"), output_of("parameters"),
                         "write docs/parameters.md again: gearfilm parameters > docs/parameters.md")

    def test_page_of_constants_is_what_the_program_prints(self):
        self.assertEqual(read(SOURCE / "docs/constants.md"), output_of("constants"),
                         "write docs/constants.md again: gearfilm constants > docs/constants.md")

    def test_figure_page_is_what_the_program_prints(self):
        self.assertEqual(read(SOURCE / "docs/results.md"), output_of("figures"),
                         "write docs/results.md again: gearfilm figures > docs/results.md")

    def test_symbols_have_keys_and_names_that_exist(self):
        keys = set(re.findall(r"^\| `(\S+)`", output_of("parameters"), re.MULTILINE))
        named = "".join([output_of("figures"), *map(read, GUIDE)])
        names = set(re.findall(r"`(\w+)`", named)) | names_of_info()
        rows = [line.split("|") for line in read(SOURCE / "docs/symbols.md").splitlines() if line.startswith("| $")]
        self.assertGreater(len(rows), 50)
        for cells in rows:
            self.assertEqual(len(cells), 7, cells)
            self.assertLessEqual(set(re.findall(r"`([^`]+)`", cells[4])), keys, cells[1])
            self.assertLessEqual(set(re.findall(r"`([^`]+)`", cells[5])), names, cells[1])

    def test_the_guide_lists_its_pages_and_explains_their_terms(self):
        contents = read(SOURCE / "docs/guide/README.md")
        pages = [path for path in GUIDE if path.name != "README.md"]
        self.assertGreater(len(pages), 10)
        for path in pages:
            self.assertIn(f"]({path.name})", contents)
        explained = [path for path in pages if "](../terms.md#" in read(path)]
        self.assertGreater(len(explained), 10)

    def test_commands_and_options_of_the_documents_exist(self):
        text = output_of("-help")
        commands = set(re.findall(r"^  (\w+)  ", text, re.MULTILINE))
        options = set(re.findall(r"^  (-\w+) ", text, re.MULTILINE))
        sections = {option[1:].split("_")[0] for option in options}
        petsc = re.compile(r"-(steady|step|dry)_(snes|ksp|ts)_")
        for path in DOCUMENTS:
            content = read(path)
            for command in re.findall(r"`(?:mpiexec -n \w+ )?gearfilm ([a-z]+)", content):
                self.assertIn(command, commands, relative(path))
            for option in re.findall(r"(?<![\w/-])-[a-z]+_\w+", content):
                if option[1:].split("_")[0] in sections and not petsc.match(option):
                    self.assertIn(option, options, relative(path))


class Release(unittest.TestCase):
    def test_one_version_everywhere(self):
        build = read(SOURCE / "CMakeLists.txt")
        version = re.search(r"^project\(gearfilm VERSION (\d+\.\d+\.\d+) ", build, re.MULTILINE)[1]
        minor = version.rpartition(".")[0]
        for name, pattern, expected in (("CITATION.cff", r"^version: (\S+)$", version),
                                        ("CHANGELOG.md", r"^## (\S+)", version),
                                        ("docs/examples/CMakeLists.txt", r"^find_package\(gearfilm (\S+) ", minor),
                                        ("docs/examples/README.md", r"`find_package\(gearfilm (\S+)\)`", minor),
                                        ("docs/guide/library.md", r"^find_package\(gearfilm (\S+) ", minor)):
            found = re.search(pattern, read(SOURCE / name), re.MULTILINE)
            self.assertEqual(found and found[1], expected, name)

    def test_continuous_integration_is_what_must_pass(self):
        workflow = read(SOURCE / ".github/workflows/ci.yml")
        self.assertRegex(workflow, r"(?m)^ +run: \.ci/run$")
        self.assertTrue(os.access(SOURCE / ".ci/run", os.X_OK))
        for release in ("bookworm", "trixie"):
            self.assertIn(release, re.search(r"release: \[(.*)\]", workflow)[1].split(", "))


class Links(unittest.TestCase):
    """scripts/checks/check_links.py, of the documents and of a folder with one broken link."""

    def check(self, folder):
        return subprocess.run([sys.executable, "-B", SOURCE / "scripts/checks/check_links.py", folder], capture_output=True,
                              text=True, check=False, timeout=60)

    def check_page(self, text):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "other.md").write_text("# A title\n\n## Twice: `here`\n\n## Twice: here\n", encoding="utf-8")
            (folder / "page.md").write_text(f"# Page\n\n{text}\n", encoding="utf-8")
            return self.check(folder)

    def test_links_and_anchors_of_the_documents_lead_somewhere(self):
        done = self.check(SOURCE)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertGreater(int(done.stdout.split()[0]), 50)

    def test_whole_links_pass(self):
        for text in ("[a](other.md)", "[a](other.md#twice-here-1), [b](#page)", "[a](https://example.org/#x)",
                     "`[a](none.md)`", "    [a](none.md)", "```\n[a](none.md)\n```"):
            with self.subTest(text=text):
                self.assertEqual(self.check_page(text).returncode, 0)

    def test_a_broken_link_is_named(self):
        for text in ("[a](none.md)", "[a](other.md#none)", "[a](#none)", "![a](none.png)", "[a](../page.md)",
                     "[a](other.md#twice-here-2)", "- [a](none.md)\n    [b](none.md)"):
            with self.subTest(text=text):
                done = self.check_page(text)
                self.assertEqual(done.returncode, 1)
                self.assertRegex(done.stderr, r"^check_links: page.md:3: \(.*\): .*; correct it, or the heading\n")


if __name__ == "__main__":
    unittest.main()
