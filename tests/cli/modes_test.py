"""The commands that make a pair vibrate, from outside: eigen, sweep, and spectra of marches."""
import os
import re
import shutil
import unittest

import numpy

from films import BARBIERI, SAME, summary_in
from restarts import SMALL
from vibration import COARSE, MARCH, SAME_ORBIT, VibrationTest, barbieri_with_inertias, table_in

SLOW_PAIR = """case:
  name: slow_pair
pinion:
  teeth: 31
  outer_radius: 41.25e-3
  crowning: 10e-6
  youngs_modulus: 206e9
  poisson_ratio: 0.30
  speed_rpm: 2000
  torque: 150
wheel:
  teeth: 47
  outer_radius: 61.25e-3
  crowning: 0
  youngs_modulus: 206e9
  poisson_ratio: 0.30
gear:
  module: 2.5e-3
  pressure_angle_deg: 20
  centre_distance: 97.5e-3
  face_width: 25e-3
  equivalent_mass: 1e-4
lubricant:
  viscosity: 0.02
  pressure_viscosity: 2e-8
"""


class Eigen(VibrationTest):
    def test_pair_swings_at_its_natural_frequencies_on_1_and_2_processes(self):
        alone, shared = (self.eigen(processes=processes) for processes in (1, 2))
        for summary in (alone, shared):
            # Table 3 of the paper, and the mode in which the gears turn against each other: what the tooth force gives
            # to one it takes from the other, I_1 phi_1/R_b1 = -I_2 phi_2/R_b2. In the rigid mode they turn as geared.
            self.assertAlmostEqual(summary["f_n"] / 5138.8, 1, delta=1e-3)
            self.assertLess(summary["rigid_frequency"], 1e-3 * summary["f_n"])
            self.run_well("info", BARBIERI)
            derived = summary_in(self.folder / "output/barbieri2013")
            pinion, wheel = (summary[f"inertia_{gear}"] / derived[f"base_radius_{gear}"]
                             for gear in ("pinion", "wheel"))
            swinging, rigid = summary["mode_shape"], summary["rigid_mode_shape"]
            self.assertAlmostEqual(pinion * swinging[0] / (wheel * swinging[1]), -1, delta=1e-9)
            self.assertAlmostEqual(rigid[1] / rigid[0] / (28 / 43), 1, delta=1e-9)
            self.assertEqual(summary["contacts"], 1)
        for name in ("film_frequency", "film_damping_ratio", "film_frequency_error", "film_damping_ratio_error"):
            self.assertGreater(alone[name], 0)
            self.assertAlmostEqual(shared[name] / alone[name], 1, delta=SAME, msg=name)
        # A grid of 257 x 129 nodes has 5133.2 +- 0.4 Hz and 0.00779 +- 2e-5.
        for name, finer in (("film_frequency", 5133.2), ("film_damping_ratio", 0.00779)):
            self.assertLess(abs(alone[name] - finer), alone[f"{name}_error"], name)
            self.assertLess(alone[f"{name}_error"], 0.3 * alone[name], name)
        # As many as eigen.modes asks for, however many SLEPc has found beyond them.
        for summary in (alone, shared):
            self.assertEqual(len(summary["film_eigenvalues"]), 4)

    # Oil crosses the contact while the pair swings some hundred times, on a thin film of a slender contact. A small mass
    # has it swing as fast as a slow pair with a usual one does, on fewer nodes.
    def test_pair_that_is_slow_against_its_swing_has_a_mode_on_1_and_2_processes(self):
        case = self.write_case(SLOW_PAIR)
        found = []
        for processes in (1, 2):
            run = self.run_program("eigen", case, "-grid_nx", 641, "-grid_ny", 33, "-output_dir", "slow",
                                   processes=processes)
            self.assertEqual(run.status, 0, run)  # odd masses are warned of
            found.append(summary_in(self.folder / "slow"))
        alone, shared = found
        self.assertAlmostEqual(alone["film_frequency"], 4.437e5, delta=0.002e5)
        self.assertAlmostEqual(alone["film_damping_ratio"], 0.0265, delta=0.001)
        for name in ("film_frequency", "film_damping_ratio"):
            self.assertAlmostEqual(shared[name] / alone[name], 1, delta=SAME, msg=name)
        with self.subTest("on stiff films"):
            self.assertGreater(alone["swings_in_passage"], 100)
            self.assertIsNone(alone["film_eigenvalues"])
            self.assertAlmostEqual(alone["film_damping_ratio_bound"],
                                   alone["film_damping_ratio"] + alone["film_damping_ratio_error"], delta=1e-12)
            self.assertRegex(run.stdout, r"(?m)^.*films are stiff springs.* limit, the dry mode, has 4\.1638e\+05 Hz, ")
            self.assertRegex(run.stdout, r"(?m)^film_eigenvalues are null: ")

    def test_inertias_in_the_place_of_the_mass(self):
        inertias = {"pinion": 1e-3, "wheel": 4e-3}
        summary = self.eigen(case=self.write_case(barbieri_with_inertias(**inertias)))
        self.run_well("info", BARBIERI)
        derived = summary_in(self.folder / "output/barbieri2013")
        mass = 1 / sum(derived[f"base_radius_{gear}"]**2 / inertia for gear, inertia in inertias.items())
        self.assertAlmostEqual(summary["m_ge"] / mass, 1, delta=1e-12)
        self.assertAlmostEqual(summary["f_n"] / (derived["f_n"] * (derived["m_ge"] / mass)**0.5), 1, delta=1e-9)
        for gear, inertia in inertias.items():
            self.assertEqual(summary[f"inertia_{gear}"], inertia)

    def test_films_ring_down_as_the_eigenvalue_says(self):
        summary = self.eigen()
        frequency, damping_ratio, rest = self.ring_down(summary["film_frequency"], "-start_H0", summary["H0"] + 2e-3,
                                                        "-output_spectrum_periods", 5)
        # The rest is the time step's: at half of it the differences are 3e-5 and 1e-4.
        self.assertAlmostEqual(frequency / summary["film_frequency"], 1, delta=1e-3)
        self.assertAlmostEqual(damping_ratio / summary["film_damping_ratio"], 1, delta=0.03)
        self.assertAlmostEqual(rest, summary["H0"], delta=1e-5)
        # Lines are 1400 Hz apart. The mean of H0 is not an oscillation.
        highest = summary_in(self.folder / "ringing")["spectrum_peaks"][0]
        self.assertAlmostEqual(highest["frequency"], frequency, delta=700.1)
        self.assertLess(highest["H0"], 2e-3)

    def test_dry_pair_rings_without_damping(self):
        frequency, damping_ratio, _ = self.ring_down(5139.07, "-model", "dry", "-start_H0", -1.648, "-time_dt", 0.2)
        self.assertAlmostEqual(frequency / 5139.07, 1, delta=1e-4)
        self.assertLess(abs(damping_ratio), 1e-4)


