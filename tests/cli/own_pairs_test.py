"""Pairs of gears beside formulas, and what the program says of those that its physics do not fit; as for cli_test.py."""
import math
import re
import unittest

from films import BARBIERI, WANG, summary_in
from program import INPUT, ProgramTest

# What is said of most pairs without relief, and of coarse grids.
BESIDE = "entering tooth meets its mate|the films have an error|the error of the films"


def section(gear, **values):
    return f"{gear}:\n" + "".join(f"  {key}: {value!r}\n" for key, value in values.items())


def pair(pinion, wheel, gear):
    """The text of a case; both gears are steel unless they say otherwise."""
    steel = {"youngs_modulus": 206e9, "poisson_ratio": 0.3, "crowning": 15e-6}
    return (section("pinion", **(steel | pinion)) + section("wheel", **(steel | wheel)) +
            section("gear", **({"pressure_angle_deg": 20} | gear)) +
            section("lubricant", viscosity=0.03, pressure_viscosity=2e-8))


def fzg_a(**gear):
    return pair({"teeth": 16, "outer_radius": 44.385e-3, "profile_shift": 0.8635, "speed_rpm": 2170, "torque": 302},
                {"teeth": 24, "outer_radius": 56.25e-3, "profile_shift": -0.5},
                {"module": 4.5e-3, "centre_distance": 91.5e-3, "face_width": 20e-3, "equivalent_mass": 0.3} | gear)


class OwnPairs(ProgramTest):
    def summary(self, command, case, *options, warnings=()):
        run = self.run_program(command, case, *options, "-output_dir", "out")
        self.assertEqual(run.status, 0, run)
        lines = [line for line in (run.of_case + run.stderr).splitlines() if not re.search(BESIDE, line)]
        self.assertEqual(len(lines), len(warnings), run)
        for line, words in zip(lines, warnings):
            for word in words:
                self.assertIn(word, line)
        return summary_in(self.folder / "out")

    def test_undercut_wheel_whose_active_flank_is_whole(self):
        case = self.write_case(fzg_a(tooth_compliance="weber"))
        undercut = ["undercuts the teeth of the wheel", "um above the base circle"]
        soft = self.summary("static", case, warnings=[undercut])
        self.assertLess(soft["mesh_stiffness_pitch"], self.summary("static", self.write_case(fzg_a()))["mesh_stiffness_pitch"])

    def test_swapped_gears_are_the_same_pair(self):
        """The wheel drives: the same contact, stiffness and transmission error."""
        one = {"teeth": 16, "outer_radius": 41.23e-3, "profile_shift": 0.1817, "inertia": 3.1e-4, "tip_relief": 30e-6,
               "tip_relief_length": 3e-3}
        two = {"teeth": 24, "outer_radius": 59.18e-3, "profile_shift": 0.1715, "inertia": 1.6e-3, "tip_relief": 40e-6,
               "tip_relief_length": 3e-3, "youngs_modulus": 120e9}
        gear = {"module": 4.5e-3, "centre_distance": 91.5e-3, "face_width": 14e-3, "tooth_compliance": "weber"}
        ways = [self.write_case(pair(one | {"speed_rpm": 1800.0, "torque": 100.0}, two, gear), "one.yaml"),
                self.write_case(pair(two | {"speed_rpm": 1200.0, "torque": 150.0}, one, gear), "two.yaml")]
        small = ["-grid_nx", 97, "-grid_ny", 33]
        for command, names in (("info", ["f_n", "k_el", "load", "p_hertz", "contact_ratio"]),
                               ("static", ["te_mean", "te_peak_to_peak", "mesh_stiffness_mean"]),
                               ("steady", ["h_central", "h_min", "p_max"])):
            first, second = (self.summary(command, case, *(small if command == "steady" else [])) for case in ways)
            for name in names:
                self.assertAlmostEqual(first[name] / second[name], 1, delta=1e-6, msg=name)

    def test_powers_of_a_line_equivalent_are_those_of_the_tooth(self):
        said = ["line_equivalent", "493.6 N", "2903 N"]
        found = self.summary("steady", WANG, "-steady_position", 2e-3, "-friction_law", "coulomb", "-friction_coefficient",
                             0.05, warnings=[said])
        info = self.summary("info", WANG, warnings=[said])
        self.assertAlmostEqual(info["tooth_force"], 95.49 / info["base_radius_pinion"], delta=0.01)
        self.assertNotIn("f_n", info)
        sliding = 1200 * math.pi / 30 * (1 + 35 / 140) * 2e-3
        self.assertAlmostEqual(found["power_sliding"] / (0.05 * info["tooth_force"] * sliding), 1, delta=1e-3)
        self.assertAlmostEqual(found["force"] / info["load"], 1, delta=1e-4)
        for command in ("static", "transient", "periodic", "eigen"):
            self.assert_wrong(["gear.load_model", "whole force", "set it to point"], command, WANG,
                              "-gear_equivalent_mass", 0.3, "-output_dir", "refused")

    def test_hot_inlets_are_said_with_an_assumed_oil(self):
        for command in ("info", "steady"):
            cold = [["Murch and Wilson", "assumed lubricant.temperature_viscosity of 0.035 1/K", "49.8 %"]]
            self.summary(command, BARBIERI, *(["-grid_nx", 65, "-grid_ny", 33] if command == "steady" else []),
                         warnings=cold)
        self.summary("info", BARBIERI, "-thermal_model", "none")
        given = self.summary("info", BARBIERI, "-lubricant_temperature_viscosity", 0.02,
                             warnings=[["Murch and Wilson"]])
        self.assertGreater(given["murch_wilson_thermal_factor"], 0.5)

    def test_pressures_and_temperatures_that_a_march_reaches(self):
        run = self.run_program("transient", BARBIERI, "-model", "dry", "-pinion_torque", 1200, "-mesh_periods", 12,
                               "-output_dir", "out")
        self.assertEqual(run.status, 0, run)
        highest = summary_in(self.folder / "out")["p_hertz_max"]
        self.assertGreater(highest, 4e9)
        self.assertIn(f"the largest Hertz pressure is {highest * 1e-9:.3g} GPa", run.of_case)
        hot = self.run_program("steady", BARBIERI, "-grid_nx", 65, "-grid_ny", 33, "-steady_position", 5e-3,
                               "-friction_law", "eyring", "-thermal_model", "friction", "-thermal_temperature", 430,
                               "-lubricant_temperature_viscosity", 0.03, "-output_dir", "out")
        self.assertRegex(hot.of_case, r"the film is as hot as \d+ K in places: above 473 K")


