"""Drive trains and their figures from outside, against the numbers of tests/reference/drivetrain.json. Environment as for cli_test.py.

The pair: the case study with tip relief, of given inertias. Its grid on films is that of the reference.
"""
import json
import re
import shutil
import unittest

import numpy

from films import SAME, summary_in
from program import INPUT, SOURCE, ProgramTest
from script import plot
from vibration import table_in

REFERENCE = json.loads((SOURCE / "tests/reference/drivetrain.json").read_text(encoding="utf-8"))
CASE_STUDY = REFERENCE["table3"]["input"]
RELIEF = re.sub(r"^  equivalent_mass.*\n", "", (INPUT / "barbieri2013_relief.yaml").read_text(encoding="utf-8"),
                flags=re.MULTILINE)
for gear, inertia in zip(("pinion", "wheel"), CASE_STUDY["I"]):
    RELIEF = RELIEF.replace(f"{gear}:\n", f"{gear}:\n  inertia: {inertia!r}\n")
MASSES = ["-pinion_mass", CASE_STUDY["m"][0], "-wheel_mass", CASE_STUDY["m"][1]]
SHAFTS = ["-motor_inertia", 0.02, "-motor_shaft_stiffness", 2e4, "-load_inertia", 0.15, "-load_shaft_stiffness", 8e4]
GRID = ["-grid_nx", 97, "-grid_ny", 33]


def bearings(stiffness):
    return [*MASSES, "-pinion_bearing_stiffness", stiffness, "-wheel_bearing_stiffness", stiffness]


class TrainTest(ProgramTest):
    def summary(self, command, *options, processes=1):
        run = self.run_program(command, self.write_case(RELIEF), "-output_dir", command, *options, processes=processes)
        self.assertEqual(run.status, 0, run)
        self.warnings = run.stderr
        return summary_in(self.folder / command)

    def assert_frequencies(self, modes, expected, relative=1e-6):
        """expected: the rotation of the whole, which is no mode, first."""
        self.assertEqual(len(modes), len(expected) - 1)
        for mode, frequency in zip(modes, expected[1:]):
            self.assertAlmostEqual(mode["frequency_dry"] / frequency, 1, delta=relative)


