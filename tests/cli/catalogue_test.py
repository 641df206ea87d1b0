"""The catalogue of pairs, its oils and the laws of scripts/studies/film_laws: pairs, their independence, domains and grids.

Environment as for cli_test.py.
"""
import pathlib
import random
import sys
import tempfile
import unittest

import h5py

from program import SOURCE

sys.path.insert(0, str(SOURCE / "scripts"))
from studies.catalogue.measured import steady_cells  # noqa: E402
from studies.common import catalogue, oils  # noqa: E402
from studies.common.runs import attempt  # noqa: E402
from studies.film_laws import laws  # noqa: E402

PAIRS = 3


def pair_of(number):
    with tempfile.TemporaryDirectory() as folder:
        return catalogue.catalogue_pair(random.Random(f"3:{number}"), catalogue.derive_in(pathlib.Path(folder)))


class Pairs(unittest.TestCase):
    def test_pairs_are_within_the_catalogue_and_repeat(self):
        for number in range(PAIRS):
            with self.subTest(pair=number):
                pair, derived = pair_of(number)
                self.assertLessEqual(pair["pinion.teeth"], pair["wheel.teeth"])
                self.assertLessEqual(pair["wheel.teeth"], 6 * pair["pinion.teeth"])
                self.assertAlmostEqual(derived["working_pressure_angle_deg"], 20, places=4)
                self.assertTrue(0.6e9 < derived["p_hertz"] < 2e9)
                self.assertLessEqual(derived["b"], 0.45 * pair["gear.face_width"])
                self.assertLessEqual(catalogue.pitch_line_velocity(pair), 100)
                self.assertFalse([name for name in pair if name.startswith(("grid.", "time.", "solver."))])

    def test_case_files_name_seed_and_number_and_repeat(self):
        with tempfile.TemporaryDirectory() as folder:
            case, derived = catalogue.write_pair(pathlib.Path(folder) / "new", 3, 1)
            self.assertEqual(case.name, "3-1.yaml")
            self.assertEqual(derived["p_hertz"], pair_of(1)[1]["p_hertz"])


class Runs(unittest.TestCase):
    """Some of the forty pairs of docs/verification.md on defaults."""
    QUICK = (0, 7, 13, 23, 29, 32)
    SLOW_GEAR = 3          # 23 free oscillations in a mesh period, films of 0.05 um

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def test_film_of_a_finer_grid_is_within_the_error_of_the_chosen_one(self):
        for number in self.QUICK:
            with self.subTest(pair=number):
                case, _ = catalogue.write_pair(self.folder, catalogue.SEED, number)
                cells, word = steady_cells(case, self.folder / f"{number}", 300)
                self.assertEqual(word, "inside", cells)

    def test_periodic_states_are_found_with_their_errors(self):
        steps = iterations = 0
        for number in self.QUICK:
            with self.subTest(pair=number):
                case, _ = catalogue.write_pair(self.folder, catalogue.SEED, number)
                run = attempt("periodic", case, self.folder / f"{number}", "-periodic_multipliers", "no", time_limit=600)
                self.assertEqual(run.status, 0, run.message)
                found = run.summary
                steps += found["steps"]
                iterations += found["newton_iterations"]
                self.assertGreater(found["h_min_error"], 0)
                self.assertLess(found["force_ratio_max_error"], 0.05 * found["force_ratio_max"])
        self.assertLess(iterations, 5 * steps)

    # A tooth enters with a blow on a thin film: fronts cross many nodes a step.
    def test_march_of_a_slow_gear_takes_few_iterations_and_whole_steps(self):
        case, _ = catalogue.write_pair(self.folder, catalogue.SEED, self.SLOW_GEAR)
        run = attempt("transient", case, self.folder / "march", "-grid_nx", 169, "-grid_ny", 33, "-time_dt", 0.036,
                      "-mesh_periods", 0.2, time_limit=300)
        self.assertEqual(run.status, 0, run.message)
        with h5py.File(self.folder / "march/results.h5") as results:
            steps = results["history/steps"][:]
        steps = steps[steps["dT"] > 0]
        # The first of a segment are a half and an infinitesimal one, the scheme's own.
        short = [step["dT"] for step in steps if 1e-6 < step["dT"] < 0.036 / 16]
        self.assertEqual(short, [])
        self.assertLess(steps["newton"].mean(), 8)


class Oils(unittest.TestCase):
    def test_walther_passes_through_both_given_viscosities(self):
        for grade, at_100 in oils.VISCOSITY_AT_100.items():
            self.assertAlmostEqual(1e6 * oils.kinematic_viscosity(grade, 40) / grade, 1, places=12)
            self.assertAlmostEqual(1e6 * oils.kinematic_viscosity(grade, 100) / at_100, 1, places=12)

    def test_wooster_at_40_mpas(self):
        self.assertAlmostEqual(1e8 * oils.pressure_viscosity(0.04), 2.146, places=3)


class Laws(unittest.TestCase):
    CONTACTS = [laws.Groups(L, kappa, H)
                for L in (4, 12, 30) for kappa in (0.01, 0.1, 1) for H in (0.001, 0.03, 1)]

    def test_inlet_has_the_error_it_is_for(self):
        for contact in self.CONTACTS:
            x = laws.inlet(contact, 0.01)
            error = 0.328 * contact.L ** 0.285 * contact.H ** 1.15 / (x * x * (1 + 0.707 * contact.kappa * x))
            self.assertAlmostEqual(error, 0.01, places=12)

    def test_grids_can_be_halved_and_keep_the_aim(self):
        for contact in self.CONTACTS:
            edges, nx, ny = laws.grid(contact, 0.02)
            self.assertEqual(((nx - 1) % 4, (ny - 1) % 4), (0, 0))
            step = (edges.x_max - edges.x_min) / (nx - 1)
            self.assertAlmostEqual(edges.x_max / (4 * step), round(edges.x_max / (4 * step)), places=9)
            self.assertLessEqual(edges.x_min, -1 - laws.inlet(contact))
            self.assertLessEqual(laws.central_error(contact, step), 0.020001)
            self.assertLessEqual(laws.smallest_error(contact, step), 0.020001)
            self.assertLessEqual(2 * edges.y_half / (ny - 1), laws.step_y(contact))


if __name__ == "__main__":
    unittest.main()
