"""Iterations of solvers in a few runs, against tests/reference/iterations.json: work, which unlike time does not depend on
the machine but for the last digits of its numbers. Fewer are welcome: then the file gets the new numbers."""
import json
import unittest

from films import summary_in
from program import SOURCE, ProgramTest


class Iterations(ProgramTest):
    def test_solvers_take_no_more_iterations_than_they_did(self):
        reference = json.loads((SOURCE / "tests/reference/iterations.json").read_text(encoding="utf-8"))
        for case in reference["cases"]:
            command, file, *options = case["arguments"]
            run = self.run_program(command, SOURCE / file, *options, "-output_dir", "run")
            self.assertEqual(run.status, 0, run)
            summary = summary_in(self.folder / "run")
            found = summary["periods"][0] if "periods" in summary else summary
            for name, count in case["counts"].items():
                with self.subTest(command=command, case=file, name=name):
                    self.assertLessEqual(abs(found[name] - count), max(1, reference["tolerance"] * count), found[name])


if __name__ == "__main__":
    unittest.main()
