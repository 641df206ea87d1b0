"""Cases as YAML libraries save them: the same pair, whatever the spelling of numbers and of yes and no.

Written by hand are the forms of libraries in several languages; where Python has PyYAML, its own files are read too.
"""
import importlib.util
import json
import re
import unittest

from films import summary_in
from program import INPUT, ProgramTest

CASES = sorted(INPUT.glob("*.yaml"))
TRUE, FALSE = {"yes", "true"}, {"no", "false"}
KEY = re.compile(r"(?P<indent> *)(?P<key>[\w.]+):(?: +(?P<value>[^#]+?))? *(?:#.*)?$")


def loaded(path):
    """A case as nested dictionaries, its values typed as YAML 1.1 types them."""
    case, section = {}, None
    for line in path.read_text(encoding="utf-8").splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        key, value = KEY.match(line)["key"], KEY.match(line)["value"]
        if not line.startswith(" "):
            section = case
        if value is None:
            section = case[key] = {}
        else:
            section[key] = typed(value)
    return case


def typed(word):
    if word in TRUE | FALSE:
        return word in TRUE
    for kind in (int, float):
        try:
            return kind(word)
        except ValueError:
            pass
    return word


def in_blocks(case, scalar, indent="  "):
    """Text with a line for each value, as scalar writes it."""
    lines = []
    for key, value in case.items():
        if isinstance(value, dict):
            lines += [f"{key}:", *(f"{indent}{name}: {scalar(entry)}" for name, entry in value.items())]
        else:
            lines.append(f"{key}: {scalar(value)}")
    return "---\n" + "\n".join(lines) + "\n"


def by_python(value):
    return {True: "True", False: "False"}[value] if isinstance(value, bool) else str(value)


def by_java(value):
    """Capital E, whole numbers of a double with a dot."""
    return str(value).lower() if isinstance(value, bool) else f"{value:.17E}" if isinstance(value, float) else str(value)


def in_quotes(value):
    return json.dumps(str(value).lower() if isinstance(value, bool) else str(value))


def folded(value):
    """Long text over several lines, as in JavaScript."""
    if isinstance(value, str) and len(value) > 40:
        middle = value.index(" ", 40)
        return f">-\n        {value[:middle]}\n        {value[middle + 1:]}"
    return json.dumps(value) if isinstance(value, bool) else f"{value}"


HANDS = {"Python": lambda case: in_blocks(case, by_python),
         "Java": lambda case: in_blocks(case, by_java),
         "quotes": lambda case: in_blocks(case, in_quotes),
         "JavaScript": lambda case: in_blocks(case, folded, indent="    "),
         "JSON": lambda case: json.dumps(case, indent=2),
         "JSON in one line": json.dumps}


def by_pyyaml():
    """PyYAML's own ways to load and save a file."""
    yaml = importlib.import_module("yaml")
    for sort_keys in (True, False):
        for flow in (True, False, None):
            yield f"PyYAML {sort_keys} {flow}", lambda path, sort_keys=sort_keys, flow=flow: yaml.safe_dump(
                yaml.safe_load(path.read_text(encoding="utf-8")), sort_keys=sort_keys, default_flow_style=flow)


class SavedCases(ProgramTest):
    def info(self, path):
        """What `info` prints and leaves."""
        run = self.run_program("info", path, "-output_dir", "info")
        self.assertEqual(run.status, 0, run)
        return run.stdout, run.stderr.replace(str(path), "CASE"), summary_in(self.folder / "info")

    def assert_same(self, texts):
        """The texts of every case mean the same as the original. Each case takes every third of the forms in turn."""
        for number, case in enumerate(CASES):
            wanted = self.info(case)
            for name, write in list(texts.items())[number % 3::3]:
                with self.subTest(case=case.stem, saved=name):
                    self.assertEqual(self.info(self.write_case(write(case), f"{case.stem}.yaml")), wanted)

    def test_by_hand(self):
        self.assert_same({name: lambda path, write=write: write(loaded(path)) for name, write in HANDS.items()})

    @unittest.skipUnless(importlib.util.find_spec("yaml"), "no PyYAML on this machine")
    def test_by_a_library(self):
        self.assert_same(dict(by_pyyaml()))

    def test_the_cases_have_what_libraries_write_in_another_way(self):
        values = [value for case in CASES for entry in loaded(case).values()
                  for value in (entry.values() if isinstance(entry, dict) else [entry])]
        self.assertTrue(any(isinstance(value, bool) for value in values))
        self.assertTrue(any(isinstance(value, float) and value < 1e-4 for value in values))
        self.assertTrue(any(isinstance(value, str) and len(value) > 40 for value in values))


class YesAndNo(ProgramTest):
    def test_true_and_false_on_the_command_line_and_in_the_file(self):
        case = self.write_case((INPUT / "barbieri2013.yaml").read_text(encoding="utf-8") + "\nkeep_checkpoint: false\n")
        self.run_well("info", case, "-keep_checkpoint", "TRUE")
        self.assert_wrong(["keep_checkpoint", "on", "no, yes"], "info", case, "-keep_checkpoint", "on")


if __name__ == "__main__":
    unittest.main()
