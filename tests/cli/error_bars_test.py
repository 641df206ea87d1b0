"""Error bars hold the figures of doubled grids, and what is said of them agrees; scripts/studies/error_bars.

Environment as for cli_test.py.
"""
import json
import re
import sys
import unittest

from program import INPUT, SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "scripts"))
from studies.common import catalogue  # noqa: E402
from studies.common.pairs import case_text, disc_inertia  # noqa: E402
from studies.error_bars import bars as error_bars  # noqa: E402

BARBIERI = INPUT / "barbieri2013.yaml"
# Of the catalogue, seed 1: moderate spikes, and in 5, 13 and 18 some that overtake the centre on finer grids.
QUICK = (0, 5, 7, 13, 18)
LEAST_SHARE = 0.95


def turbo_pair(speed, viscosity, pressure_viscosity, torque):
    """A fast pair under little load in a thin oil, whose spike is as high as the pressure in the centre."""
    module, width = 4e-3, 40e-3
    pair = {"gear.module": module, "gear.pressure_angle_deg": 20.0, "gear.centre_distance": 80 * module,
            "gear.face_width": width, "pinion.speed_rpm": speed, "pinion.torque": torque,
            "lubricant.viscosity": viscosity, "lubricant.pressure_viscosity": pressure_viscosity}
    for gear, teeth, crowning in (("pinion", 40, 15e-6), ("wheel", 120, 0.0)):
        radius = 0.5 * module * teeth
        pair |= {f"{gear}.teeth": teeth, f"{gear}.outer_radius": radius + module, f"{gear}.crowning": crowning,
                 f"{gear}.youngs_modulus": 206e9, f"{gear}.poisson_ratio": 0.3,
                 f"{gear}.inertia": disc_inertia(width, radius)}
    return case_text(pair)


# Its spike is below the centre's pressure on the default grid and above it on finer ones; the other's, on three times
# as many lines, is above it.
OVERTAKING = turbo_pair(15000, 0.008, 1.5e-8, 700)
OVERTAKEN = turbo_pair(20000, 0.010, 1.6e-8, 800) + "\nfilm: {discretisation: central}\n"


class Films(ProgramTest):
    def compared(self, text, name):
        tests, failure = error_bars.compare("steady", self.write_case(text, f"{name}.yaml"), self.folder / name, [], 600)
        self.assertEqual(failure, "")
        return tests

    def test_bars_of_a_catalogue_hold_the_figures_of_doubled_grids(self):
        tests = []
        for number in QUICK:
            case, _ = catalogue.write_pair(self.folder / "pairs", catalogue.SEED, number)
            (self.folder / f"{number}").mkdir()
            of_case, failure = error_bars.compare("steady", case, self.folder / f"{number}", [], 600)
            self.assertEqual(failure, "")
            self.assertLessEqual({"h_central", "h_min", "p_central", "p_max"}, {test.figure for test in of_case})
            tests += of_case
        self.assertEqual([test for test in tests if test.error is None], [])
        held = sum(test.holds for test in tests)
        self.assertGreaterEqual(held, LEAST_SHARE * len(tests), [test for test in tests if not test.holds])

    def test_bars_of_turbo_pairs_hold_the_spike_of_doubled_grids(self):
        for name, text in (("overtaking", OVERTAKING), ("overtaken", OVERTAKEN)):
            (self.folder / name).mkdir()
            tests = {test.figure: test for test in self.compared(text, name)}
            for figure, test in tests.items():
                with self.subTest(pair=name, figure=figure):
                    self.assertTrue(test.holds, test)
            summary = json.loads((self.folder / name / "summary.json").read_text(encoding="utf-8"))
            self.assertIsNone(summary["p_max_extrapolated"])
            self.assertGreater(summary["p_max_error"], 0.05 * summary["p_max"])
            self.assertLess(summary["p_central_error"], 0.03 * summary["p_central"])
            self.assertEqual(summary["p_spike"] == summary["p_max"], name == "overtaken")

    def test_largest_pressure_under_a_low_spike_keeps_its_small_bar(self):
        run = self.run_program("steady", BARBIERI, "-grid_nx", 257, "-grid_ny", 65, "-output_dir", "out")
        self.assertEqual(run.status, 0, run)
        summary = json.loads((self.folder / "out/summary.json").read_text(encoding="utf-8"))
        self.assertLess(1.25 * summary["p_spike"], summary["p_max"])
        self.assertLess(summary["p_max_error"], 0.01 * summary["p_max"])
        self.assertIsNotNone(summary["p_max_extrapolated"])

    def test_percentage_of_the_warning_is_that_of_the_bars(self):
        run = self.run_program("steady", BARBIERI, "-grid_nx", 65, "-grid_ny", 33, "-output_dir", "out")
        said = re.search(r"the films have an error of about (\S+) %", run.of_case)
        summary = json.loads((self.folder / "out/summary.json").read_text(encoding="utf-8"))
        worst = max(summary[f"{film}_error"] / summary[film] for film in ("h_central", "h_min"))
        self.assertAlmostEqual(float(said[1]), 100 * worst, delta=0.05 * 100 * worst)


class Multipliers(ProgramTest):
    def periodic(self, seed, number, *options):
        case, _ = catalogue.write_pair(self.folder, seed, number)
        self.run_well("periodic", case, "-output_dir", "out", *options)
        return json.loads((self.folder / "out/summary.json").read_text(encoding="utf-8"))

    def test_those_of_half_the_nodes_hold_those_of_the_own_grid(self):
        half, own = self.periodic(2, 33), self.periodic(2, 33, "-periodic_multipliers", "own_grid")
        self.assertEqual(half["pitch_h_central"], own["pitch_h_central"])
        self.assertGreater(half["floquet_modulus_error"], 2 * own["floquet_modulus_error"])
        for name in ("floquet_modulus", "damping_ratio"):
            self.assertNotEqual(half[name], own[name])
            self.assertLess(abs(half[name] - own[name]), half[f"{name}_error"] + own[f"{name}_error"])

    def test_a_state_that_half_the_nodes_would_call_unstable_is_stable(self):
        pair = self.periodic(1, 8)
        self.assertTrue(pair["stable"])
        self.assertLess(abs(pair["floquet_modulus"] - 0.9257), pair["floquet_modulus_error"])  # with accuracy 0.004


class Tables(unittest.TestCase):
    COARSE = {"h_min": 1.0, "h_min_error": 0.1, "p_max": 2.0, "p_max_error": None, "floquet_modulus": 0.5,
              "floquet_modulus_error": 0.1}

    def test_a_figure_within_one_and_a_tenth_errors_holds(self):
        for finer, holds in ((1.109, True), (0.891, True), (1.111, False)):
            tests = error_bars.tests_of("a", self.COARSE, {**self.COARSE, "h_min": finer})
            self.assertEqual([test.figure for test in tests], ["h_min", "p_max"])
            self.assertEqual(tests[0].holds, holds)

    def test_table_counts_what_holds_and_what_is_not_known(self):
        tests = [test for finer in (1.0, 1.2) for test in
                 error_bars.tests_of("a", self.COARSE, {**self.COARSE, "h_min": finer})]
        text = "\n".join(error_bars.summary_lines(tests))
        self.assertIn("| h_min | 2 | 50 % | 2.00 | a | 10 % | 0 |", text)
        self.assertIn("| p_max | 0 |  |  |  |  | 2 |", text)
        self.assertIn("all: 50.0 % of 2", text)


if __name__ == "__main__":
    unittest.main()
