"""Shafts that tilt under the static force, from outside: against the equilibrium of a rigid shaft on two springs, and
against the same number as gear.misalignment. Environment as for cli_test.py.
"""
import re
import unittest

from films import summary_in
from program import INPUT, ProgramTest
from vibration import table_in

# Uncrowned gears with end relief, aligned, on half-spaces: what free end faces give way takes most of the time.
ALIGNED = re.sub(r"^  misalignment.*\n", "  end_face: half_space\n",
                 (INPUT / "misaligned.yaml").read_text(encoding="utf-8"), flags=re.MULTILINE)
CROWNED = ALIGNED.replace("crowning: 0", "crowning: 20e-6")
FACE_WIDTH, TORQUE = 14e-3, 372
SPAN, OFFSET, FIRST, SECOND = 80e-3, 60e-3, 2e8, 3e8


def overhung(gear="pinion", offset=OFFSET, first=FIRST, second=SECOND):
    return [f"-{gear}_bearing_span", SPAN, f"-{gear}_bearing_offset", offset, f"-{gear}_bearing_stiffness", first,
            f"-{gear}_bearing_stiffness_2", second]


def in_the_middle(stiffness, span=0.1):
    """Of both gears, on two equal bearings of this stiffness together."""
    return [word for gear in ("pinion", "wheel")
            for word in (f"-{gear}_bearing_stiffness", stiffness / 2, f"-{gear}_bearing_span", span)]


class TiltTest(ProgramTest):
    def summary(self, command, *options, text=ALIGNED):
        run = self.run_program(command, self.write_case(text), "-output_dir", command, *options)
        self.assertEqual(run.status, 0, run)
        self.ran = run
        return summary_in(self.folder / command)


