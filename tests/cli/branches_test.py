"""`gearfilm continuation` from outside: the branches of the dry pair, their table, summary and messages."""
import unittest

import h5py
import numpy

from films import BARBIERI, summary_in
from restarts import stopped_after
from vibration import MARCH, SAME_ORBIT, VibrationTest, barbieri_with_inertias, table_in

DRY = ["-model", "dry"]
FLIPS = (26434, 21062)  # rpm, by shooting at one speed after the other
KINDS = {"regular": 0, "fold": 1, "flip": 2, "ns": 3, "grazing": 4}


class Branches(VibrationTest):
    def setUp(self):
        super().setUp()
        self.output = self.folder / "branches"

    def follow(self, begin, end, *options, processes=1):
        return self.run_well("continuation", BARBIERI, *DRY, "-continuation_from", begin, "-continuation_to", end,
                             "-output_dir", "branches", *options, processes=processes)

    def test_flips_and_the_branch_of_doubled_period(self):
        run = self.follow(28000, 20500)
        summary, rows = summary_in(self.output), table_in(self.output, "continuation")
        flips = [found["speed_rpm"] for found in summary["bifurcations"]
                 if found["kind"] == "flip" and found["branch"] == 1]
        self.assertEqual(len(flips), 2)
        for found, expected in zip(flips, FLIPS):
            self.assertAlmostEqual(found, expected, delta=10)
        with self.subTest("screen"):
            self.assertIn("branch 1 (order 1): flip at 26434", run.stdout)
            self.assertRegex(run.stdout, r"1 +1 +26434\.\d+ +21062\.\d+  unstable\n")
            self.assertRegex(run.stdout, r"2 +2 +26434\.\d+ +21343\.\d+  stable\n")
        with self.subTest("table"):
            self.assertEqual(len(rows), summary["points"])
            for kind, number in KINDS.items():
                known = [found for found in summary["bifurcations"] if found["kind"] == kind]
                self.assertEqual(numpy.count_nonzero(rows["kind"] == number),
                                 len(rows) - len(summary["bifurcations"]) if kind == "regular" else len(known))
            regular = rows[rows["kind"] == 0]
            moduli = [numpy.hypot(regular[f"floquet_{n}_re"], regular[f"floquet_{n}_im"]) for n in (1, 2)]
            numpy.testing.assert_array_equal(regular["stable"] == 1, numpy.maximum(*moduli) < 1)
            self.assertEqual(rows["speed_rpm"][0], 28000)
            for branch in summary["branches"]:
                points = rows[rows["branch"] == branch["number"]]
                self.assertEqual(len(points), branch["points"])
                self.assertEqual(branch["end"], "at an end of the range")
                self.assertEqual(points["speed_rpm"][-1], 20500)
            with h5py.File(self.output / "results.h5") as results:
                self.assertIn("2 flip", results["continuation"].attrs["kinds"])
                self.assertIn("speed_rpm rpm", results["continuation"].attrs["units"])
        with self.subTest("a march stays on the doubled period"):
            born = rows[(rows["branch"] == 2) & (rows["kind"] == 0) & (rows["stable"] == 1)]
            point = born[len(born) // 2]
            self.run_well("transient", BARBIERI, *DRY, "-dry_damping_ratio", 0.008, "-start_place", "after_leaving",
                          "-start_H0", point["H0_after_leaving"], "-start_V0", point["V0_after_leaving"],
                          "-pinion_speed_rpm", point["speed_rpm"], "-mesh_periods", 2,
                          "-output_dir", "march")
            steps = table_in(self.folder / "march", "history/steps")
            # The map is followed to 1e-9; a stable one does not enlarge what is left.
            self.assertAlmostEqual(steps["H0"][-1], point["H0_after_leaving"], delta=1e-7)
            middle = steps["H0"][numpy.abs(steps["T"] - steps["T"][-1] / 2).argmin()]
            self.assertGreater(abs(middle - point["H0_after_leaving"]), 0.1)
        with self.subTest("on two processes, without the flips' branches"):
            self.follow(28000, 20500, "-continuation_follow_flips", "no", processes=2)
            alone = table_in(self.output, "continuation")
            self.assertEqual(set(alone["branch"]), {1})
            for name in alone.dtype.names:
                numpy.testing.assert_array_equal(alone[name], rows[rows["branch"] == 1][name])

    def test_fold_of_the_hysteresis_and_a_given_start(self):
        self.follow(10000, 12000)
        summary = summary_in(self.output)
        folds = [found for found in summary["bifurcations"] if found["kind"] == "fold"]
        self.assertEqual(len(folds), 1)
        self.assertAlmostEqual(folds[0]["speed_rpm"], 10404.7, delta=10)
        self.assertAlmostEqual(folds[0]["floquet"][0][0], 1, delta=1e-4)
        self.assertEqual([stretch["stable"] for stretch in summary["stretches"]], [True, False])
        last = table_in(self.output, "continuation")[-1]
        self.assertEqual(last["speed_rpm"], 10000)
        with self.subTest("the unstable state at the start of the range, given directly"):
            self.follow(10000, 12000, "-start_H0", last["H0_after_leaving"], "-start_V0", last["V0_after_leaving"])
            again = table_in(self.output, "continuation")
            self.assertEqual(again["stable"][0], 0)
            self.assertAlmostEqual(again["H0_after_leaving"][0], last["H0_after_leaving"], delta=1e-6)

    def test_torque_and_mass(self):
        for parameter, column, begin, end in (("torque", "torque", 470, 200), ("mass", "m_ge", 0.37, 0.3)):
            with self.subTest(parameter=parameter):
                self.follow(begin, end, "-continuation_parameter", parameter)
                rows = table_in(self.output, "continuation")
                self.assertEqual((rows[column][0], rows[column][-1]), (begin, end))
                self.assertTrue((numpy.diff(rows[column]) < 0).all())

    def test_branches_that_end_early_say_so(self):
        run = self.run_program("continuation", BARBIERI, *DRY, "-continuation_from", 28000, "-continuation_to", 20500,
                               "-continuation_points", 5, "-output_dir", "branches")
        self.assertEqual(run.status, 0, run)
        self.assertRegex(run.stderr, r"\Agearfilm: warning: branch 1 \(order 1\) ends at .* continuation\.points .*\n\Z")
        self.assertEqual(len(table_in(self.output, "continuation")), 5)

    def test_a_run_that_was_stopped_is_done_again(self):
        stopped = stopped_after(1, ["continuation", BARBIERI, *DRY, "-continuation_from", 28000, "-continuation_to",
                                    20500, "-output_dir", "branches"], self.folder)
        self.assertEqual(stopped.status, 3, stopped)
        self.assertFalse(summary_in(self.output)["completed"])
        part = table_in(self.output, "continuation")
        self.assertGreater(len(part), 0)
        self.follow(28000, 20500, "-restart")
        whole = table_in(self.output, "continuation")
        self.assertGreater(len(whole), len(part))
        numpy.testing.assert_array_equal(whole[:len(part)], part)

    def test_branch_on_films_and_its_continuation(self):
        films = ["continuation", BARBIERI, *MARCH, "-continuation_from", 15000, "-continuation_to", 15600,
                 "-continuation_largest_step", 5, "-continuation_first_step", 5]
        self.run_well(*films, "-output_dir", "branches")
        rows, summary = table_in(self.output, "continuation"), summary_in(self.output)
        self.assertEqual(rows["speed_rpm"][-1], 15600)
        self.assertTrue((rows["stable"] == 1).all())
        with self.subTest("costs three or four mesh periods a point, and up to five for its multipliers"):
            self.assertLessEqual(summary["mesh_periods"], 9 * len(rows))
        with self.subTest("ends at the periodic state"):
            self.run_well("periodic", BARBIERI, *MARCH, "-pinion_speed_rpm", 15600, "-periodic_multipliers", "no",
                          "-output_dir", "periodic")
            orbit = summary_in(self.folder / "periodic")
            for name in ("H0_after_leaving", "V0_after_leaving", "force_ratio_max"):
                self.assertAlmostEqual(rows[name][-1], orbit[name], delta=SAME_ORBIT, msg=name)
        with self.subTest("goes on where it was stopped"):
            stopped = stopped_after(1, [*films, "-output_dir", "stopped"], self.folder)
            self.assertEqual(stopped.status, 3, stopped)
            self.run_well(*films, "-restart", "-output_dir", "stopped")
            again = table_in(self.folder / "stopped", "continuation")
            for name in rows.dtype.names:
                numpy.testing.assert_array_equal(again[name], rows[name], name)

    def test_viscosity(self):
        self.run_well("continuation", BARBIERI, *MARCH, "-grid_y_half", 1.4, "-continuation_parameter", "viscosity",
                      "-continuation_from", 0.04, "-continuation_to", 0.05, "-continuation_largest_step", 5,
                      "-continuation_first_step", 5, "-output_dir", "branches")
        rows = table_in(self.output, "continuation")
        self.assertEqual((rows["viscosity"][0], rows["viscosity"][-1]), (0.04, 0.05))
        self.assertTrue((rows["speed_rpm"] == 15000).all())
        self.assertGreater(numpy.ptp(rows["H0_after_leaving"]), 0.015)  # thicker oil, thicker films
        self.run_well("periodic", BARBIERI, *MARCH, "-grid_y_half", 1.4, "-lubricant_viscosity", 0.05,
                      "-periodic_multipliers", "no", "-output_dir", "periodic")
        self.assertAlmostEqual(summary_in(self.folder / "periodic")["H0_after_leaving"], rows["H0_after_leaving"][-1],
                               delta=SAME_ORBIT)
        self.assert_wrong(["model", "dry", "viscosity"], "continuation", BARBIERI, *DRY, "-continuation_parameter",
                          "viscosity", "-continuation_from", 0.04, "-continuation_to", 0.05)

    def test_mass_beside_inertias(self):
        case = self.write_case(barbieri_with_inertias(1e-3, 4e-3))
        self.assert_wrong(["equivalent_mass", "inertias"], "continuation", case, *DRY, "-continuation_parameter", "mass",
                          "-continuation_from", 0.3, "-continuation_to", 0.4)


if __name__ == "__main__":
    unittest.main()