class Sweep(VibrationTest):
    OPTIONS = [*MARCH, "-periodic_multipliers", "no", "-output_dir", "sweep"]

    def setUp(self):
        super().setUp()
        self.output = self.folder / "sweep"

    def sweep(self, values, *options, processes=1):
        return self.run_well("sweep", BARBIERI, *self.OPTIONS, "-sweep_values", values, *options, processes=processes)

    def points(self):
        """Time of writing and content of each point's file."""
        return {path.name: (path.stat().st_mtime_ns, path.read_bytes()) for path in (self.output / "points").iterdir()}

    def test_two_speeds_in_both_directions(self):
        values = "16000, 15000"
        run = self.sweep(values)
        rows = table_in(self.output, "sweep")
        self.assertEqual(set(os.listdir(self.output)), {"points", "results.h5", "summary.json", "sweep.json"})
        numpy.testing.assert_array_equal(rows["speed_rpm"], [15000, 16000, 16000, 15000])
        numpy.testing.assert_array_equal(rows["up"], [1, 1, 0, 0])
        numpy.testing.assert_array_equal(rows["found"], 1)
        numpy.testing.assert_allclose(rows["f_m"], rows["speed_rpm"] / 60 * 28, rtol=1e-12)
        for name in ("H0_after_leaving", "force_ratio_max"):
            numpy.testing.assert_allclose(rows[name][2:], rows[name][1::-1], rtol=0, atol=SAME_ORBIT, err_msg=name)
        self.assertRegex(run.stdout, r"(?m)^up 15000 rpm: force ratio 1\.28")
        summary = summary_in(self.output)
        self.assertEqual((summary["points_found"], summary["points_failed"]), (4, 0))
        for row, point in zip(rows, summary["points"]):
            self.assertEqual(row["p_max"], point["p_max"])

        with self.subTest("deals its chains out to two processes"):
            shutil.move(self.output, self.folder / "alone")
            self.sweep(values, "-sweep_groups", 2, processes=2)
            shared = table_in(self.output, "sweep")
            # What is left of the change over a period is the difference of nearly equal numbers.
            for name in set(rows.dtype.names) - {"defect", "film_defect"}:
                numpy.testing.assert_allclose(shared[name], rows[name], rtol=SAME, err_msg=name)

        with self.subTest("goes on where it was interrupted"):
            shutil.rmtree(self.output, ignore_errors=True)
            shutil.move(self.folder / "alone", self.output)
            before = self.points()
            (self.output / "points/down_0000.json").unlink()
            (self.output / "summary.json").unlink()
            self.sweep(values)
            after = self.points()
            self.assertEqual([name for name in before if before[name] != after[name]], ["down_0000.json"])
            again = summary_in(self.output)
            self.assertEqual((again["points_found"], again["points_failed"]), (4, 0))
            self.assertEqual(again["points"][:3], summary["points"][:3])
            for name in ("H0_after_leaving", "force_ratio_max"):
                self.assertAlmostEqual(again["points"][3][name], summary["points"][3][name], delta=SAME_ORBIT)

        with self.subTest("keeps its folder from another sweep"):
            before = self.points()
            for processes in (1, 2):
                other = self.run_program("sweep", BARBIERI, *self.OPTIONS, "-sweep_values", "15000, 16500",
                                         processes=processes)
                self.assertEqual(other.status, 1, other)
                self.assertEqual(other.stdout, "", other)
                self.assertRegex(other.stderr, r"\Agearfilm: wrong input: .*sweep\.values.*-output_dir.*\n\Z")
                self.assertEqual(self.points(), before)
                self.assertEqual(summary_in(self.output), again)

    def test_two_chains_on_two_groups_of_two_processes(self):
        tables = []
        for processes in (1, 4):
            run = self.run_well("sweep", BARBIERI, *SMALL, "-sweep_values", "15000, 16000", "-sweep_direction", "up",
                                "-sweep_chain_points", 1, "-sweep_groups", 2, "-periodic_multipliers", "no",
                                "-output_dir", f"on_{processes}", processes=processes)
            # One line a point, from one process of its group.
            self.assertEqual(sorted(re.findall(r"(?m)^up (\d+) rpm: force ratio", run.stdout)), ["15000", "16000"])
            tables.append(table_in(self.folder / f"on_{processes}", "sweep"))
        alone, shared = tables
        numpy.testing.assert_array_equal(alone["found"], 1)
        # What is left of the change over a period is the difference of nearly equal numbers. It tells that a film was
        # cut: in two parts sums are rounded otherwise, while a group of one process has the numbers of one to the bit.
        self.assertTrue((shared["film_defect"] != alone["film_defect"]).all())
        for name in set(alone.dtype.names) - {"defect", "film_defect"}:
            numpy.testing.assert_allclose(shared[name], alone[name], rtol=SAME, err_msg=name)

    def test_a_point_that_fails_leaves_the_others(self):
        # At 9500 rpm, where contact is lost, the search takes longer.
        run = self.sweep("9500, 15000", "-sweep_direction", "up", "-periodic_max_periods", 3,
                         "-periodic_film_tolerance", 0.01)
        self.assertRegex(run.stdout, r"(?m)^up 9500 rpm: failed: no periodic state after 3 mesh periods")
        rows = table_in(self.output, "sweep")
        numpy.testing.assert_array_equal(rows["found"], [0, 1])
        numpy.testing.assert_array_equal(numpy.isnan(rows["force_ratio_max"]), [True, False])
        summary = summary_in(self.output)
        self.assertEqual((summary["points_found"], summary["points_failed"]), (1, 1))
        failed, found = summary["points"]
        self.assertIn("allow more periods", failed["error"])
        self.assertNotIn("force_ratio_max", failed)
        self.assertNotIn("error", found)
        self.assertEqual(found["start"], "dry orbit")

    def test_points_whose_load_comes_to_the_ends_have_films_over_the_whole_face(self):
        # The same radii on a narrow face: at 8000 rpm the dynamic force widens the contact beyond its edges.
        narrow = ["-gear_face_width", 8e-3, "-pinion_crowning", 0.02096e-3, "-wheel_crowning", 0.02096e-3]
        self.sweep("8000, 15000", "-sweep_direction", "up", *narrow, "-solver_processes", "all", processes=2)
        whole, within = summary_in(self.output)["points"]
        self.assertEqual(whole["final_grid"]["y_half"], 1.0)
        self.assertGreater(within["final_grid"]["y_half"], 1.0)
        self.run_well("periodic", BARBIERI, *MARCH, *narrow, "-periodic_multipliers", "no", "-pinion_speed_rpm", 8000,
                      "-output_dir", "alone")
        alone = summary_in(self.folder / "alone")  # with an inlet for its own speed
        self.assertAlmostEqual(whole["force_ratio_max"] / alone["force_ratio_max"], 1, delta=1e-3)
        self.assertAlmostEqual(whole["H0_after_leaving"], alone["H0_after_leaving"], delta=1e-2)

    def test_a_sweep_without_any_state_is_not_solved(self):
        run = self.run_program("sweep", BARBIERI, "-grid_nx", 33, "-grid_ny", 9, "-sweep_values", "15000, 16000",
                               "-output_dir", "sweep")
        self.assertEqual(run.status, 2, run)
        self.assertRegex(run.stderr, r"\Agearfilm: not solved: .*summary\.json\n\Z")
        summary = summary_in(self.output)
        self.assertEqual((summary["points_found"], summary["points_failed"]), (0, 4))
        numpy.testing.assert_array_equal(table_in(self.output, "sweep")["found"], 0)


