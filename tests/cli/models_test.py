"""The models of one contact with a prescribed share of the load; environment as for cli_test.py."""
import unittest

import h5py
import numpy

from films import BARBIERI, REFERENCE, WANG, summary_in
from program import INPUT, ProgramTest
from restarts import SMALL
from vibration import COARSE, MARCH, VibrationTest, table_in

WIDE = ["-grid_y_half", 1.4]
PERIODS = 14                                # mesh periods of a march past a bad tooth
ENTRY, EXIT = -5.639e-3, 5.747e-3           # m, of Table 3
ALONE = (-3.109e-3, 3.217e-3)               # between these a contact is alone
# Of Table 2: outside the lengths that oil needs to pass after a jump of the load.
SETTLED = ((-3.0e-3, 0.5), (-2.2e-3, 0.5), (0.0, 1.0), (1.0e-3, 1.0), (1.5e-3, 1.0), (3.5e-3, 0.5))
# The paper's domain for M >= 200, and one whose inlet is long enough for this film; 129 x 65 nodes each.
SHORT = ["-grid_x_min", -2.083, "-grid_x_max", 1.25, "-grid_y_half", 1.1, "-grid_ny", 65]
LONG = ["-grid_ny", 65]


class OneContact(VibrationTest):
    def march(self, case, *options, name="march", processes=1):
        self.run_well("transient", case, *options, "-output_dir", name, processes=processes)
        self.assertTrue(summary_in(self.folder / name)["completed"])
        return table_in(self.folder / name, "history/contacts")

    def coarse(self, model, *options, **arguments):
        return self.march(BARBIERI, *MARCH, *WIDE, "-model", model, *options, **arguments)

    def assert_shares(self, rows, shares):
        """The force, as a share of the static force, at positions."""
        static_force = summary_in(self.folder / "march")["static_force"]
        for xi, share in shares:
            force = numpy.interp(xi, rows["xi"], rows["force"])
            self.assertAlmostEqual(force / static_force, share, delta=2e-3, msg=f"at {xi}")

    def test_quasistatic_contact_carries_its_share_from_entry_to_exit(self):
        for kind, shares in (("step", ((ENTRY, 0.5), (-4e-3, 0.5), (0, 1), (4e-3, 0.5), (EXIT, 0.5))),
                             ("trapezoid", ((ENTRY, 1 / 3), (-3.2e-3, 0.6549), (0, 1), (3.3e-3, 0.6557),
                                            (EXIT, 1 / 3)))):
            with self.subTest(kind=kind):
                rows = self.coarse("quasistatic", "-load_sharing_kind", kind)
                self.assertEqual(set(rows["contact"]), {0})
                numpy.testing.assert_allclose(rows["xi"][[0, -1]], (ENTRY, EXIT), atol=1e-6)
                self.assert_shares(rows, shares)

    def test_shares_from_a_table(self):
        (self.folder / "shares.txt").write_text("# m, share\n-6e-3 0.4\n-3e-3, 0.6\n-3e-3 0.9  # jump\n6e-3 0.9\n",
                                                encoding="utf-8")
        rows = self.coarse("quasistatic", "-load_sharing_kind", "table", "-load_sharing_file", "shares.txt")
        self.assert_shares(rows, ((-4.5e-3, 0.5), (-3.1e-3, 0.5933), (-2.5e-3, 0.9), (4e-3, 0.9)))

    def test_a_table_named_in_a_case_file_is_beside_it(self):
        (self.folder / "pair").mkdir()
        (self.folder / "pair/shares.txt").write_text("-6e-3 0.4\n6e-3 0.9\n", encoding="utf-8")
        case = BARBIERI.read_text(encoding="utf-8") + "\nload_sharing:\n  kind: table\n  file: shares.txt\n"
        (self.folder / "pair/case.yaml").write_text(case, encoding="utf-8")
        self.run_program("info", "pair/case.yaml", "-model", "quasistatic", "-output_dir", "info")
        self.assert_wrong(["does not exist", "shares.txt"], "info", "pair/case.yaml", "-model", "quasistatic",
                          "-load_sharing_file", "shares.txt")

    def test_simplified_dynamic_contact_swings_about_its_share(self):
        rows = self.coarse("simplified")
        alone = rows[(rows["xi"] > ALONE[0]) & (rows["xi"] < ALONE[1])]
        static_force = summary_in(self.folder / "march")["static_force"]
        # At rest under half the force it enters; alone it has to carry twice as much, and swings about that.
        self.assertGreater(alone["force"].max(), 1.05 * static_force)
        self.assertLess(alone["force"].max(), 2.0 * static_force)

    def test_two_processes_march_alike(self):
        # Without jumps of the load (the trapezoid has two), behind which solver tolerance decides of halved steps.
        (self.folder / "shares.txt").write_text("-6e-3 0.4\n-2e-3 1\n2e-3 1\n6e-3 0.4\n", encoding="utf-8")
        smooth = ["quasistatic", "-load_sharing_kind", "table", "-load_sharing_file", "shares.txt"]
        alone = self.coarse(*smooth)
        shared = self.coarse(*smooth, processes=2)
        self.assertEqual(len(shared), len(alone))
        for name in ("force", "h_central", "p_central"):
            numpy.testing.assert_allclose(shared[name], alone[name], rtol=1e-4, err_msg=name)

    def deviations(self, domain):
        """History of Table 2, and the largest deviations of its film and pressure from stationary ones."""
        rows = self.march(WANG, *domain, "-model", "quasistatic")
        worst = dict.fromkeys(("h_central", "p_central"), 0.0)
        for xi, share in SETTLED:
            self.run_well("steady", WANG, *domain, "-steady_position", xi, "-steady_load_ratio", share, "-output_dir",
                          "steady")
            film = summary_in(self.folder / "steady")
            for name in worst:
                here = numpy.interp(xi, rows["xi"], rows[name])
                worst[name] = max(worst[name], abs(here / film[name] - 1))
        return rows, worst

    def test_table_2_away_from_jumps_is_nearly_stationary_on_the_papers_domain(self):
        _, worst = self.deviations(SHORT)
        self.assertLess(worst["h_central"], 0.01)
        self.assertLess(worst["p_central"], 0.01)

    def test_table_2_on_a_long_inlet(self):
        rows, worst = self.deviations(LONG)
        # Oil takes its time from the inlet to the middle: the film is the stationary one of 0.25 mm before.
        self.assertLess(worst["h_central"], 0.0125)
        self.assertLess(worst["p_central"], 0.01)
        self.run_well("info", WANG, "-output_dir", "info")
        hertz = summary_in(self.folder / "info")["p_hertz"]
        self.assertAlmostEqual(numpy.interp(0, rows["xi"], rows["p_max"]) / hertz, 1, delta=0.02)
        film = REFERENCE["table2_pitch"][0]["h_central"]
        self.assertAlmostEqual(numpy.interp(0, rows["xi"], rows["h_central"]) / film, 1, delta=0.0125)