class Dry(TrainTest):
    def test_a_pair_alone_has_no_train(self):
        for command in ("info", "eigen"):
            summary = self.summary(command, "-model", "dry")
            self.assertNotIn("modes", summary)
            self.assertAlmostEqual(summary["f_n"] / 3727.1867, 1, delta=1e-7)

    def test_modes_on_bearings_are_those_of_the_reference(self):
        for stiffness, expected in REFERENCE["table3"]["f"]["weber_bores"].items():
            if float(stiffness) > 1e10:
                continue  # as good as rigid
            summary = self.summary("info", *bearings(float(stiffness)))
            self.assert_frequencies(summary["modes"], expected["f6"])
            self.assertAlmostEqual(summary["f_n"] / 3727.1867, 1, delta=1e-7)  # of the pair, as it was
            for mode, share in zip(summary["modes"], expected["mesh_share"][1:]):
                self.assertAlmostEqual(mode["mesh_share"], share, delta=1e-6)
                self.assertEqual(max(abs(way) for node in mode["shape"].values() for way in node.values()), 1)
                self.assertAlmostEqual(mode["crossing_rpm"][1] * 2 * 28 / 60, mode["frequency_dry"], delta=1e-6)

    def test_the_centre_distance_under_load_is_warned_of(self):
        for stiffness, warned in ((1e8, True), (1e9, False)):
            expected = REFERENCE["static_support"][f"1e{8 if warned else 9}"]
            growth = self.summary("info", *bearings(stiffness))["centre_distance_growth"]
            self.assertAlmostEqual(1e6 * growth / expected["da_um"], 1, delta=1e-5)
            self.assertEqual("parts the centres" in self.warnings, warned)
            self.assertEqual("contact ratio of 1.29 to 1.26" in self.warnings, warned)

    def test_motor_and_load_by_keys_and_by_a_file_are_the_same(self):
        self.assert_frequencies(self.summary("info", *SHAFTS)["modes"], REFERENCE["train_torsion"]["f"])
        by_keys = self.summary("info", *SHAFTS, *MASSES, "-pinion_bearing_stiffness_x", 1e8,
                               "-pinion_bearing_stiffness_y", 3e8, "-wheel_bearing_stiffness_x", 2e8,
                               "-wheel_bearing_stiffness_y", 4e8)
        self.assert_frequencies(by_keys["modes"], REFERENCE["train8"]["f"])
        line = self.folder / "line.train"
        line.write_text("# motor and load\nnode motor pinion 0.02\nnode load wheel 0.15\n\nshaft motor pinion 2e4\n"
                        "shaft wheel load 8e4 0 0  # no inertia of its own\nbearing pinion 1e8 3e8\n"
                        "bearing wheel 2e8 4e8 0 0\n", encoding="utf-8")
        by_file = self.summary("info", *MASSES, "-train_file", line)
        for ours, theirs in zip(by_keys["modes"], by_file["modes"]):
            self.assertAlmostEqual(ours["frequency_dry"] / theirs["frequency_dry"], 1, delta=1e-12)

    def test_a_motor_of_imposed_speed_leaves_no_rotation_of_the_whole(self):
        free = self.summary("info", *SHAFTS)["modes"]
        held = self.summary("info", *SHAFTS, "-motor_fixed", "yes")["modes"]
        self.assertEqual([len(free), len(held)], [3, 3])  # one node less, and one mode more
        self.assertNotIn("rotation", held[0]["shape"]["motor"])
        self.assertGreater(free[0]["frequency_dry"], held[0]["frequency_dry"])

    def test_damping_by_dampers_by_ratio_and_beside_dry_contacts(self):
        modes = self.summary("info", *SHAFTS, "-train_damping_ratio", 0.02)["modes"]
        for mode in modes:
            self.assertAlmostEqual(mode["damping_ratio"], 0.02 * (1 - mode["mesh_share"]), delta=1e-12)
        ratio = ["-pinion_bearing_damping_ratio", 0.03, "-wheel_bearing_damping_ratio", 0.03]
        held = self.summary("eigen", *bearings(1e8), *ratio, "-model", "dry", "-dry_damping_ratio", 0.05)
        self.assertEqual(set(held["damping_references"]), {"bearing pinion", "bearing wheel"})
        for mode in held["modes"]:
            self.assertNotIn("frequency", mode)
            if mode["mesh_share"] < 1e-9:
                self.assertAlmostEqual(mode["damping_ratio"], 0.03, delta=1e-9)
            if mode["mesh_share"] > 0.9:
                # Beside dry contacts 0.05 of the pair's own, by share and frequency.
                films = 0.05 * mode["mesh_share"] * mode["frequency_dry"] / held["f_n"]
                self.assertTrue(films < mode["damping_ratio"] < films + 0.03 * (1 - mode["mesh_share"]) * 5)
        damper = self.summary("info", *SHAFTS, "-motor_shaft_damping", 1.0)["modes"][0]["damping_ratio"]
        self.assertTrue(1e-3 < damper < 0.1)


class OnFilms(TrainTest):
    def test_modes_on_films_are_those_of_the_reference_on_1_and_2_processes(self):
        for stiffness in ("1e9", "1e8"):
            expected = REFERENCE["films_real"][stiffness]
            alone = self.summary("eigen", *bearings(float(stiffness)), *GRID)
            felt = [mode for mode in alone["modes"] if mode["mesh_share"] > 1e-9]
            self.assertEqual(len(felt), 3)
            for mode, frequency, zeta in zip(felt, expected["f"], expected["zeta"]):
                self.assertAlmostEqual(mode["frequency"] / frequency, 1, delta=1e-4)
                self.assertAlmostEqual(mode["damping_ratio"] / zeta, 1, delta=0.02)
            for mode in alone["modes"]:
                if mode["mesh_share"] < 1e-9:
                    self.assertAlmostEqual(mode["frequency"] / mode["frequency_dry"], 1, delta=1e-9)
        shared = self.summary("eigen", *bearings(1e8), *GRID, processes=2)
        for ours, theirs in zip(alone["modes"], shared["modes"]):
            self.assertAlmostEqual(ours["frequency"] / theirs["frequency"], 1, delta=SAME)
            self.assertAlmostEqual(ours["damping_ratio"], theirs["damping_ratio"], delta=SAME)

    def test_two_gears_that_only_turn_are_the_pair_on_its_films(self):
        summary = self.summary("eigen", "-train_damping_ratio", 0, *GRID)
        self.assertEqual(len(summary["modes"]), 1)
        mode = summary["modes"][0]
        self.assertAlmostEqual(mode["frequency_dry"] / summary["f_n"], 1, delta=1e-9)
        self.assertAlmostEqual(mode["frequency"] / summary["film_frequency"], 1, delta=1e-8)
        self.assertAlmostEqual(mode["damping_ratio"] / summary["film_damping_ratio"], 1, delta=1e-5)


