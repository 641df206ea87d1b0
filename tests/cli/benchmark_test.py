"""Comparison of two measurements of `gearfilm bench`, made up here."""
import json
import subprocess
import sys
import unittest

from program import SECONDS, SOURCE, ProgramTest


class Comparison(ProgramTest):
    def write(self, name, unit, **more):
        rows = [{"kernel": kernel, "seconds": 1e-3, "ns_per_node": 5.0, "convolutions": unit * n}
                for n, kernel in enumerate(("deformation", "V-cycle"), start=1)]
        folder = self.folder / name
        folder.mkdir()
        (folder / "summary.json").write_text(json.dumps({"grids": [{"nx": 129, "ny": 65, "rows": rows}], **more}),
                                             encoding="utf-8")

    def compare(self, before, after):
        command = [sys.executable, "-B", str(SOURCE / "scripts/studies/speed/compare.py"), str(self.folder / before),
                   str(self.folder / after)]
        return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)

    def assert_refused(self, before, after, *words):
        run = self.compare(before, after)
        self.assertEqual((run.returncode, run.stdout, run.stderr.count("\n")), (1, "", 1), run)
        for word in words:
            self.assertIn(word, run.stderr)

    def test_ratios_of_what_both_have(self):
        self.write("before", 1.0, contact_step_convolutions=50.0)
        self.write("after", 0.5, contact_step_convolutions=20.0)
        run = self.compare("before", "after")
        self.assertEqual((run.returncode, run.stderr), (0, ""), run)
        cells = [[cell.strip() for cell in line.split("|")] for line in run.stdout.splitlines()[1:]]
        self.assertEqual(cells, [["129 x 65", "deformation", "1", "0.5", "0.50"],
                                 ["129 x 65", "V-cycle", "2", "1", "0.50"],
                                 ["mesh period", "contact-step", "50", "20", "0.40"]])

    def test_missing_and_foreign_summaries(self):
        self.write("before", 1.0)
        self.assert_refused("before", "absent", "absent", "cannot be read")
        (self.folder / "before/summary.json").write_text('{"case": "x"}', encoding="utf-8")
        self.write("after", 1.0)
        self.assert_refused("before", "after", "before", "not a summary of gearfilm bench")


if __name__ == "__main__":
    unittest.main()
