"""The damped dry pair in `periodic`, `sweep` and `eigen`; sweeps of marches, and basins."""
import unittest

import numpy

from films import BARBIERI, summary_in
from restarts import stopped_after
from script import plot
from vibration import MARCH, SAME_ORBIT, VibrationTest, table_in

DRY = ["-model", "dry"]
HYSTERESIS = 9500                                # rpm: both states below exist
LOW, HIGH = (-0.919, -0.366), (-0.913, 2.654)    # (H0, V0) after leaving
RANGE = ["-sweep_H0_from", -1.5, "-sweep_H0_to", 1.5, "-sweep_V0_from", -2.0, "-sweep_V0_to", 3.0]


class DryOrbits(VibrationTest):
    def test_periodic_state_from_rest_and_from_a_start(self):
        for start, expected, force in ((LOW, LOW, 1.766), (HIGH, HIGH, 2.465)):
            given = ["-start_H0", start[0], "-start_V0", start[1]] if start is HIGH else []
            run = self.run_well("periodic", BARBIERI, *DRY, "-pinion_speed_rpm", HYSTERESIS, *given,
                                "-output_dir", "orbit")
            orbit = summary_in(self.folder / "orbit")
            numpy.testing.assert_allclose([orbit["H0_after_leaving"], orbit["V0_after_leaving"]], expected, atol=2e-3)
            self.assertAlmostEqual(orbit["force_ratio_max"], force, delta=2e-3)
            self.assertLess(orbit["floquet_modulus_error"], 1e-8)
            self.assertLess(orbit["defect"], 1e-6)
            self.assertRegex(run.stdout, r"(?m)^periodic state +stable, ")
            self.assertNotIn("film ", run.stdout.replace("barbieri", ""))
        with self.subTest("the multipliers are the damper's"):
            # A swing about a constant stiffness would lose exp(-2 pi zeta f_n/f_m) in a mesh period; so does this one,
            # by Liouville's theorem.
            self.run_well("eigen", BARBIERI, *DRY, "-pinion_speed_rpm", HYSTERESIS, "-dry_damping_ratio", 0.008,
                          "-eigen_orbit", "yes", "-output_dir", "modes")
            modes = summary_in(self.folder / "modes")
            expected = numpy.exp(-2 * numpy.pi * 0.008 * modes["f_n"] * orbit["mesh_period"])
            self.assertAlmostEqual(modes["orbit"]["floquet_modulus"], expected, delta=1e-8)
            self.assertAlmostEqual(modes["damped_frequency"], modes["f_n"] * numpy.sqrt(1 - 0.008 ** 2), places=6)
            self.assertNotIn("film_frequency", modes)

    def test_orbit_of_order_two_and_one_that_is_not(self):
        for order, stable in ((2, True), (1, False)):
            run = self.run_well("periodic", BARBIERI, *DRY, "-pinion_speed_rpm", 24000, "-periodic_order", order,
                                "-output_dir", "orbit")
            orbit = summary_in(self.folder / "orbit")
            self.assertEqual(len(orbit["states_after_leaving"]), order)
            self.assertEqual(orbit["stable"], stable)
            self.assertEqual("try -periodic_order 2" in run.stdout, not stable)

    def test_sweep_has_both_branches_of_the_hysteresis(self):
        sweep = ["sweep", BARBIERI, *DRY, "-sweep_from", 8500, "-sweep_to", 11500, "-sweep_points", 13]
        self.run_well(*sweep, "-output_dir", "sweep")
        rows = table_in(self.folder / "sweep", "sweep")
        self.assertTrue((rows["found"] == 1).all())
        at = rows[rows["speed_rpm"] == HYSTERESIS]
        numpy.testing.assert_allclose(at["force_ratio_max"][at["up"] == 1], 1.766, atol=2e-3)
        numpy.testing.assert_allclose(at["force_ratio_max"][at["up"] == 0], 2.465, atol=2e-3)
        self.assertNotIn("h_min", rows.dtype.names)