class DryMotion(TrainTest):
    def damped_bearings(self, stiffness):
        """With 0.04 sqrt(k m), 2 % of the critical damping of each gear on its own."""
        file = self.folder / f"bearings_{stiffness}.train"
        file.write_text("".join(f"bearing {gear} {stiffness} {stiffness} 0 0 {c!r} {c!r}\n" for gear, c in zip(
            ("pinion", "wheel"), (0.04 * (stiffness * mass) ** 0.5 for mass in CASE_STUDY["m"]))), encoding="utf-8")
        return [*MASSES, "-train_file", file]

    def periodic(self, *options, zeta=0.05):
        return self.summary("periodic", "-model", "dry", "-dry_damping_ratio", zeta, *options)

    def assert_moduli(self, summary, expected, relative):
        """Of pairs of multipliers, in any order."""
        found = sorted(abs(complex(*mu)) for mu in summary["floquet"])
        self.assertEqual(len(found), 2 * len(expected))
        for n, modulus in enumerate(sorted(expected)):
            for one in found[2 * n:2 * n + 2]:
                self.assertAlmostEqual(one / modulus, 1, delta=relative)

    def test_two_gears_that_only_turn_move_as_the_pair(self):
        expected, tolerance = REFERENCE["dry_orbit_1dof"], REFERENCE["dry_orbit_1dof"]["tol"]
        orbit = self.periodic("-train_damping_ratio", 0)
        self.assertAlmostEqual(orbit["H0_after_leaving"] / expected["H0"], 1, delta=tolerance["H0"])
        self.assertAlmostEqual(orbit["V0_after_leaving"], expected["V0"], delta=2 * tolerance["V0_abs"])
        self.assertAlmostEqual(orbit["total_force_ratio_max"], expected["total_force_ratio_max"],
                               delta=tolerance["force"])
        self.assert_moduli(orbit, [abs(complex(*expected["multiplier"]))], tolerance["mu"])

    def test_orbits_on_bearings_are_those_of_the_reference(self):
        tolerance = REFERENCE["dry_orbit_bearings"]["tol"]
        for stiffness in ("1e10", "1e9", "1e8"):
            with self.subTest(stiffness=stiffness):
                expected = REFERENCE["dry_orbit_bearings"][stiffness]
                orbit = self.periodic(*self.damped_bearings(float(stiffness)))
                self.assertAlmostEqual(orbit["H0_after_leaving"] / expected["H0"], 1, delta=tolerance["H0"])
                self.assertAlmostEqual(orbit["V0_after_leaving"], expected["V0"], delta=tolerance["V0_abs"])
                self.assertAlmostEqual(orbit["total_force_ratio_max"], expected["total_max"], delta=tolerance["force"])
                # Across the line of action gears on such bearings do not move: three pairs of multipliers.
                self.assert_moduli(orbit, expected["mu_abs"], tolerance["mu"])
                self.assertLess(orbit["floquet_modulus_error"], 1e-6)
                self.assertIsNone(orbit["free_frequency"])

    def test_resonances_over_the_speed_are_those_of_the_reference(self):
        tolerance = REFERENCE["speed_sweep"]["tol"]["total_max"]
        for stiffness, speeds in ((1e9, (6500, 13000)), (1e8, (7000, 7500))):
            sweep = self.summary("sweep", "-model", "dry", "-dry_damping_ratio", 0.02, "-sweep_direction", "up",
                                 "-sweep_values", ", ".join(map(str, speeds)), "-periodic_multipliers", "no",
                                 *self.damped_bearings(stiffness))
            expected = {row[0]: row[1] for row in
                        REFERENCE["speed_sweep"]["rpm__total_max__total_min"][str(stiffness)]}
            self.assertEqual(sweep["points_found"], 2)
            for point in sweep["points"]:
                self.assertAlmostEqual(point["total_force_ratio_max"] / expected[point["value"]], 1, delta=tolerance)
            shutil.rmtree(self.folder / "sweep")

    def test_a_march_settles_on_the_periodic_motion(self):
        bearings_at = self.damped_bearings(1e9)
        orbit = self.periodic(*bearings_at)
        march = self.summary("transient", "-model", "dry", "-dry_damping_ratio", 0.05, "-mesh_periods", 40,
                             "-start_place", "after_leaving", *bearings_at)
        self.assertAlmostEqual(march["settling"]["modulus"], orbit["floquet_modulus"], delta=2e-3)
        self.assertEqual(march["settles_on"], 1)

    def test_a_march_goes_on_to_the_bit(self):
        march = ["transient", self.write_case(RELIEF), "-model", "dry", "-keep_checkpoint", "yes", "-start_place",
                 "after_leaving", "-output_dir"]
        self.run_program(*march, "whole", "-mesh_periods", 6, *SHAFTS)
        self.run_program(*march, "parts", "-mesh_periods", 3, *SHAFTS)
        run = self.run_program(*march, "parts", "-mesh_periods", 6, "-restart", "yes", *SHAFTS)
        self.assertEqual(run.status, 0, run)
        whole, parts = (table_in(self.folder / name, "history/steps") for name in ("whole", "parts"))
        self.assertEqual(whole["H0"].tolist(), parts["H0"].tolist())

    def test_a_branch_is_followed_through_a_resonance(self):
        branch = self.summary("continuation", "-model", "dry", "-dry_damping_ratio", 0.05, "-continuation_from", 12480,
                              "-continuation_to", 12520, *self.damped_bearings(1e9))
        self.assertEqual(branch["bifurcations"], [])
        self.assertEqual(branch["branches"][0]["last_value"], 12520)