class RealTeeth(VibrationTest):
    """The case study on bending teeth with tip relief."""

    CASE = INPUT / "barbieri2013_relief.yaml"

    def test_pair_turned_slowly(self):
        self.run_well("static", self.CASE, "-output_dir", "static")
        summary, rows = summary_in(self.folder / "static"), table_in(self.folder / "static", "static")
        self.assertEqual([load["load_ratio"] for load in summary["loads"]], [0.25, 0.5, 0.75, 1, 1.25])
        nominal = rows[rows["load_ratio"] == 1]
        self.assertGreater(len(nominal), 400)
        self.assertAlmostEqual(1e6 * (nominal["te"].max() - nominal["te"].min()), 4.717, delta=0.05)
        self.assertAlmostEqual(numpy.ptp(nominal["te"]), summary["te_peak_to_peak"], delta=1e-12)
        forces = sum(nominal[f"force_{k}"] for k in range(3))
        self.assertLess(abs(forces / summary["static_force"] - 1).max(), 1e-9)
        self.assertLess(summary["entry_penetration"], 0)
        self.assertIsNone(summary["corner_contact_distance"])

    def test_rigid_tips_meet_before_their_time(self):
        run = self.run_program("static", self.CASE, "-pinion_tip_relief", 0, "-wheel_tip_relief", 0, "-output_dir", "hard")
        self.assertEqual(run.status, 0, run)
        self.assertIn("before the path of contact begins", run.stderr)
        self.assertAlmostEqual(1e3 * summary_in(self.folder / "hard")["corner_contact_distance"], 1.9, delta=0.05)

    def test_shares_serve_the_simplified_models(self):
        self.run_program("static", BARBIERI, "-gear_tooth_compliance", "weber", "-output_dir", "static")
        rows = self.march("quasistatic")
        summary = summary_in(self.folder / "march")
        entering = rows["force"][0] / summary["static_force"]
        self.assertAlmostEqual(entering, 0.4642, delta=0.005)  # teeth.json

    def march(self, model):
        self.run_well("transient", BARBIERI, *MARCH, *WIDE, "-model", model, "-load_sharing_kind", "table",
                      "-load_sharing_file", "static/shares.txt", "-output_dir", "march")
        return table_in(self.folder / "march", "history/contacts")

    def test_wrong_teeth(self):
        bend = ["-gear_tooth_compliance", "weber"]
        relief = ["-pinion_tip_relief", 4e-5]
        (self.folder / "few.txt").write_text("0 1e-9\n", encoding="utf-8")
        for words, options in (
                (["tip_relief_length"], relief),
                (["tip_relief_length", "start_radius"],
                 [*relief, "-pinion_tip_relief_length", 2e-3, "-pinion_tip_relief_start_radius", 0.045]),
                (["active flank"], [*relief, "-pinion_tip_relief_length", 0.05]),
                (["2 numbers", "28 teeth"], ["-pinion_pitch_errors", "1e-6,2e-6"]),
                (["abc", "error of a pitch"], ["-pinion_pitch_errors", "1e-6,abc"]),
                (["bore_radius", "below"], [*bend, "-pinion_bore_radius", 0.05]),
                (["root_radius", "active flank"], [*bend, "-pinion_root_radius", 0.043]),
                (["root_radius", "fillet"], [*bend, "-pinion_root_radius", 0.0411]),
                (["bore_radius", "ring"], ["-gear_tooth_compliance", "sainsot"]),
                (["compliance_file", "missing"], ["-gear_tooth_compliance", "table"]),
                (["few.txt", "two"], ["-gear_tooth_compliance", "table", "-gear_compliance_file", "few.txt"]),
                (["load_ratios", "x"], ["-static_load_ratios", "1 x"])):
            with self.subTest(options=options):
                self.assert_wrong(words, "static", BARBIERI, *options)
        errors = ["-pinion_pitch_errors", ",".join(28 * ["1e-6"])]
        hunting = [*errors, "-wheel_pitch_errors", ",".join(43 * ["1e-6"])]
        self.assert_wrong(["28 mesh periods", "max_pattern = 1"], "periodic", BARBIERI, *errors)
        self.assert_wrong(["1204 mesh periods", "max_pattern = 28"], "sweep", BARBIERI, *hunting, "-sweep_values", "9000",
                          "-periodic_max_pattern", 28)
        self.assert_wrong(["pitch_errors_file", "delete one"], "static", BARBIERI, *errors, "-pinion_pitch_errors_file",
                          "few.txt")
        self.assert_wrong(["2 numbers", "28 teeth"], "static", BARBIERI, "-pinion_pitch_errors_file", "few.txt")

    def test_films_enter_unloaded_under_relief(self):
        self.run_well("periodic", self.CASE, *COARSE, "-periodic_multipliers", "no", "-output_dir", "run")
        summary, rows = summary_in(self.folder / "run"), table_in(self.folder / "run", "history/contacts")
        self.assertAlmostEqual(summary["force_ratio_max"], 1.02, delta=0.01)
        self.assertFalse(summary["contact_lost"] or summary["back_contact"])
        whole = [number for number in numpy.unique(rows["contact"])
                 if numpy.ptp(rows["xi"][rows["contact"] == number]) > 0.99 * (EXIT - ENTRY)]
        contact = rows[rows["contact"] == whole[-1]]
        established = contact["p_max"][abs(contact["xi"]) < 1e-3].max()
        self.assertLess(contact["force"][0], 0.01 * summary["static_force"])
        self.assertLess(contact["p_max"][:6].max(), established)
        self.assertLess(contact["force"][-1], 0.01 * summary["static_force"])

    def test_a_bad_tooth_is_felt_while_it_meshes(self):
        # Slow enough that what it leaves behind dies away within a turn.
        march = ["transient", self.CASE, *COARSE, "-time_dt", 0.035, "-pinion_speed_rpm", 1500, "-lubricant_viscosity", 0.4,
                 "-start_place", "after_leaving", "-mesh_periods", PERIODS]
        errors = 28 * [0.0]
        errors[3] = 5e-6
        self.run_well(*march, "-output_dir", "good")
        self.run_well(*march, "-pinion_pitch_errors", ",".join(map(str, errors)), "-output_dir", "bad")
        good, bad = (table_in(self.folder / name, "history/steps") for name in ("good", "bad"))
        period = summary_in(self.folder / "good")["mesh_period"]
        times = numpy.linspace(0, PERIODS * period, 100 * PERIODS)
        change = [abs(numpy.interp(times, bad["t"], bad["h0"]) - numpy.interp(times, good["t"], good["h0"]))]
        of_period = numpy.reshape(change, (PERIODS, 100)).max(axis=1)
        self.assertLess(of_period[:2].max(), 1e-9)      # it has not entered
        self.assertGreater(of_period[2:5].max(), 3e-6)  # more than half of it
        self.assertLess(of_period[-1], 0.2 * of_period.max())

    def test_back_flanks_end_a_separation(self):
        far = [*MARCH, "-start_place", "after_leaving", "-start_H0", 0.5, "-start_V0", 3, "-mesh_periods", 1.5]
        for model in ("dry", "dynamic"):
            with self.subTest(model=model):
                highest = {}
                for backlash in ([], ["-gear_backlash", 3e-5]):
                    self.run_well("transient", BARBIERI, *far, "-model", model, *backlash, "-output_dir", "run")
                    summary, steps = summary_in(self.folder / "run"), table_in(self.folder / "run", "history/steps")
                    self.assertEqual(summary["back_contact"], bool(backlash))
                    self.assertEqual((steps["force_back"] > 0).any(), bool(backlash))
                    highest[bool(backlash)] = steps["h0"].max()
                self.assertGreater(highest[False], 1.5e-4)
                # Beyond the backlash they press into each other, as dry contacts do.
                touching = steps["h0"] > 3e-5
                self.assertTrue((steps["force_back"][touching] > 0).all() and (steps["force_back"][~touching] == 0).all())
                self.assertLess(highest[True], 0.6 * highest[False])

    def test_flanks_along_the_contact(self):
        steady = ["steady", self.CASE, "-grid_nx", 129, "-steady_position", -4e-3, "-steady_load_ratio", 0.5]
        films = {}
        for action in ("offset", "field"):
            self.run_well(*steady, "-gear_profile_local", action, "-output_dir", action)
            films[action] = summary_in(self.folder / action)
        # A parabola more: the contact is narrower, its pressure that of the radius it has, its film thinner.
        for film in films.values():
            self.assertAlmostEqual(film["p_max"] / film["p_hertz"], 1, delta=0.02)
        self.assertGreater(films["field"]["p_max"], 1.15 * films["offset"]["p_max"])
        self.assertLess(films["field"]["h_central"], 0.95 * films["offset"]["h_central"])