class Order(VibrationTest):
    """At 24000 rpm the state that repeats every mesh period is unstable, and one of two periods is not."""

    def periodic(self, order, speed=24000):
        run = self.run_program("periodic", BARBIERI, *COARSE, "-pinion_speed_rpm", speed, "-periodic_order", order,
                               "-output_dir", "run")
        self.assertEqual(run.status, 0, run)
        return run.stdout, summary_in(self.folder / "run")

    def test_of_one(self):
        text, state = self.periodic(1)
        self.assertFalse(state["stable"])
        self.assertLess(min(real for real, _ in state["floquet"]), -1.2)
        self.assertIn("try -periodic_order 2", text)

    def test_of_two(self):
        text, state = self.periodic(2)
        self.assertTrue(state["stable"])
        self.assertEqual(len(state["states_after_leaving"]), 2)
        self.assertNotIn("already", text)
        one, two = sorted(state["states_after_leaving"])
        self.assertAlmostEqual(one[0], -2.31, delta=0.02)
        self.assertAlmostEqual(two[0], 0.276, delta=0.02)
        self.assertAlmostEqual(state["force_ratio_max"], 2.2, delta=0.02)

    def test_of_two_where_there_is_one(self):
        text, state = self.periodic(2, 15000)
        self.assertIn("repeats after 1 mesh period", text)
        one, two = state["states_after_leaving"]
        self.assertAlmostEqual(one[0], two[0], delta=2e-3)