class Ripple(TrainTest):
    LINE = [*SHAFTS, "-motor_shaft_damping", 1.0, "-load_shaft_damping", 4.0]

    def periodic(self, harmonics):
        return self.summary("periodic", "-model", "dry", "-dry_damping_ratio", 0.02, *self.LINE,
                            "-motor_torque_harmonics", harmonics, "-periodic_max_pattern", 28, "-time_dt", 0.05)

    def first_order(self):
        """Amplitude of the tooth force at the order of the pinion, over the static force."""
        rows = table_in(self.folder / "periodic", "history/steps")
        time, force = rows["T"] / (rows["T"].max() - rows["T"].min()), rows["force_total"]
        turning = force * numpy.exp(-2j * numpy.pi * time)
        value = (numpy.diff(time) * (turning[1:] + turning[:-1])).sum()
        return abs(value) / summary_in(self.folder / "periodic")["static_force"]

    def test_a_tenth_of_torque_is_a_tooth_force_of_the_reference(self):
        expected = REFERENCE["torque_harmonic"]
        orbit = self.periodic("1 0.1 0")
        self.assertAlmostEqual(orbit["total_force_ratio_max"] / expected["total_max"], 1, delta=expected["tol"])
        self.assertAlmostEqual(orbit["total_force_ratio_min"] / expected["total_min"], 1, delta=expected["tol"])
        self.assertAlmostEqual(
            self.first_order() / expected["mesh_force_amplitude_order1_over_static"]["orbit"], 1, delta=expected["tol"])
        found = sorted(abs(complex(*mu)) for mu in orbit["floquet"])
        for modulus, one in zip(sorted(expected["multipliers_abs"]), found):
            self.assertAlmostEqual(modulus, one, delta=expected["tol"])

    def test_wrong_harmonics(self):
        for harmonics, words in (("1 0.1", ["motor.torque_harmonics", "has the part '1 0.1'"]),
                                 ("0 0.1 0", ["no order > 0"]),
                                 ("3.14159 0.1 0", ["never repeats together with the mesh"]),
                                 ("1 0.1 0", ["repeat together after 28 mesh periods", "raise that to 28"]),
                                 ("0.5 0.1 0", ["repeat together after 56 mesh periods"]),
                                 ("1 1e5 0", ["swings the whole train by", "of the base pitch"])):
            with self.subTest(harmonics=harmonics):
                self.assert_wrong(words, "periodic", self.write_case(RELIEF), "-model", "dry", *SHAFTS,
                                  "-motor_torque_harmonics", harmonics)
        self.assert_wrong(["the motor turns at an imposed speed"], "info", self.write_case(RELIEF), *SHAFTS,
                          "-motor_fixed", "yes", "-motor_torque_harmonics", "1 0.1 0")


class Figures(TrainTest):
    def plot(self, kind, *options):
        return plot(kind, self.folder / "info", *options)

    def test_campbell_diagram_and_shapes(self):
        self.summary("info", *SHAFTS, *bearings(1e9))
        for kind in ("campbell", "modes"):
            run = self.plot(kind, "--format", "png")
            self.assertEqual((run.returncode, run.stderr), (0, ""), run)
            self.assertTrue((self.folder / f"info/{kind}.png").read_bytes().startswith(b"\x89PNG"))

    def test_a_pair_alone_has_no_such_figures(self):
        self.summary("info")
        for kind in ("campbell", "modes"):
            run = self.plot(kind)
            self.assertEqual((run.returncode, run.stdout, run.stderr.count("\n")), (1, "", 1), run)
            self.assertIn("has no modes of a drive train; give one", run.stderr)


