"""Natural modes of drive trains and their figures from outside, against the numbers of tests/reference/drivetrain.json,
and wrong trains. Environment as for cli_test.py.
"""
import unittest

from films import SAME
from script import plot
from trains import GRID, MASSES, REFERENCE, RELIEF, SHAFTS, TrainTest, bearings


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
                # The grid is wrong about the films alone.
                self.assertLess(mode["frequency_error"] / mode["frequency"],
                                2 * mode["mesh_share"] * alone["film_frequency_error"] / alone["film_frequency"])
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
        for name in ("frequency", "damping_ratio"):
            self.assertAlmostEqual(mode[f"{name}_error"] / summary[f"film_{name}_error"], 1, delta=1e-3)


class Figures(TrainTest):
    def plot(self, kind, *options):
        return plot(kind, self.folder / "info", *options)

    def test_campbell_diagram_and_shapes(self):
        self.summary("info", *SHAFTS, *bearings(1e9))
        for kind in ("campbell", "modes"):
            run = self.plot(kind, "--format", "png")
            self.assertEqual((run.returncode, run.stderr), (0, ""), run)
            self.assertTrue((self.folder / f"info/{kind}.png").read_bytes().startswith(b"\x89PNG"))

    def test_loads_of_a_train_over_time_and_by_orders(self):
        self.summary("periodic", "-model", "dry", "-dry_damping_ratio", 0.05, *SHAFTS, *bearings(1e9))
        run = plot("train", self.folder / "periodic", "--format", "png")
        self.assertEqual((run.returncode, run.stderr), (0, ""), run)
        self.assertTrue((self.folder / "periodic/train.png").read_bytes().startswith(b"\x89PNG"))

    def test_a_pair_alone_has_no_such_figures(self):
        self.summary("transient", "-model", "dry", "-mesh_periods", 1)
        run = plot("train", self.folder / "transient")
        self.assertEqual((run.returncode, run.stdout, run.stderr.count("\n")), (1, "", 1), run)
        self.assertIn("has no drive train; give one", run.stderr)
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

    def test_torques_that_do_not_balance(self):
        file = self.folder / "line.train"
        for text, words in (("torque motor 400", ["line.train:1", "makes 400 N m", "give 470 N m here"]),
                            ("torque load 722", ["which do not balance pinion.torque", "give -721.785714285714"]),
                            ("torque motor", ["needs the form: torque NODE mean"]),
                            ("torque motor 470 1 0.1", ["needs the form: torque NODE mean"]),
                            ("torque motor 470 0 0.1 0", ["'0 0.1 0' is no order > 0 or frequency"])):
            with self.subTest(text=text):
                file.write_text(text + "\n", encoding="utf-8")
                self.refused(words, *SHAFTS, "-train_file", file)
        file.write_text("torque motor 470\n", encoding="utf-8")
        self.refused(["motor.torque_harmonics", "beside 'torque' lines"], *SHAFTS, "-train_file", file,
                     "-motor_torque_harmonics", "1 0.1 0")
        file.write_text("torque motor 100\n", encoding="utf-8")  # what holds the motor takes the rest
        self.summary("info", *SHAFTS, "-motor_fixed", "yes", "-train_file", file)

    def test_what_run_ups_and_sweeps_ask_for(self):
        dry = ["-model", "dry", *SHAFTS]
        self.refused(["ramp.inertia_torque", "give ramp.to_rpm"], *dry, "-ramp_inertia_torque", "yes",
                     command="transient")
        self.refused(["ramp.inertia_torque", "does not turn freely"], *dry, "-motor_fixed", "yes", "-ramp_to_rpm", 15300,
                     "-ramp_inertia_torque", "yes", command="transient")
        for over in ("motor.torque_harmonics", "motr.inertia", "grid.nx"):
            self.refused([f"sweep.over' is {over}; give speed, torque", "key of the drive train"], *dry, "-sweep_over",
                         over, "-sweep_values", 1, command="sweep")

    def test_bodies_in_balance_have_constant_torques(self):
        balance = [*SHAFTS, "-motion", "quasi_static"]
        for command in ("transient", "periodic", "sweep"):
            self.refused(["motor.torque_harmonics' fluctuates, but with 'motion: quasi_static'", command], *balance,
                         "-motor_torque_harmonics", "28 0.1 0", command=command)
        self.refused(["ramp.inertia_torque", "bodies are in balance at every moment"], *balance, "-ramp_to_rpm", 15300,
                     "-ramp_inertia_torque", "yes", command="transient")
        self.refused(["is for pairs that swing"], *balance, command="continuation")

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
                ("fixed pinion\nfixed wheel", ["imposes the speeds of both gears", "free one"]),
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