class UnderLoad(TiltTest):
    def test_the_slope_is_that_of_a_rigid_shaft_on_two_springs(self):
        info = self.summary("info", *overhung())
        # The bearings from the middle of the gear; forces of both by those of force and moment.
        first, second = -SPAN / 2 - OFFSET, SPAN / 2 - OFFSET
        force, moment = TORQUE / info["base_radius_pinion"], info["tilting_moment_dry"]
        load_second = (moment - first * force) / SPAN
        slope = (load_second / SECOND - (force - load_second) / FIRST) / SPAN
        self.assertAlmostEqual(info["tilt_pinion"] / slope, 1, delta=1e-9)
        self.assertEqual(info["tilt_wheel"], 0)
        self.assertAlmostEqual(info["misalignment_under_load"] / (slope * FACE_WIDTH), 1, delta=1e-9)
        # Away from the bearings the shaft gives way, flanks part there, and the contact turns it back.
        self.assertGreater(slope, 0)
        self.assertLess(moment, 0)
        self.assertIn("the static force tilts the shafts", self.ran.stdout)
        # The pinion's middle gives way as one bearing of this stiffness.
        stiffness = 1 / ((second / SPAN) ** 2 / FIRST + (first / SPAN) ** 2 / SECOND)
        single = self.summary("info", "-pinion_bearing_stiffness", stiffness, "-gear_misalignment",
                              info["misalignment_under_load"])
        for ours, theirs in zip(info["modes"], single["modes"]):
            self.assertAlmostEqual(ours["frequency_dry"] / theirs["frequency_dry"], 1, delta=1e-9)
        self.assertNotIn("misalignment_under_load", single)

    def test_tilts_of_both_shafts_and_what_flanks_have_add_up(self):
        by_pinion = self.summary("info", *overhung())
        swapped = self.summary("info", *overhung(offset=-OFFSET, first=SECOND, second=FIRST))
        for name in ("misalignment_under_load", "tilting_moment_dry"):
            self.assertAlmostEqual(swapped[name] / by_pinion[name], -1, delta=1e-6)
        both = self.summary("info", *overhung(), *overhung("wheel"))
        self.assertAlmostEqual(both["tilt_pinion"] / both["tilt_wheel"], 1, delta=1e-9)
        # The moment holds both back: twice the bearings do not give twice the slope.
        self.assertTrue(1.2 < both["misalignment_under_load"] / by_pinion["misalignment_under_load"] < 2)
        against = self.summary("info", *overhung(), *overhung("wheel", -OFFSET, SECOND, FIRST))
        self.assertAlmostEqual(against["tilt_pinion"] / by_pinion["tilt_pinion"], 1, delta=0.1)
        self.assertAlmostEqual(against["misalignment_under_load"], 0, delta=1e-12)
        # A slope that the flanks have themselves is turned back, too.
        turned = self.summary("info", *in_the_middle(2e8, 20e-3), "-gear_misalignment", 20e-6)
        self.assertTrue(-20e-6 < turned["misalignment_under_load"] < -1e-6)

    def test_a_gear_in_the_middle_of_equal_bearings_is_as_without_a_span(self):
        marches = []
        for options in (["-pinion_bearing_stiffness", 1e9, "-wheel_bearing_stiffness", 1e9], in_the_middle(1e9)):
            info = self.summary("info", *options, text=CROWNED)
            self.summary("transient", "-model", "dry", "-mesh_periods", 1, *options, text=CROWNED)
            marches.append((info, table_in(self.folder / "transient", "history/steps")))
        (single, without), (two, spans) = marches
        self.assertEqual([mode["frequency_dry"] for mode in single["modes"]], [mode["frequency_dry"] for mode in two["modes"]])
        self.assertEqual(without["H0"].tolist(), spans["H0"].tolist())
        self.assertEqual((two["misalignment_under_load"], two["tilt_wheel"], two["nx"]), (0, 0, single["nx"]))

    def test_films_are_those_of_the_same_misalignment(self):
        grid = ["-grid_nx", 33, "-lubricant_viscosity", 0.1]
        tilted = self.summary("steady", *overhung(first=2 * FIRST, second=2 * SECOND), *grid)
        given = self.summary("steady", "-gear_misalignment", tilted["misalignment_under_load"], *grid)
        for name in ("h_central", "h_min", "h_min_y", "p_max", "p_max_y", "tilting_moment", "approach"):
            self.assertAlmostEqual(tilted[name] / given[name], 1, delta=1e-9, msg=name)
        # More at the end at which the shaft does not give way; nearly as the dry contact that turned the shaft back.
        self.assertLess(tilted["p_max_y"], 0)
        self.assertAlmostEqual(tilted["tilting_moment"] / tilted["tilting_moment_dry"], 1, delta=0.05)

    def test_an_end_that_carries_nothing_is_warned_of(self):
        for stiffness, warned in ((2e8, False), (1e7, True)):
            self.summary("info", *overhung(second=stiffness))
            self.assertEqual("one end carries nothing" in self.ran.stderr, warned, self.ran)


class Wrong(TiltTest):
    def test_bearings_that_do_not_fit_together(self):
        file = self.folder / "line.train"
        file.write_text("bearing pinion 1e8 1e8\n", encoding="utf-8")
        directions = ["-pinion_bearing_stiffness_x", 1e8, "-pinion_bearing_stiffness_y", 1e8]
        for options, words in (
                (["-pinion_bearing_span", SPAN], ["pinion.bearing_span", "without a stiffness"]),
                (["-wheel_bearing_stiffness", 1e8, "-wheel_bearing_offset", 0.01], ["not 'wheel.bearing_span'"]),
                (["-wheel_bearing_stiffness", 1e8, "-wheel_bearing_stiffness_2", 1e8], ["not 'wheel.bearing_span'"]),
                ([*directions, "-pinion_bearing_span", SPAN, "-pinion_bearing_stiffness_2", 1e8],
                 ["pinion.bearing_stiffness_2", "both bearings are alike"]),
                ([*overhung(), "-train_file", file], ["line.train:1", "on two bearings already"]),
                (overhung(first=1e5), ["tilts the shafts until the flanks part by",
                                                                 "lifts them off"])):
            with self.subTest(options=options):
                self.assert_wrong(words, "info", self.write_case(ALIGNED), *options)


if __name__ == "__main__":
    unittest.main()
