"""The dry pair on bending teeth: searches, sweeps that find all their points, and continuations that can be stopped."""
import re
import unittest

import numpy

from films import summary_in
from program import INPUT, SOURCE
from vibration import VibrationTest, table_in

DRY = ["-model", "dry"]
RELIEF = [word for gear in ("pinion", "wheel")
          for word in (f"-{gear}_tip_relief", 20e-6, f"-{gear}_tip_relief_length", 3e-3,
                       f"-{gear}_tip_relief_shape", "parabolic")]
BENDING = [*DRY, "-gear_tooth_compliance", "weber", *RELIEF]


class DrySearches(VibrationTest):
    def setUp(self):
        super().setUp()
        text = (SOURCE / "docs/tutorial.md").read_text(encoding="utf-8")
        self.pair = self.folder / "my_pair.yaml"
        self.pair.write_text(re.search(r"```yaml\n(.*?)```", text, re.DOTALL).group(1), encoding="utf-8")

    def run_ended(self, *arguments, status=0, processes=1):
        """A run with warnings: of teeth that meet with a penetration."""
        run = self.run_program(*arguments, processes=processes)
        self.assertEqual(run.status, status, run)
        return run

    def test_state_is_that_of_a_long_march(self):
        self.run_ended("periodic", self.pair, *BENDING, "-pinion_speed_rpm", 19000, "-output_dir", "orbit")
        orbit = summary_in(self.folder / "orbit")
        self.assertTrue(orbit["stable"])
        self.run_ended("sweep", self.pair, *BENDING, "-sweep_kind", "marches", "-sweep_values", 19000,
                         "-sweep_direction", "up", "-sweep_march_periods", 600, "-output_dir", "march")
        march = summary_in(self.folder / "march")["points"][0]
        self.assertEqual(march["repeats_every"], 1)
        # A disturbance keeps 0.964 of itself over a mesh period: nothing of the start is left after 600, and thirty times
        # the 1e-8 that the march misses in each.
        for name in ("H0_after_leaving", "V0_after_leaving"):
            self.assertAlmostEqual(march[name], orbit[name], delta=1e-6)

    def test_sweep_finds_all_points_and_stays_on_its_branch(self):
        sweep = ["sweep", self.pair, *BENDING, "-sweep_from", 12000, "-sweep_to", 24000, "-sweep_points", 13]
        self.run_ended(*sweep, "-output_dir", "sweep")
        rows = table_in(self.folder / "sweep", "sweep")
        self.assertTrue((rows["found"] == 1).all())
        # The branch of the way down goes on where the way up has jumped to it.
        down = rows[rows["up"] == 0]
        self.assertTrue((numpy.diff(down["force_ratio_max"]) > 0).all())
        with self.subTest("on two processes"):
            self.run_ended(*sweep, "-output_dir", "two", processes=2)
            two = table_in(self.folder / "two", "sweep")
            numpy.testing.assert_allclose(two["force_ratio_max"], rows["force_ratio_max"], rtol=1e-9)

    def test_continuation_stops_at_its_time_limit_and_keeps_its_points(self):
        run = self.run_ended("continuation", INPUT / "fzg_c.yaml", *DRY, "-continuation_from", 3000,
                               "-continuation_to", 6000, "-time_limit", 6, "-output_dir", "branch", status=3)
        self.assertIn("after the time limit of 6 s", run.stderr)
        self.assertIn("from the beginning", run.stderr)
        summary = summary_in(self.folder / "branch")
        self.assertFalse(summary["completed"])
        self.assertEqual(len(table_in(self.folder / "branch", "continuation")), summary["points"])


if __name__ == "__main__":
    unittest.main()
