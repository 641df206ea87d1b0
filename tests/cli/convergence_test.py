"""scripts/studies/convergence: its reduced studies against tests/reference/convergence.json, its analysis, its refusals."""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from program import PROGRAM, SECONDS, SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "scripts"))
from studies.convergence.limit import limit_of  # noqa: E402

SCRIPT = SOURCE / "scripts/studies/convergence/run"
REFERENCE = json.loads((SOURCE / "tests/reference/convergence.json").read_text(encoding="utf-8"))
STUDIES = ("steady", "time", "domain")
RUN_MADE = "convergence: gearfilm "
# Stands in for gearfilm: values with an error of dT^2, and a chosen step that is not solved.
STAND_IN = """#!{python}
import json, pathlib, sys
options = dict(zip(sys.argv[3::2], sys.argv[4::2]))
dT = float(options["-time_dt"])
if dT == {failing}:
    print("not solved", file=sys.stderr)
    sys.exit({status})
values = dict.fromkeys(("force_ratio_max", "p_max", "h_min", "H0", "V0"), 1 + dT ** 2)
folder = pathlib.Path(options["-output_dir"])
(folder / "summary.json").write_text(json.dumps({{**values, "completed": True}}))
"""


def converge(folder, *arguments, program=PROGRAM):
    command = [sys.executable, "-B", str(SCRIPT), str(folder), *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False,
                          env={**os.environ, "GEARFILM": str(program)})


class Analysis(unittest.TestCase):
    def assert_limit(self, values, order, value, bar):
        limit = limit_of(values)
        for name, found, expected in zip(limit._fields, limit, (order, value, bar)):
            if expected is None:
                self.assertIsNone(found, f"{name} of {values}")
            else:
                self.assertAlmostEqual(found, expected, delta=1e-12, msg=f"{name} of {values}")

    def test_second_order_values_have_their_exact_limit(self):
        for count in (3, 4, 6):
            self.assert_limit([2.5 - 0.3 / 4 ** n for n in range(count)], 2.0, 2.5, 0.0)

    def test_bar_is_what_the_last_run_changed(self):
        # Pairs (1, 1.8) and (1.8, 2): limits 1.8 + 0.8/3 and 2 + 0.2/3.
        self.assert_limit([1.0, 1.8, 2.0], 2.0, 2 + 0.2 / 3, 0.0)
        # Order log2(0.8/0.25) = 1.68, trusted.
        self.assert_limit([1.0, 1.8, 2.05], math.log2(3.2), 2.05 + 0.25 / 3, abs(0.25 + 0.25 / 3 - 0.8 / 3))

    def test_bar_covers_a_first_order_error(self):
        values = [2.5 - 0.3 / 2 ** n for n in range(4)]
        limit = limit_of(values)
        self.assertAlmostEqual(limit.order, 1.0, delta=1e-12)
        self.assertAlmostEqual(limit.bar, values[3] - values[2], delta=1e-12)
        self.assertLess(abs(limit.value - 2.5), limit.bar)

    def test_values_that_scatter_have_a_wide_bar(self):
        for values in ([1.0, 1.2, 1.1], [1.1, 1.0, 1.15], [1.0, 1.1, 1.3], [1.0, 1.0, 1.1]):
            limit = limit_of(values)
            self.assertGreaterEqual(limit.bar, abs(values[2] - values[1]) * (1 - 1e-12), values)
        # Differences that shrink too fast to be believed: order log2(20) = 4.3.
        self.assertGreaterEqual(limit_of([1.0, 1.2, 1.21]).bar, 0.01 * (1 - 1e-12))

    def test_values_that_stay(self):
        self.assert_limit([3.0, 3.0, 3.0], None, 3.0, 0.0)

    def test_two_values_have_a_limit_without_an_order(self):
        self.assert_limit([1.0, 1.3], None, 1.4, 0.3)

    def test_too_few_values(self):
        for values in ([], [1.0], [None, 1.0], [1.0, None, 1.1], [None, None]):
            self.assertEqual(limit_of(values), (None, None, None), values)

    def test_only_the_finest_unbroken_values_count(self):
        self.assertEqual(limit_of([9.0, None, 1.0, 1.8, 2.0]), limit_of([1.0, 1.8, 2.0]))
        self.assertEqual(limit_of([None, 1.0, 1.8, 2.0, None]), limit_of([1.0, 1.8, 2.0]))