class Marches(VibrationTest):
    def draw(self, kind, folder, *options):
        done = plot(kind, self.folder / folder, *options)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done)
        self.assertTrue((self.folder / folder / f"{kind}.png").read_bytes().startswith(b"\x89PNG"))

    def test_dry_marches_jump_at_both_ends_of_the_hysteresis(self):
        self.run_well("sweep", BARBIERI, *DRY, "-sweep_kind", "marches", "-sweep_from", HYSTERESIS, "-sweep_to", 11000,
                      "-sweep_points", 7, "-sweep_kept_periods", 8, "-start_place", "after_leaving",
                      "-start_H0", LOW[0], "-start_V0", LOW[1], "-output_dir", "marches")
        points, dots = (table_in(self.folder / "marches", name) for name in ("sweep", "diagram"))
        self.assertEqual(len(dots), 8 * len(points))
        for up, expected in ((1, LOW), (0, HIGH)):
            settled = dots[(dots["up"] == up) & (dots["speed_rpm"] == HYSTERESIS)]
            numpy.testing.assert_allclose(settled["H0"], expected[0], atol=5e-3)
            numpy.testing.assert_allclose(settled["V0"], expected[1], atol=5e-3)
        numpy.testing.assert_array_equal(points["settles_on"][points["speed_rpm"] == HYSTERESIS], 1)
        self.draw("sweep", "marches")
        with self.subTest("dots behind a branch"):
            self.run_well("continuation", BARBIERI, *DRY, "-continuation_from", 11000, "-continuation_to", HYSTERESIS,
                          "-output_dir", "branch")
            self.draw("branch", "branch", "--marches", self.folder / "marches")

    def test_basins_of_the_hysteresis(self):
        run = self.run_well("sweep", BARBIERI, *DRY, "-sweep_kind", "basins", "-pinion_speed_rpm", HYSTERESIS, *RANGE,
                            "-sweep_starts", 5, "-output_dir", "basins", processes=2)
        rows = table_in(self.folder / "basins", "basins")
        self.assertEqual(len(rows), 25)
        attractors = summary_in(self.folder / "basins")["attractors"]
        self.assertAlmostEqual(sum(attractor["share"] for attractor in attractors), 1)
        for expected in (LOW, HIGH):
            found = [attractor for attractor in attractors if attractor["attractor"] and
                     numpy.allclose(attractor["states_after_leaving"], [expected], atol=0.02)]
            self.assertEqual(len(found), 1)
            count = numpy.count_nonzero(rows["attractor"] == found[0]["attractor"])
            self.assertAlmostEqual(count, 25 * found[0]["share"])
            self.assertIn(f"{100 * found[0]['share']:5.1f} % of the starts: repeats every 1", run.stdout)
        self.draw("sweep", "basins")

    def test_marches_on_films_go_on_where_they_were_stopped(self):
        sweep = ["sweep", BARBIERI, *MARCH, "-grid_y_half", 1.4, "-sweep_kind", "marches", "-sweep_from", 15000,
                 "-sweep_to", 16000, "-sweep_points", 3, "-sweep_direction", "up", "-sweep_march_periods", 3,
                 "-sweep_kept_periods", 2]
        self.run_well(*sweep, "-output_dir", "whole")
        stopped = stopped_after(1, [*sweep, "-output_dir", "run"], self.folder)
        self.assertEqual(stopped.status, 3, stopped)
        self.run_well(*sweep, "-output_dir", "run")
        for name in ("sweep", "diagram"):
            whole, run = (table_in(self.folder / folder, name) for folder in ("whole", "run"))
            for column in whole.dtype.names:
                numpy.testing.assert_array_equal(run[column], whole[column], f"{name}: {column}")

    def test_starts_that_are_missing_or_in_the_wrong_order(self):
        basins = ["sweep", BARBIERI, *DRY, "-sweep_kind", "basins"]
        self.assert_wrong(["sweep.H0_to", "missing"], *basins, *RANGE[:2])
        self.assert_wrong(["sweep.V0_from", "not below"], *basins, *RANGE[:5], 4, *RANGE[6:])


class OtherModels(VibrationTest):
    def test_one_contact_has_no_orbit(self):
        for command in ("periodic", "sweep", "eigen"):
            self.assert_wrong(["'model' is simplified", "dynamic or dry"], command, BARBIERI, "-model", "simplified",
                              "-sweep_values", "9000")


if __name__ == "__main__":
    unittest.main()
