"""Domain, grid and step as the program chooses them, the error it says its films have, and grids that are widened.

Environment as for cli_test.py.
"""
import json
import re
import sys
import unittest

from program import INPUT, SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "scripts"))
from studies.common.catalogue import write_pair  # noqa: E402

BARBIERI = INPUT / "barbieri2013.yaml"
HIGH_CONTACT_RATIO = INPUT / "high_contact_ratio.yaml"
# A nearly line contact with a thin film, as typical gears have: M = 2e5, L = 5, D = 0.001.
SLENDER = """case:
  name: slender
  kind: contact
contact:
  radius_x: 8e-3
  radius_y: 8
  reduced_modulus: 226e9
  load: 3915.73
  entrainment_velocity: 0.0676816
lubricant:
  viscosity: 0.02
  pressure_viscosity: 2e-8
"""
THICK = SLENDER.replace("radius_y: 8\n", "radius_y: 20e-3\n").replace("load: 3915.73", "load: 20").replace(
    "velocity: 0.0676816", "velocity: 0.5").replace("slender", "thick")


class Defaults(ProgramTest):
    def summary(self, *arguments):
        run = self.run_program(*arguments, "-output_dir", "out")
        self.assertEqual((run.status, run.stderr), (0, ""), run)
        return run, json.loads((self.folder / "out/summary.json").read_text(encoding="utf-8"))

    def test_error_of_a_chosen_grid_holds_the_film_of_a_finer_one(self):
        for text in (SLENDER, THICK):
            case = self.write_case(text)
            run, chosen = self.summary("steady", case)
            self.assertEqual(run.of_case, "")
            _, fine = self.summary("steady", case, "-grid_nx", 2 * chosen["nx"] - 1, "-grid_ny", 2 * chosen["ny"] - 1)
            for film in ("h_central", "h_min"):
                with self.subTest(case=chosen["case"], film=film):
                    self.assertLess(chosen[film + "_error"], 0.04 * chosen[film])  # a bound
                    self.assertLess(abs(fine[film] - chosen[film]), min(chosen[film + "_error"], 0.02 * fine[film]))
                    self.assertAlmostEqual(chosen[film + "_extrapolated"], fine[film + "_extrapolated"],
                                           delta=0.5 * (chosen[film + "_error"] + fine[film + "_error"]))

    def test_accuracy_is_what_is_asked_for(self):
        case = self.write_case(SLENDER)
        _, rough = self.summary("steady", case, "-grid_accuracy", 0.05)
        _, fine = self.summary("steady", case, "-grid_accuracy", 0.01)
        self.assertLess(rough["nx"], 0.75 * fine["nx"])  # that the film does not tear asks for the same rows
        self.assertLess(rough["h_central_error"], 0.05 * rough["h_central"])
        self.assertLess(fine["h_central_error"], 0.01 * fine["h_central"])

    def test_no_grid_is_chosen_for_films_below_10_nm(self):
        # A tenth of the velocity: 4.4 nm.
        case = self.write_case(SLENDER.replace("velocity: 0.0676816", "velocity: 0.00676816"))
        run = self.run_program("info", case, "-output_dir", "out")
        self.assertRegex(run.stderr, r"(?m)^gearfilm: warning: the expected film is 4\.\d nm; .* for 10 nm, .*grid\.nx")
        found = json.loads((self.folder / "out/summary.json").read_text(encoding="utf-8"))
        self.assertLess(found["nx"] * found["ny"], 400e3)
        self.assertGreater(found["expected_error_h_central"], 0.02)
        given = self.run_program("info", case, "-grid_nx", 641, "-grid_ny", 161, "-output_dir", "out")
        self.assertNotIn("10 nm", given.stderr)

    def test_coarse_grid_says_its_error_or_that_it_has_none(self):
        cold = ["steady", BARBIERI, "-grid_nx", 65, "-grid_ny", 33, "-thermal_model", "none"]
        run, _ = self.summary(*cold, "-grid_accuracy", 0.2)  # too small to be that of this grid
        self.assertNotEqual(run.of_case, "")
        run, summary = self.summary(*cold)
        self.assertRegex(run.of_case, r"\Agearfilm: warning: the films have an error of about \d.* %; raise grid.nx .*\n\Z")
        self.assertGreater(summary["h_min_error"], 0.05 * summary["h_min"])
        run, summary = self.summary("steady", self.write_case(SLENDER), "-grid_nx", 129, "-grid_ny", 65,
                                    "-film_discretisation", "central")
        self.assertRegex(run.of_case, r"\Agearfilm: warning: the error of the films is not known.*\n\Z")
        self.assertIsNone(summary["h_central_error"])

    def test_error_that_the_case_says_is_known_is_not_warned_of(self):
        run, summary = self.summary("steady", BARBIERI, "-thermal_model", "none", "-grid_accuracy", 0.1)
        self.assertGreater(summary["h_min_error"], 0.05 * summary["h_min"])
        self.assertEqual(run.of_case, "")

    # Half the nodes, 65 x 17, have no film that is positive; 257 x 65 have a smallest one of 0.999 um.
    def test_state_that_half_the_grid_cannot_carry_has_errors(self):
        run, found = self.summary("periodic", BARBIERI, "-pinion_speed_rpm", 5000, "-pinion_torque", 100,
                                  "-grid_domain", "auto", "-grid_nx", 129, "-grid_ny", 33, "-grid_y_half", 1.85,
                                  "-periodic_multipliers", "no")
        self.assertRegex(run.stdout, r"on 65 x 17 nodes .* is not positive.*; the search goes on without")
        self.assertGreater(found["h_min_error"], 0.1 * found["h_min"])
        self.assertAlmostEqual(found["h_min_extrapolated"], 0.999e-6, delta=0.07e-6)
        percent = 100 * found["h_min_error"] / found["h_min"]  # of the figure that is printed, as its bar
        self.assertRegex(run.of_case, rf"\Agearfilm: warning: h_min has an error of about {percent:.0f} %, the largest")
        self.assertLess(found["force_ratio_max_error"], 0.01 * found["force_ratio_max"])

    def test_every_figure_that_leads_somewhere_has_an_error(self):
        _, found = self.summary("periodic", BARBIERI, "-time_dt", 0.052, "-friction_law", "eyring",
                                "-periodic_multipliers", "no")
        figures = [name.removesuffix("_extrapolated") for name in found if name.endswith("_extrapolated")]
        self.assertGreaterEqual(len(figures), 15)
        for name in figures:
            with self.subTest(figure=name):
                self.assertIsNotNone(found[name + "_error"])
                if found[name + "_extrapolated"] is None:
                    self.assertIn(name, {"p_max", "p_spike_max"})
                    continue
                off = abs(found[name + "_extrapolated"] - found[name])
                if name == "p_max":
                    self.assertGreaterEqual(found[name + "_error"], off)
                    continue
                factor = 1.5 if name in {"h_min", "pitch_h_min", "entry_h_min"} else 1  # slower than second order
                if name.startswith("pitch_"):  # by the film's largest difference near that point
                    self.assertGreaterEqual(found[name + "_error"], (factor - 1e-6) * off)
                    continue
                self.assertAlmostEqual(found[name + "_error"], factor * off, delta=1e-6 * off)

    def test_state_that_no_coarser_grid_carries_has_none(self):
        run, found = self.summary("periodic", BARBIERI, "-pinion_speed_rpm", 8000, "-grid_domain", "auto",
                                  "-grid_nx", 129, "-grid_ny", 33, "-periodic_multipliers", "no", "-thermal_model",
                                  "none")
        self.assertRegex(run.of_case, r"\Agearfilm: warning: the errors of the quantities are not known.*\n\Z")
        self.assertIsNone(found["h_min_error"])

    def test_two_processes_choose_and_find_the_same(self):
        case = self.write_case(SLENDER)
        _, alone = self.summary("steady", case, "-grid_accuracy", 0.05)
        run = self.run_program("steady", case, "-grid_accuracy", 0.05, "-output_dir", "two", processes=2)
        self.assertEqual((run.status, run.stderr), (0, ""), run)
        two = json.loads((self.folder / "two/summary.json").read_text(encoding="utf-8"))
        for name in ("nx", "ny", "h_central", "h_min", "h_central_error"):
            self.assertAlmostEqual(two[name] / alone[name], 1, delta=1e-5)

    def test_info_prints_what_a_run_begins_with(self):
        run, _ = self.summary("info", BARBIERI)
        for name in ("nx", "ny", "x_min", "y_half", "dT", "expected_error_h_central", "steps_in_free_oscillation"):
            self.assertRegex(run.stdout, rf"(?m)^{name} +[-\d.e]+ +\S.* \S")

    def test_step_follows_the_vibration_where_oil_is_slow(self):
        _, fast = self.summary("info", BARBIERI)
        _, slow = self.summary("info", BARBIERI, "-pinion_speed_rpm", 1300)
        self.assertGreater(fast["steps_in_free_oscillation"], 100)
        self.assertAlmostEqual(slow["steps_in_free_oscillation"], 40, delta=1e-6)
        self.assertLess(slow["dT"], 0.95 * fast["dT"])
        for speed in (800, 400):
            _, slower = self.summary("info", BARBIERI, "-pinion_speed_rpm", speed)
            swings = slower["f_n"] / slower["f_m"]
            finer = min((swings / 10) ** (1 / 3) * min((swings / 12) ** 0.5, 3 / 2), 1.6)
            self.assertAlmostEqual(slower["steps_in_free_oscillation"], 40 * finer, delta=1e-6)

    def test_step_that_is_little_longer_has_films_of_third_order(self):
        _, derived = self.summary("info", BARBIERI, "-pinion_speed_rpm", 1200)
        h_x = (derived["x_max"] - derived["x_min"]) / (derived["nx"] - 1)
        self.assertAlmostEqual(derived["dT"] / h_x, 0.6, delta=1e-9)
        self.assertTrue(40 < derived["steps_in_free_oscillation"] < 40 * 4 / 3)

    def test_lines_follow_waves_of_film(self):
        case, _ = write_pair(self.folder / "lines", 1, 4)  # 25 swings in a mesh period
        _, waves = self.summary("info", case)
        _, calm = self.summary("info", case, "-motion", "quasi_static")
        step = [(of["x_max"] - of["x_min"]) / (of["nx"] - 1) for of in (waves, calm)]
        self.assertTrue(1.35 < step[1] / step[0] < 1.55, step)

    def test_rows_follow_swings_as_steps_do(self):
        case, _ = write_pair(self.folder / "rows", 1, 3)  # at 843 rpm
        _, slow = self.summary("info", case)
        _, fast = self.summary("info", case, "-pinion_speed_rpm", 2500)
        finer = (slow["f_n"] / slow["f_m"] / 10) ** (1 / 3)
        self.assertLess(fast["f_n"] / fast["f_m"], 10)
        self.assertTrue(1.2 < finer < 4 / 3)
        step = [2 * of["y_half"] / (of["ny"] - 1) for of in (slow, fast)]
        self.assertLessEqual(step[0], 0.12 / finer)
        self.assertTrue(0.12 / finer < step[1] <= 0.12)

    def test_more_accuracy_takes_more_steps_too(self):
        slow = ("info", BARBIERI, "-pinion_speed_rpm", 1300, "-grid_accuracy")
        for accuracy, steps in ((0.05, 40), (0.02, 40), (0.005, 80)):
            _, derived = self.summary(*slow, accuracy)
            self.assertAlmostEqual(derived["steps_in_free_oscillation"], steps, delta=1e-6)

    def test_domain_of_a_pair_goes_to_where_its_swings_carry_little(self):
        case, _ = write_pair(self.folder / "pairs", 1, 6)  # at some speed, with films of 0.6 um
        _, swinging = self.summary("info", case)
        _, balanced = self.summary("info", case, "-motion", "quasi_static")
        _, given = self.summary("info", case, "-grid_y_half", 1.5, "-grid_x_max", 1.3)
        self.assertGreater(swinging["y_half"], 1.1 * balanced["y_half"])
        self.assertGreater(swinging["x_max"], 1.5)
        self.assertEqual(balanced["x_max"], 1.25)
        self.assertEqual((given["y_half"], given["x_max"]), (1.5, 1.3))

    def test_slow_pairs_are_in_balance_unless_the_case_says_how_they_move(self):
        case, derived = write_pair(self.folder / "pairs", 1, 20)
        speed = float(re.search(r"(?m)^pinion.speed_rpm: (.*)$", case.read_text(encoding="utf-8"))[1])
        swings = derived["f_n"] / derived["f_m"]
        run, slow = self.summary("periodic", case)
        self.assertEqual(slow["motion"], "quasi_static")
        self.assertRegex(run.stdout, r"would swing [\d.]+ times in a mesh period.* -motion dynamic follows")
        self.assertIn("left out: swings of the total force", run.stdout)
        self.assertNotIn("floquet_modulus", slow)
        self.assertAlmostEqual(slow["force_ratio_max"], 1, delta=2e-3)
        # Where it swings 39 times in a mesh period, or is asked for its multipliers, it has inertia.
        for options in (("-pinion_speed_rpm", speed * swings / 39), ("-periodic_multipliers", "yes")):
            run = self.run_program("periodic", case, *options, "-time_limit", 0.01)
            self.assertEqual(run.status, 3, run)
            self.assertNotIn("in balance", run.stdout)
        # A march follows ten times as many swings.
        for swings_in_march, balanced in ((399, False), (401, True)):
            run = self.run_program("transient", case, "-pinion_speed_rpm", speed * swings / swings_in_march,
                                   "-time_limit", 0.01)
            self.assertEqual(run.status, 3, run)
            self.assertEqual("in balance" in run.stdout, balanced, run)

    def test_pair_whose_ends_of_the_path_are_far_more_curved_has_films_there(self):
        case, _ = write_pair(self.folder / "pairs", 1, 38)  # R_x where it enters: a seventh of that at the pitch point
        run = self.run_program("periodic", case, "-output_dir", "out")
        self.assertEqual(run.status, 0, run)
        found = json.loads((self.folder / "out/summary.json").read_text(encoding="utf-8"))
        self.assertGreater(found["h_min"], 0.0)
        self.assertLess(found["h_min_error"], found["h_min"])

    def test_grid_is_widened_for_a_force_and_says_so(self):
        for ratio, widened in ((1, False), (1.6, True)):
            run, summary = self.summary("steady", BARBIERI, "-steady_load_ratio", ratio)
            self.assertEqual("the grid is widened" in run.stdout, widened, run)
            self.assertEqual(summary["nx"] * summary["ny"] > 129 * 65, widened)

    def test_faces_that_are_too_narrow_are_said(self):
        self.assert_message(self.run_program("steady", HIGH_CONTACT_RATIO, "-steady_load_ratio", 60), 2,
                            "gearfilm: not solved: ", ["edges of the teeth", "raise crowning or face width"])


if __name__ == "__main__":
    unittest.main()