class Reduced(unittest.TestCase):
    """The reduced studies, solved once."""

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name) / "new/convergence"
        cls.run_of_all = converge(cls.folder, "--reduced")
        if cls.run_of_all.returncode != 0:
            raise AssertionError(cls.run_of_all)
        cls.results = json.loads((cls.folder / "convergence.json").read_text(encoding="utf-8"))

    def test_orders_and_limits_are_those_of_the_full_studies(self):
        for study in ("steady", "time"):
            for series, quantities in REFERENCE[study].items():
                for name, expected in quantities.items():
                    with self.subTest(study=study, series=series, quantity=name):
                        self.assert_converges(self.results[study][series]["quantities"][name], expected)

    def assert_converges(self, found, expected):
        if "order" in expected:
            low, high = expected["order"]
            self.assertGreaterEqual(found["order"], low)
            self.assertLessEqual(found["order"], high)
        distance = abs(found["limit"] - expected["limit"])
        self.assertLessEqual(distance, expected["rel_tol"] * abs(expected["limit"]))
        self.assertLessEqual(distance, found["bar"] + expected["bar"], "the error bars do not meet")

    def test_changes_with_the_domain(self):
        for series, quantities in REFERENCE["domain"].items():
            for name, expected in quantities.items():
                changes = self.results["domain"][series]["quantities"][name]["changes"]
                self.assertEqual(len(changes), len(expected["changes"]))
                for found, change in zip(changes, expected["changes"]):
                    self.assertAlmostEqual(found, change, delta=expected["tolerance"], msg=f"{series}, {name}")

    def test_all_is_written_and_printed(self):
        self.assertEqual(self.run_of_all.stderr, "")
        for study in STUDIES:
            text = (self.folder / f"convergence_{study}.md").read_text(encoding="utf-8")
            self.assertIn(text, self.run_of_all.stdout)
            for ending, beginning in (("png", b"\x89PNG"), ("pdf", b"%PDF")):
                content = (self.folder / f"convergence_{study}.{ending}").read_bytes()
                self.assertTrue(content.startswith(beginning), f"{study}.{ending}")
        self.assertEqual(set(self.results), set(STUDIES))

    def test_second_call_repeats_no_run(self):
        self.assertIn(RUN_MADE, self.run_of_all.stdout)
        summaries = sorted(self.folder.glob("runs/*/summary.json"))
        before = [path.stat().st_mtime_ns for path in summaries]
        # A program that does not exist: no run can be made.
        again = converge(self.folder, "--reduced", program=self.folder / "absent")
        self.assertEqual((again.returncode, again.stderr), (0, ""), again)
        self.assertNotIn(RUN_MADE, again.stdout)
        self.assertEqual([path.stat().st_mtime_ns for path in summaries], before)
        results = json.loads((self.folder / "convergence.json").read_text(encoding="utf-8"))
        self.assertEqual(results, self.results)