class Starts(VibrationTest):
    def test_a_search_that_finds_nothing_begins_again_at_another_speed(self):
        # With three periods at most the dry orbit leads to a state at 2 % more speed, not at this one.
        run = self.run_well("periodic", BARBIERI, *MARCH, "-pinion_speed_rpm", 16400, "-periodic_max_periods", 3,
                            "-periodic_multipliers", "no", "-output_dir", "orbit")
        self.assertRegex(run.stdout, "no periodic state after 3 .* begins again from the state at 16728 rpm")
        orbit, steps = summary_in(self.folder / "orbit"), table_in(self.folder / "orbit", "history/steps")
        self.assertTrue(orbit["completed"])
        self.assertLess(orbit["defect"], 1e-4)
        self.assertLessEqual(orbit["periods_used"], 3)
        self.assertTrue((numpy.diff(steps["t"]) >= 0).all())  # of the last search alone
        self.assertAlmostEqual(steps["t"][-1] / orbit["mesh_period"], orbit["periods_used"], delta=1e-6)


class Spectrum(VibrationTest):
    def test_dry_march_has_the_mesh_frequency_among_its_peaks(self):
        self.run_well("transient", BARBIERI, "-model", "dry", "-mesh_periods", 8, "-output_spectrum_periods", 8,
                      "-time_dt", 0.1, "-output_dir", "dry")
        lines = table_in(self.folder / "dry", "spectrum")
        numpy.testing.assert_allclose(lines["frequency"], 875.0 * numpy.arange(len(lines)), rtol=1e-9)
        peaks = [peak["frequency"] for peak in summary_in(self.folder / "dry")["spectrum_peaks"]]
        self.assertLess(min(abs(frequency - 7000) for frequency in peaks), 437.5)


if __name__ == "__main__":
    unittest.main()
