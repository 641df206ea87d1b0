"""Figures of the paper from outside, and what they have to show, on the numbers; environment as for cli_test.py."""
import json
import os
import subprocess
import sys
import unittest

import h5py
import numpy

from program import PROGRAM, SECONDS, SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "scripts"))
from studies.paper import printed  # noqa: E402
from studies.paper.films import path_of_oil  # noqa: E402
from studies.paper.life import Life, find_delays, find_positions, read_fields, read_life, vertex  # noqa: E402

MM = 1e-3


def made_up_life():
    """B, C, D, E of the central film at -4.7, -4.2, -1.9, 2.6 mm, extremes of the pressures at 0 and 4 mm."""
    xi = numpy.linspace(-5.6, 5.7, 2261) * MM
    rows = numpy.zeros(xi.size, dtype=[(name, "f8") for name in ("xi", "h_central", "p_central", "p_max")])
    rows["xi"] = xi
    rows["h_central"] = numpy.interp(xi, numpy.array([-5.6, -4.7, -4.2, -1.9, 2.6, 5.7]) * MM,
                                     [2.20e-6, 2.19e-6, 2.41e-6, 2.12e-6, 2.9e-6, 2.5e-6])
    rows["p_central"] = 1.7e9 + 1e14 * xi ** 2
    rows["p_max"] = 3e9 - 1e14 * (xi - 4 * MM) ** 2
    return Life(rows, other_left=-3.1 * MM, other_entered=3.2 * MM)


class Positions(unittest.TestCase):
    def test_positions_and_delays_of_a_made_up_life(self):
        life = made_up_life()
        positions = find_positions(life)
        for name, xi in zip("ABCDEF", (-5.6, -4.7, -4.2, -1.9, 2.6, 5.7)):
            self.assertAlmostEqual(positions[name].xi, xi * MM, delta=3e-6, msg=name)
        delays = list(find_delays(life, positions).values())
        numpy.testing.assert_allclose(delays, numpy.array([1.2, 1.9, 1.4, 2.5]) * MM, atol=6e-6)

    def test_vertex_lies_between_the_steps(self):
        x = numpy.linspace(0, 1, 11)
        place, value = vertex(x, 2 - (x - 0.43) ** 2, 4)
        self.assertAlmostEqual(place, 0.43, delta=1e-12)
        self.assertAlmostEqual(value, 2, delta=1e-12)
        self.assertEqual(vertex(x, x, 10), (1.0, 1.0))


class PaperTest(ProgramTest):
    def figures(self, *options, program=PROGRAM):
        command = [sys.executable, "-B", str(SOURCE / "scripts/studies/paper/run"), str(self.folder), *map(str, options)]
        return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False,
                              env={**os.environ, "GEARFILM": program, "DISPLAY": ""})

    def assert_refused(self, run, *words):
        self.assertEqual(run.returncode, 1, run)
        self.assertEqual(run.stderr.count("\n"), 1, run)
        self.assertTrue(run.stderr.startswith("paper: "), run)
        for word in words:
            self.assertIn(word, run.stderr)


class Refusals(PaperTest):
    def test_missing_runs(self):
        self.assert_refused(self.figures("--only", 10), "periodic/results.h5 does not exist", "gearfilm periodic")
        self.assert_refused(self.figures("--only", 3), "results.h5", "does not exist")
        self.folder = self.folder / "nothing"
        self.assert_refused(self.figures(), "nothing does not exist", "--compute")

    def test_foreign_results(self):
        run = self.folder / "periodic"
        run.mkdir()
        (run / "results.h5").write_text("no HDF5", encoding="utf-8")
        self.assert_refused(self.figures("--only", 11), "not an HDF5 file")
        with h5py.File(run / "results.h5", "w") as results:
            results.attrs["command"] = numpy.bytes_("steady")
            results.attrs["format_version"] = 1
        self.assert_refused(self.figures("--only", 11), "not a result of gearfilm periodic")

    def test_missing_program(self):
        self.assert_refused(self.figures("--compute", "--only", 10, program="/no/such/gearfilm"), "cannot run",
                            "GEARFILM")

    def test_unknown_figure(self):
        run = self.figures("--only", 99)
        self.assertEqual(run.returncode, 2, run)
        self.assertIn("99", run.stderr)


class DynamicAgainstQuasiStatic(PaperTest):
    """What the paper says of its figures 12 to 14, on the case study at 129 x 65 nodes, dT = 0.026."""

    def test_figures_and_numbers(self):
        run = self.figures("--compute", "--only", 10, 11, 12, 13, 14)
        self.assertEqual((run.returncode, run.stderr), (0, ""), run)
        for name in ("fig10_force", "fig11_pressures", "fig12_films", "fig13_maps", "fig14_models"):
            for ending, beginning in (("png", b"\x89PNG"), ("pdf", b"%PDF")):
                self.assertTrue((self.folder / f"figures/{name}.{ending}").read_bytes().startswith(beginning), name)
        numbers = json.loads((self.folder / "figures/numbers.json").read_text(encoding="utf-8"))
        self.assert_delays(numbers["delays"])
        self.assert_contrast(numbers["contrast"])
        self.assert_positions({name: position["h_central"] for name, position in numbers["positions"].items()})
        self.assert_ripples_travel_with_the_oil()

    def assert_delays(self, delays):
        # The paper reads them off its history; the first two between flat extremes.
        for delay, paper, tolerance in zip(delays.values(),
                                           (printed.DELAY_D, printed.DELAY_LEAST_PRESSURE,
                                            printed.DELAY_GREATEST_PRESSURE, printed.DELAY_F),
                                           (0.15 * MM, 0.25 * MM, 0.12 * MM, 0.06 * MM)):
            self.assertAlmostEqual(delay, paper, delta=tolerance)

    def assert_contrast(self, contrast):
        self.assertGreater(contrast["spike_quasistatic"], 1.5)
        self.assertLess(contrast["spike_dynamic"], 1.12)
        self.assertLess(abs(contrast["least_pressure_at"]), 0.3 * MM)
        self.assertLess(contrast["film_ratio_access"], 0.95)
        self.assertGreater(contrast["film_ratio_recess"], 1.05)

    def assert_positions(self, films):
        self.assertLess(films["B"], films["A"])
        self.assertGreater(films["C"], 1.05 * films["B"])
        self.assertLess(films["D"], films["B"])
        self.assertGreater(films["E"], 1.3 * films["D"])
        self.assertLess(films["F"], 0.9 * films["E"])

    def assert_ripples_travel_with_the_oil(self):
        """The edge of the thicker film that the contact makes once it has entered moves with the oil."""
        fields = read_fields(self.folder / "periodic")
        pair = json.loads((self.folder / "info/summary.json").read_text(encoding="utf-8"))
        entered = read_life(self.folder / "periodic").rows["xi"][0]
        middle = abs(fields.y).argmin()
        seen, edge = [], []
        for xi, film in zip(fields.xi, fields.films[:, :, middle]):
            if not entered + 0.5 * MM < xi < entered + 1.6 * MM:
                continue
            inside = abs(fields.x) < 0.7 * pair["a"]
            steepest = numpy.gradient(film[inside]).argmin()
            seen.append(xi)
            edge.append(fields.x[inside][steepest])
        self.assertGreater(len(seen), 8)
        speed = numpy.polyfit(seen, edge, 1)[0]
        oil = numpy.polyfit(seen, path_of_oil(pair, entered, numpy.array(seen)), 1)[0]
        self.assertAlmostEqual(speed / oil, 1, delta=0.08)


if __name__ == "__main__":
    unittest.main()