class WrongLoadSharing(ProgramTest):
    def test_options(self):
        for words, options in (
                (["model", "static"], ["-model", "static"]),
                (["load_sharing", "wave"], ["-model", "quasistatic", "-load_sharing_kind", "wave"]),
                (["at_end"], ["-model", "quasistatic", "-load_sharing_at_end", 0]),
                (["jump_time"], ["-model", "quasistatic", "-load_sharing_jump_time", 0]),
                (["jump_refinement"], ["-model", "quasistatic", "-load_sharing_jump_refinement", 0]),
                (["held", "moving"], ["-model", "quasistatic", "-geometry", "held"]),
                (["file", "missing"], ["-model", "quasistatic", "-load_sharing_kind", "table"])):
            with self.subTest(options=options):
                self.assert_wrong(words, "transient", BARBIERI, *options)
        self.assert_wrong(["trapezoidal", "one or two contacts"], "transient", INPUT / "high_contact_ratio.yaml",
                          "-model", "quasistatic", "-load_sharing_kind", "trapezoid")

    def test_tables(self):
        options = ["-model", "quasistatic", "-load_sharing_kind", "table", "-load_sharing_file", "shares.txt"]
        self.assert_wrong(["does not exist", "shares.txt"], "transient", BARBIERI, *options)
        for words, text in ((["shares.txt:2", "two numbers"], "-6e-3 1\nhalf\n"),
                            (["shares.txt:1", "two numbers"], "-6e-3 1 2\n6e-3 1\n"),
                            (["fewer than two"], "# nothing\n"),
                            (["does not cover"], "-6e-3 1\n5e-3 1\n"),
                            (["sort"], "6e-3 1\n-6e-3 1\n"),
                            (["not above zero"], "-6e-3 1\n6e-3 0\n"),
                            (["jumps", "jump_time"], "-6e-3 1\n0 1\n0 0.5\n1e-5 0.5\n1e-5 1\n6e-3 1\n")):
            with self.subTest(text=text):
                (self.folder / "shares.txt").write_text(text, encoding="utf-8")
                self.assert_wrong(words, "transient", BARBIERI, *options)

    def test_commands_that_need_all_contacts(self):
        for command in ("periodic", "eigen", "sweep", "bench"):
            with self.subTest(command=command):
                self.assert_wrong(["model", command], command, BARBIERI, "-model", "quasistatic")