class Teeth(ProgramTest):
    """What is odd of teeth is said once, and the run goes on."""

    def test_odd_teeth(self):
        relief = ["-pinion_tip_relief", 0.4e-3, "-pinion_tip_relief_length", 3e-3]
        inertias = re.sub(r"  equivalent_mass.*\n", "", BARBIERI.read_text(encoding="utf-8")).replace(
            "  crowning: 0.131e-3\n", "  crowning: 0.131e-3\n  inertia: 1.5e-3\n", 1)
        heavy = inertias.replace("  teeth: 43\n", "  teeth: 43\n  inertia: 8\n")
        for case, options, words in (
                (BARBIERI, ["-gear_backlash", 0.7e-3], ["'gear.backlash' is 0.2333 modules", "is it in m?"]),
                (BARBIERI, relief, ["'pinion.tip_relief' is 0.1333 modules"]),
                (BARBIERI, ["-pinion_profile_shift", 0.8, "-wheel_profile_shift", 0.6],
                 ["profile shifts imply at gear.centre_distance is 0.2123 modules"]),
                (INPUT / "fzg_c.yaml", ["-pinion_outer_radius", 42.5e-3],
                 ["clearance between tips of the pinion and assumed roots of the wheel"]),
                (BARBIERI, ["-gear_mesh_compliance", 3e-8], ["deflection of the teeth under the static force"]),
                (self.write_case(heavy), [], ["'wheel.inertia' is 8 kg m^2", "steel disc"])):
            with self.subTest(words):
                run = self.run_program("info", case, *options, "-thermal_model", "none", "-output_dir", "odd")
                self.assertEqual(run.status, 0, run)
                self.assertEqual(run.stderr.count("\n"), 1, run)
                for word in words:
                    self.assertIn(word, run.stderr)


if __name__ == "__main__":
    unittest.main()