class WrongTrains(TrainTest):
    def refused(self, words, *options, command="info"):
        self.assert_wrong(words, command, self.write_case(RELIEF), *options)

    def test_keys_that_do_not_fit_together(self):
        for options, words in (
                (["-motor_shaft_stiffness", 2e4], ["motor.shaft_stiffness", "give 'motor.inertia'"]),
                (["-motor_inertia", 0.02], ["motor.inertia", "not 'motor.shaft_stiffness'"]),
                (["-motor_fixed", "yes"], ["motor.fixed", "not 'motor.shaft_stiffness'"]),
                (["-pinion_mass", 1], ["pinion.mass", "no bearings", "pinion.bearing_stiffness"]),
                (["-wheel_bearing_stiffness_x", 1e8], ["wheel.bearing_stiffness_y", "give both"]),
                (["-wheel_bearing_stiffness", 1e8, "-wheel_bearing_stiffness_y", 1e8], ["delete one"]),
                (["-wheel_bearing_damping_ratio", 0.1], ["given without a stiffness", "wheel.bearing_stiffness"]),
                (["-pinion_bearing_stiffness_x", 1e8, "-pinion_bearing_stiffness_y", 1e8, "-pinion_bearing_stiffness_xy",
                  -1e8], ["pinion.bearing_stiffness_xy", "in every direction"]),
                ([*bearings(1e8), "-gear_mesh_compliance", 1e-9], ["gear.mesh_compliance", "counted twice"]),
                ([*SHAFTS, "-gear_load_model", "line_equivalent"], ["gear.load_model", "set it to point"]),
                ([*SHAFTS, "-gear_equivalent_mass", 1], ["gear.equivalent_mass", "delete one"])):
            with self.subTest(options=options):
                self.refused(words, *options)

    def test_commands_that_move_the_pair_alone(self):
        self.refused(["motor.inertia", "bench moves the pair alone", "info or eigen"], *SHAFTS, command="bench")
        for command in ("transient", "periodic", "sweep", "continuation"):
            self.refused(["motor.inertia", f"with 'motion: quasi_static' {command} moves no drive train"], *SHAFTS,
                         "-motion", "quasi_static", command=command)

    def test_a_tooth_force_that_the_torque_does_not_determine(self):
        file = self.folder / "held.train"
        file.write_text("ground pinion 1e3\nground wheel 1e3\n", encoding="utf-8")
        self.summary("info", "-train_file", file)
        self.refused(["holds both the pinion's side and the wheel's", "free one side"], "-train_file", file, "-model",
                     "dry", command="periodic")

    def test_files_name_the_line_that_is_wrong(self):
        file = self.folder / "line.train"
        for text, words in (
                ("gear motor pinion 1", ["line.train:2", "'gear' is no element", "node, shaft"]),
                ("node motor rotor 1", ["'rotor' is no side", "pinion or wheel"]),
                ("node motor pinion", ["needs the form: node NAME"]),
                ("node motor pinion -1", ["the inertia is -1"]),
                ("node motor pinion 1x", ["'1x' is no number"]),
                ("node wheel wheel 1", ["'wheel' is there already"]),
                ("shaft motor pinion 1e4", ["no node 'motor' yet"]),
                ("shaft pinion wheel 1e4", ["turn with different gears"]),
                ("bearing pinion 1e8", ["needs the form: bearing NODE"]),
                ("bearing pinion 1e8 1e8 2e8 2e8", ["does not hold it in every direction"]),
                ("node motor pinion 1\nbearing motor 1e8 1e8", ["line.train:3", "'motor' has a bearing, but no mass"]),
                ("ground pinion 0", ["the stiffness is 0"]),
                ("node coupling wheel 1\nnode fan wheel 2\nshaft fan coupling 1e4", ["hang on nothing: coupling, fan"]),
                ("node disc wheel 1 3\nshaft disc wheel 1e4", ["hang on nothing: disc"])):
            with self.subTest(text=text):
                file.write_text(f"# a line of shafts\n{text}\n", encoding="utf-8")
                self.refused(words, "-train_file", file)

    def test_odd_trains_are_warned_of(self):
        self.summary("info", "-motor_inertia", 1, "-motor_shaft_stiffness", 1e-1)
        self.assertIn("so far apart that digits are lost", self.warnings)
        self.summary("info", *bearings(1e14))
        self.assertIn("make the support that is strained there rigid", self.warnings)


if __name__ == "__main__":
    unittest.main()