class Courses(ProgramTest):
    """Marches whose speed changes, and what a march says of its recurrence."""

    def test_a_run_up_ends_at_its_speed(self):
        run = self.run_well("transient", BARBIERI, "-model", "dry", "-start_place", "after_leaving", "-pinion_speed_rpm",
                            12000, "-ramp_to_rpm", 18000, "-ramp_periods", 6, "-mesh_periods", 8, "-output_dir", "out")
        self.assertNotIn("repeat", run.stdout)
        with h5py.File(self.folder / "out/results.h5") as file:
            steps, points = file["history/steps"][:], file["history/poincare"][:]
        self.assertEqual(list(steps["pinion_speed"][[0, -1]]), [12000, 18000])
        numpy.testing.assert_allclose(numpy.diff(points["distance"]), points["distance"][0], rtol=1e-9)
        # Evenly in time, so by the mean of both speeds.
        duration = numpy.interp(6 * points["distance"][0], steps["distance"], steps["t"])
        first = summary_in(self.folder / "out")["mesh_period"]
        self.assertAlmostEqual(duration / (6 * first), 2 / (1 + 1.5), delta=1e-6)
        self.assertAlmostEqual(numpy.diff(points["t"])[-1] / first, 12 / 18, delta=1e-9)

    def test_a_march_says_how_it_settles(self):
        run = self.run_well("transient", BARBIERI, *SMALL, "-start_place", "after_leaving", "-mesh_periods", 12,
                            "-start_H0", -1.45, "-start_V0", 0.6, "-output_dir", "out")
        settling = summary_in(self.folder / "out")["settling"]
        self.assertLess(abs(settling["modulus"] - 0.955), settling["modulus_error"] + 0.02)
        self.assertIn("a disturbance is multiplied by", run.stdout)

    def test_a_search_begins_where_it_is_told(self):
        """Two states exist at 9500 rpm."""
        states = []
        for H0, V0 in ((-0.85, -0.36), (-0.88, 2.64)):
            self.run_program("periodic", BARBIERI, "-grid_nx", 65, "-grid_ny", 33, "-pinion_speed_rpm", 9500, "-start_H0",
                             H0, "-start_V0", V0, "-periodic_multipliers", "no", "-output_dir", "out")
            states.append(summary_in(self.folder / "out"))
        self.assertLess(abs(states[0]["force_ratio_max"] - 1.76), 0.03)
        self.assertLess(abs(states[1]["force_ratio_max"] - 2.47), 0.05)

    def test_wrong_ramps_are_named(self):
        self.assert_wrong(["'ramp.periods'", "'ramp.to_rpm'"], "transient", BARBIERI, "-ramp_periods", 5)
        self.assert_wrong(["'ramp.to_rpm'", "held"], "transient", BARBIERI, "-ramp_to_rpm", 9000, "-geometry", "held")


if __name__ == "__main__":
    unittest.main()