class WithStandIn(ProgramTest):
    """How runs are kept, and what becomes of those that fail; the study time, without gearfilm."""

    def program(self, failing=None, status=2):
        path = self.folder / "stand_in"
        path.write_text(STAND_IN.format(python=sys.executable, failing=failing, status=status), encoding="utf-8")
        path.chmod(0o755)
        return path

    def converge(self, **failure):
        return converge(self.folder / "study", "time", "--reduced", program=self.program(**failure))

    def quantity(self, name="H0"):
        text = (self.folder / "study/convergence.json").read_text(encoding="utf-8")
        return json.loads(text)["time"]["march"]["quantities"][name]

    def test_limit_of_second_order_values(self):
        run = self.converge()
        self.assertEqual((run.returncode, run.stderr), (0, ""), run)
        found = self.quantity()
        self.assertAlmostEqual(found["limit"], 1, delta=1e-12)
        self.assertAlmostEqual(found["order"], 2, delta=1e-9)

    def test_run_that_is_not_solved_is_a_remark_and_is_tried_again(self):
        run = self.converge(failing=0.1)
        self.assertEqual((run.returncode, run.stderr), (0, "not solved\n"), run)
        self.assertIn("| not solved | 1.00250 | 1.00063 |", run.stdout)
        self.assertEqual(self.quantity()["values"][0], None)
        self.assertEqual(self.quantity()["order"], None)
        again = self.converge()
        self.assertEqual(again.stdout.count(RUN_MADE), 1, again)
        self.assertAlmostEqual(self.quantity()["order"], 2, delta=1e-9)

    def test_all_runs_not_solved(self):
        path = self.folder / "stand_in"
        path.write_text("#!/bin/sh\nexit 2\n", encoding="utf-8")
        path.chmod(0o755)
        for study in STUDIES:
            run = converge(self.folder / "study", study, "--reduced", program=path)
            self.assertEqual(run.returncode, 0, run)
            self.assertIn("not solved", run.stdout)

    def test_interrupted_study_goes_on(self):
        run = self.converge(failing=0.025, status=1)
        self.assertEqual((run.returncode, run.stderr.count("\n")), (1, 1), run)
        self.assertTrue(run.stderr.startswith("convergence: "), run)
        again = self.converge()
        self.assertEqual((again.returncode, again.stdout.count(RUN_MADE)), (0, 1), again)

    def test_run_with_other_options_is_repeated(self):
        self.converge()
        record = self.folder / "study/runs/march_65x33_dT0.05/options.json"
        wanted = json.loads(record.read_text(encoding="utf-8"))
        for content in (json.dumps({**wanted, "options": wanted["options"][:-2]}),
                        json.dumps({**wanted, "case": wanted["case"] + "\n"}), "{"):
            record.write_text(content, encoding="utf-8")
            self.assertEqual(self.converge().stdout.count(RUN_MADE), 1)
            self.assertEqual(json.loads(record.read_text(encoding="utf-8")), wanted)
        (record.parent / "summary.json").unlink()
        self.assertEqual(self.converge().stdout.count(RUN_MADE), 1)

    def test_numbers_of_other_studies_stay(self):
        self.converge()
        path = self.folder / "study/convergence.json"
        results = json.loads(path.read_text(encoding="utf-8"))
        path.write_text(json.dumps({"steady": {}, **results}), encoding="utf-8")
        self.converge()
        self.assertEqual(json.loads(path.read_text(encoding="utf-8")), {"steady": {}, **results})


class WrongUse(ProgramTest):
    def assert_refused(self, folder, *words, program=PROGRAM):
        run = converge(folder, "steady", "--reduced", program=program)
        self.assertEqual((run.returncode, run.stderr.count("\n")), (1, 1), run)
        self.assertTrue(run.stderr.startswith("convergence: "), run)
        for word in words:
            self.assertIn(word, run.stderr)

    def test_missing_program(self):
        self.assert_refused(self.folder / "new", "cannot run", "GEARFILM", program=self.folder / "absent")

    def test_folder_of_something_else(self):
        (self.folder / "letter.txt").write_text("no study", encoding="utf-8")
        self.assert_refused(self.folder, str(self.folder), "not empty")
        self.assertEqual(self.content(), ["letter.txt"])

    def test_numbers_of_something_else(self):
        (self.folder / "runs").mkdir()
        for content in ("{", "[]"):
            (self.folder / "convergence.json").write_text(content, encoding="utf-8")
            self.assert_refused(self.folder, "convergence.json")

    def test_folder_that_cannot_be_made(self):
        path = self.folder / "file"
        path.write_text("", encoding="utf-8")
        for folder in (path, path / "inside"):
            self.assert_refused(folder, "cannot write", str(folder))

    def test_unknown_study(self):
        for arguments in (("speed",), ("grid", "--reduced")):
            run = converge(self.folder / "new", *arguments)
            self.assertEqual((run.returncode, run.stdout), (2, ""), run)
            self.assertIn(f"no study '{arguments[0]}'; choose of steady", run.stderr)
            self.assertEqual(self.content(), [])


if __name__ == "__main__":
    unittest.main()
