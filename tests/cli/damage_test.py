"""Stresses below films and fatigue of flanks from outside, against the numbers of tests/reference/damage.json.
Environment as for cli_test.py."""
import json
import re
import signal
import sys
import unittest

import h5py
import numpy

from films import BARBIERI, SAME, summary_in
from program import INPUT, SOURCE
from restarts import SMALL, RestartTest, stopped_after
from script import plot
from vibration import table_in

sys.path.insert(0, str(SOURCE / "scripts"))
import gearfilm  # noqa: E402
from gearfilm.report import write_report  # noqa: E402
from gearfilm.verdicts import verdicts  # noqa: E402

REFERENCE = json.loads((SOURCE / "tests/reference/damage.json").read_text(encoding="utf-8"))
# The film of the reference's steady numbers, whose discretisation is the paper's.
STUDY = ["-steady_position", "4e-3", "-friction_law", "eyring", "-pinion_speed_rpm", 6000, "-grid_nx", 129, "-grid_ny", 33,
         "-film_discretisation", "central"]
COARSE = ["-steady_position", "4e-3", "-friction_law", "eyring", "-grid_nx", 65, "-grid_ny", 17]
JUDGED = ["-friction_law", "eyring", "-stress_model", "row", "-stress_points", 8, "-fatigue_criterion", "dang_van",
          "-fatigue_flank_points", 11, "-pinion_surface_hardness", 700, "-pinion_core_hardness", 350, "-pinion_case_depth",
          "0.8e-3"]
MARCH = ["transient", BARBIERI, *SMALL, *JUDGED]
ORBIT = ["periodic", BARBIERI, *SMALL, *JUDGED, "-periodic_multipliers", "no", "-output_snapshot_interval", 0]
OF_STRESS = ("von_mises_max", "von_mises_depth", "shear_max", "shear_depth", "orthogonal_shear", "orthogonal_shear_depth",
             "surface_tension")


def reference(name):
    return REFERENCE[name]["value"]


class DamageTest(RestartTest):
    def steady(self, *options, case=BARBIERI, processes=1, name="film"):
        self.run_well("steady", case, "-output_dir", name, *options, processes=processes)
        return summary_in(self.folder / name)

    def assert_drawn(self, name, *options):
        """By `plot damage`, without a warning."""
        run = plot("damage", self.folder / name, *options)
        self.assertEqual((run.returncode, run.stderr), (0, ""), run)
        self.assertTrue((self.folder / name / "damage.png").read_bytes().startswith(b"\x89PNG"))

    def section(self, name="film"):
        with h5py.File(self.folder / name / "results.h5") as file:
            return {key: values[()] for key, values in file["contact0/section"].items()}

    def flank(self, name, body="pinion"):
        with h5py.File(self.folder / name / "results.h5") as file:
            return {key: values[()].squeeze() for key, values in file[f"flank/{body}"].items()}


class Steady(DamageTest):
    def test_stresses_are_those_of_the_reference(self):
        film = self.steady(*STUDY, "-stress_model", "row")
        self.assertAlmostEqual(film["von_mises_max_pinion"] / 1e6 / reference("ehl_steady_von_mises_max_MPa"), 1, delta=5e-3)
        self.assertAlmostEqual(
            film["orthogonal_shear_pinion"] / 1e6 / reference("ehl_steady_orthogonal_amplitude_max_MPa"), 1, delta=5e-3)

    def test_the_section_has_what_the_summary_says(self):
        film = self.steady(*COARSE, "-stress_model", "row")
        self.assert_drawn("film")
        section = self.section()
        for body in ("pinion", "wheel"):
            stress = {name: section[f"sigma_{name}_{body}"] for name in ("xx", "yy", "zz", "yz", "xz", "xy")}
            self.assertEqual(stress["xx"].shape, (section["z"].size, section["x"].size))
            matrices = numpy.array([[stress["xx"], stress["xy"], stress["xz"]], [stress["xy"], stress["yy"], stress["yz"]],
                                    [stress["xz"], stress["yz"], stress["zz"]]]).transpose(2, 3, 0, 1)
            principal = numpy.linalg.eigvalsh(matrices)
            first, second, third = (principal[..., n] for n in range(3))
            equivalent = numpy.sqrt(((first - second)**2 + (second - third)**2 + (third - first)**2) / 2)
            numpy.testing.assert_allclose(section[f"von_mises_{body}"], equivalent, rtol=1e-9, atol=1e-3)
            # Between depths the summary has a parabola's.
            self.assertAlmostEqual(film[f"von_mises_max_{body}"] / equivalent.max(), 1, delta=2e-3)
            self.assertAlmostEqual(film[f"surface_tension_{body}"] / third[0].max(), 1, delta=1e-9)
            amplitude = (stress["xz"].max(axis=1) - stress["xz"].min(axis=1)) / 2
            self.assertAlmostEqual(film[f"orthogonal_shear_{body}"] / amplitude.max(), 1, delta=2e-2)
            depth = section["z"][equivalent.max(axis=1).argmax()]
            self.assertAlmostEqual(film[f"von_mises_depth_{body}"] / depth, 1, delta=0.1)

    def test_whole_fields_have_the_section_in_their_middle_row(self):
        film = self.steady(*COARSE, "-stress_model", "field", "-stress_points", 41)
        section = self.section()
        with h5py.File(self.folder / "film/results.h5") as file:
            contact = file["contact0"]
            field, x = contact["von_mises_pinion"][()], contact["x"][()]
            numpy.testing.assert_allclose(field, field[:, ::-1], rtol=1e-12)
            self.assertEqual(contact["von_mises_wheel"].attrs["unit"], contact["P"].attrs["unit"])
        middle = field[:, field.shape[1] // 2]
        self.assertAlmostEqual(middle.max() / film["von_mises_max_pinion"], 1, delta=1e-3)
        first = numpy.abs(section["x"] - x[0]).argmin()
        near = numpy.abs(section["z"] - film["von_mises_depth_pinion"]).argmin()
        beside = section["von_mises_pinion"][near - 1:near + 2, first:first + x.size]
        self.assertTrue((middle <= 1.01 * beside.max(axis=0)).all() and (middle >= 0.99 * beside.min(axis=0)).all())

    def test_any_number_of_processes_gives_the_same(self):
        alone = self.steady(*COARSE, "-stress_model", "field")
        expected = self.section()
        for processes in (2, 4):
            together = self.steady(*COARSE, "-stress_model", "field", processes=processes, name="together")
            for name in OF_STRESS:
                for body in ("pinion", "wheel"):
                    key = f"{name}_{body}"
                    self.assertAlmostEqual(together[key] / alone[key], 1, delta=SAME, msg=key)
            found = self.section("together")
            for name, values in expected.items():
                numpy.testing.assert_allclose(found[name], values, rtol=SAME, atol=SAME * numpy.abs(values).max())

    def test_other_figures_are_not_touched(self):
        """To the bit."""
        with_stress, without = self.steady(*COARSE, "-stress_model", "row"), self.steady(*COARSE, name="without")
        of_stress = {f"{name}_{body}" for name in OF_STRESS for body in ("pinion", "wheel")}
        self.assertEqual(set(with_stress) - set(without), of_stress)
        self.assertEqual({name: value for name, value in with_stress.items() if name in without}, without)

    def test_gears_that_yield_are_warned_of_and_films_at_rest_have_safeties(self):
        rated = ["-rating_contact_limit", "1.5e9", "-rating_root_limit", "1e9"]
        for stress, yields in (("1.2e9", True), ("2e9", False)):
            run = self.run_program("steady", BARBIERI, "-output_dir", "film", *COARSE, *rated, "-wheel_yield_stress", stress)
            self.assertEqual((run.status, "yields below its surface" in run.stderr), (0, yields), run)
        film = summary_in(self.folder / "film")
        for name, key in (("pitting", "sigma_H"), ("root_pinion", "sigma_F_pinion"), ("root_wheel", "sigma_F_wheel")):
            entry = film["safety"][name]
            self.assertEqual((entry["stress"], entry["xi"]), (film[key], 4e-3))
            self.assertAlmostEqual(entry["safety"] * entry["stress"] / entry["limit"], 1)
        self.assertEqual(film["safety"]["flash"]["temperature"], film["contact_temperature"])
        self.assertIsNone(film["safety"]["integral"])

    def test_a_line_contact_is_hertz_s_beneath_a_film(self):
        case = self.write_case("""
case: {name: line, kind: line}
contact: {radius_x: 0.01, line_load: 277558, youngs_modulus_1: 206e9, youngs_modulus_2: 206e9, poisson_ratio_1: 0.3,
          poisson_ratio_2: 0.3, entrainment_velocity: 0.5}
lubricant: {viscosity: 0.04, pressure_viscosity: 2e-8}
""")
        film = self.steady("-stress_model", "row", "-grid_nx", 257, case=case)
        for body in ("pinion", "wheel"):
            self.assertAlmostEqual(film[f"von_mises_max_{body}"] / film["p_hertz"], reference("line_von_mises_max_nu.3"),
                                   delta=0.01)
            self.assertAlmostEqual(film[f"shear_max_{body}"] / film["p_hertz"], reference("line_tau_max"), delta=0.01)


class Flanks(DamageTest):
    def assert_balanced(self, name, mesh_periods):
        """What friction takes is on the flanks or beyond their ends, and extremes are those of the history."""
        with h5py.File(self.folder / name / "results.h5") as file:
            history = file["history"].attrs
            begin, end = (history.get(f"periodic_{limit}", fallback) for limit, fallback in (("from", 0), ("to", numpy.inf)))
            contacts = file["history/contacts"][()]
            beyond = {body: file[f"flank/{body}"].attrs["friction_energy_beyond"] for body in ("pinion", "wheel")}
        contacts = contacts[(contacts["T"] > begin - 1e-9) & (contacts["T"] < end + 1e-9)]
        lost = sum(numpy.trapz(of["power_sliding"], of["t"])
                   for of in (contacts[contacts["contact"] == number] for number in numpy.unique(contacts["contact"])))
        for body in ("pinion", "wheel"):
            flank = self.flank(name, body)
            self.assertEqual(flank["p_max"].shape, (flank["s"].size, flank["y"].size))
            along = numpy.full(flank["s"].size, flank["s"][1] - flank["s"][0])
            along[[0, -1]] /= 2
            on_flank = along @ flank["friction_energy"] @ numpy.gradient(flank["y"])
            self.assertAlmostEqual(mesh_periods * (on_flank + beyond[body]) / lost, 1, delta=1e-9)
            self.assertLess(beyond[body], 0.15 * on_flank)
            self.assertEqual(flank["p_max"].max(), contacts["p_max"].max())
            self.assertGreaterEqual(flank["h_min"].min(), contacts["h_min"].min())
            numpy.testing.assert_array_equal(flank["p_max"], flank["p_max"][:, ::-1])
            self.assertGreater(flank["sliding_distance"].max(), 0)

    def test_maps_have_what_the_summary_says(self):
        self.run_well(*ORBIT, "-output_dir", "orbit", "-pinion_residual_stress", "hardness")
        summary = summary_in(self.folder / "orbit")
        self.assert_drawn("orbit")
        self.assert_drawn("orbit", "--section")
        page = write_report(gearfilm.open(self.folder / "orbit")).read_text(encoding="utf-8")
        first, second = (page.index(f"flank of the {gear}: Dang Van stress") for gear in ("pinion", "wheel"))
        self.assertTrue(page.index("What fails first") < first < second, "that without a limit comes last")
        for figure in ("Stresses below the films", "at the worst moment", "over the path of contact", "Contact pattern"):
            self.assertIn(figure, page)
        contacts = table_in(self.folder / "orbit", "history/contacts")
        for body in ("pinion", "wheel"):
            flank = self.flank("orbit", body)
            self.assertEqual(flank["dang_van"].shape, (flank["s"].size, flank["z"].size))
            numpy.testing.assert_allclose(numpy.diff(flank["rho"]**2) / numpy.diff(flank["s"]),
                                          (flank["rho"]**2 / flank["s"])[0], rtol=1e-9)
            a = flank["z"][-1] / 2
            inside = (flank["s"] >= flank["s"][0] + a) & (flank["s"] <= flank["s"][-1] - a)
            below = flank["z"] >= 0.05 * a
            self.assertEqual(summary[f"dang_van_max_{body}"], flank["dang_van"][inside][:, below].max())
            self.assertEqual(summary[f"dang_van_surface_{body}"], flank["dang_van"][inside, 0].max())
            self.assertLessEqual(flank["von_mises_max"].max(), contacts[f"von_mises_max_{body}"].max() * (1 + 1e-3))
            self.assertGreater(flank["von_mises_max"].max(), contacts[f"von_mises_max_{body}"][-50:].max() * 0.9)
        self.assert_balanced("orbit", 1.0)
        run = plot("face", self.folder / "orbit")
        self.assertEqual((run.returncode, run.stderr), (0, ""), run)
        flank = self.flank("orbit")
        expected = (0.4e6 * flank["hardness"] - 0.2 * flank["residual_stress"]) / flank["dang_van"]
        numpy.testing.assert_allclose(flank["safety"], expected, rtol=1e-12)
        self.assertEqual(summary["safety_dang_van_pinion"], expected[inside][:, below].min())
        self.assertIsNone(summary["safety_dang_van_wheel"])

        # A march that begins in the periodic state leaves the same.
        self.run_well(*MARCH, "-mesh_periods", 3, "-output_dir", "march", "-start_place", "after_leaving", "-start_H0",
                      summary["H0_after_leaving"], "-start_V0", summary["V0_after_leaving"])
        march = summary_in(self.folder / "march")
        for name in ("dang_van_max_pinion", "dang_van_max_wheel", "life_ratio"):
            self.assertAlmostEqual(march[name] / summary[name], 1, delta=0.03, msg=name)
        self.assert_balanced("march", 3.0)
        energy, repeated = (self.flank(name)["friction_energy"] for name in ("orbit", "march"))
        numpy.testing.assert_allclose(repeated, energy, rtol=0, atol=0.03 * energy.max())
        self.assertIsNone(march["safety_dang_van_wheel"])

    def test_a_sweep_has_the_columns_and_more_torque_more_stress(self):
        self.run_well("sweep", BARBIERI, *SMALL, *JUDGED, "-sweep_over", "torque", "-sweep_values", "300, 400", "-sweep_direction", "up",
                      "-rating_contact_limit", "1.5e9", "-periodic_multipliers", "no", "-output_dir", "sweep")
        table = table_in(self.folder / "sweep", "sweep")
        for name in ("dang_van_max_pinion", "von_mises_max_wheel", "orthogonal_shear_pinion"):
            self.assertLess(table[name][0], table[name][1], name)
        self.assertGreater(table["safety_dang_van_pinion"][0], table["safety_dang_van_pinion"][1])
        self.assertTrue(numpy.isnan(table["safety_dang_van_wheel"]).all())
        pitting = [point["safety"]["pitting"] for point in summary_in(self.folder / "sweep")["points"]]
        self.assertEqual([entry["stress"] for entry in pitting], list(table["sigma_H_max"]))

    def test_any_number_of_processes_gives_the_same(self):
        march = [*MARCH, "-mesh_periods", 2.4, "-stress_rows", "all"]
        self.run_well(*march, "-output_dir", "alone")
        for processes in (2, 4):
            self.run_well(*march, "-output_dir", "together", processes=processes)
            found, expected = self.flank("together"), self.flank("alone")
            for name, values in expected.items():
                numpy.testing.assert_allclose(found[name], values, rtol=0, atol=1e-4 * numpy.nanmax(numpy.abs(values)),
                                              err_msg=name)

    def test_a_search_goes_on_to_the_bit(self):
        search = ["periodic", BARBIERI, *SMALL, "-friction_law", "eyring", "-periodic_multipliers", "no"]
        expected = self.uninterrupted(*search)
        self.assertIn("p_max", self.flank("uninterrupted"))
        # In the period that repeats.
        outcome = stopped_after(24, [*search, "-output_dir", "run"], self.folder, signal.SIGUSR1)
        self.assertEqual(outcome.status, 3, outcome)
        self.assert_same(self.complete(*search), expected)

    def test_a_march_goes_on_to_the_bit(self):
        """Stopped while the contact that is judged is on its way."""
        march = [*MARCH, "-mesh_periods", 3.2, "-stress_rows", "all"]
        outcome = stopped_after(14, [*march, "-output_dir", "run"], self.folder, signal.SIGUSR1)
        self.assertEqual(outcome.status, 3, outcome)
        stopped_at = float(re.search(r"stopped: at mesh period ([-+.e\d]+)", outcome.stderr)[1])
        self.assertTrue(1.8 < stopped_at < 3.1, outcome)
        expected = self.uninterrupted(*march)
        self.assertIsNotNone(summary_in(self.folder / "uninterrupted")["dang_van_max_pinion"])
        self.assert_same(self.complete(*march), expected)


class WholeFace(DamageTest):
    def test_rows_of_a_misaligned_face_have_maps_and_the_worst_is_told(self):
        run = self.run_program("transient", INPUT / "misaligned.yaml", "-mesh_periods", 1.9, "-motion", "quasi_static",
                               "-time_dt", 0.3, "-grid_nx", 65, "-grid_first_row", 0.4, "-grid_row_growth", 2.5,
                               "-grid_largest_row", 10, "-lubricant_viscosity", 0.06, *JUDGED, "-stress_rows", "all",
                               "-output_dir", "face")
        self.assertEqual(run.status, 0, run)
        summary = summary_in(self.folder / "face")
        for body in ("pinion", "wheel"):
            flank = self.flank("face", body)
            y, rows = flank["y_rows"], flank["dang_van_rows"]
            self.assertEqual(rows.shape, (y.size, flank["s"].size, flank["z"].size))
            self.assertGreater(numpy.diff(y).min(), 14e-3 / 16)
            numpy.testing.assert_array_equal(flank["dang_van"], rows.max(axis=0))
            # The flanks part towards +y, and are relieved over 4 mm at both ends.
            worst = summary[f"dang_van_y_{body}"]
            self.assertAlmostEqual(worst, -3e-3, delta=1e-3)
            of_row = rows[numpy.flatnonzero(y == worst)[0]]
            self.assertIn(summary[f"dang_van_max_{body}"], of_row)
            pressed = numpy.nanmax(flank["p_max"], axis=0)
            self.assertAlmostEqual(flank["y"][pressed.argmax()], worst, delta=1e-3)
        self.assertTrue(0.5 < summary["life_ratio"] < 2, summary["life_ratio"])
        with h5py.File(self.folder / "face/results.h5") as file:
            contacts, section = file["history/contacts"][()], file["section/pinion"]
            self.assertAlmostEqual(section["von_mises"][()].max() / contacts["von_mises_max_pinion"].max(), 1, delta=0.05)
            self.assertEqual(section.attrs["y"], summary["dang_van_y_pinion"])


class Ratings(DamageTest):
    RATED = ["-friction_law", "eyring", "-rating_contact_limit", "1.5e9", "-rating_root_limit", "1e9",
             "-rating_scuffing_temperature", 600, "-rating_cycles", "3e6"]

    def test_safeties_are_those_of_the_worst_contact(self):
        rough = ["-pinion_roughness_ra", "0.4e-6", "-wheel_roughness_ra", "0.2e-6"]
        self.run_well("transient", BARBIERI, *SMALL, *self.RATED, *rough, "-output_dir", "rated")
        safety = summary_in(self.folder / "rated")["safety"]
        self.assert_drawn("rated")
        contacts = table_in(self.folder / "rated", "history/contacts")
        for rating, column in (("pitting", "sigma_H"), ("root_pinion", "sigma_F_pinion"), ("root_wheel", "sigma_F_wheel")):
            worst = contacts[column].argmax()
            self.assertEqual(safety[rating]["stress"], contacts[column][worst], rating)
            self.assertEqual(safety[rating]["xi"], contacts["xi"][worst], rating)
            self.assertAlmostEqual(safety[rating]["safety"] * contacts[column][worst] / safety[rating]["limit"], 1)
        self.assertAlmostEqual(safety["root_pinion"]["limit"], 1e9, delta=1)
        numpy.testing.assert_allclose(
            contacts["sigma_H"]**2 / contacts["force"] * self.reduced_radius(contacts["xi"]),
            206e9 / 0.91 / (2 * numpy.pi * self.face_width), rtol=1e-6)
        warmest = contacts["contact_temperature"].max()
        numpy.testing.assert_allclose(contacts["contact_temperature"], 363.15 + contacts["flash_temperature"])
        self.assertAlmostEqual(safety["flash"]["safety"], (600 - 363.15) / (warmest - 363.15))
        loaded = contacts["lambda_GF"] > 0
        self.assertEqual(safety["micropitting"]["lambda_GF"], contacts["lambda_GF"][loaded].min())
        self.assertAlmostEqual(safety["micropitting"]["lambda_film"], contacts["h_min"][loaded].min() / 0.3e-6)

    def test_the_least_safety_comes_first(self):
        rows = verdicts({"dang_van_max_pinion": 3e8, "safety_dang_van_pinion": 1.2, "safety_dang_van_s_pinion": 4e-3,
                         "safety_dang_van_z_pinion": 2e-4, "dang_van_max_wheel": None,
                         "safety": {"pitting": {"stress": 1.5e9, "xi": 1e-3, "limit": 1.35e9, "safety": 0.9},
                                    "root_pinion": None,
                                    "integral": {"temperature": 400.0, "limit": None, "safety": None}}})
        self.assertEqual([row[0].partition(":")[0] for row in rows], ["pitting", "flank of the pinion", "scuffing"])
        self.assertEqual(rows[0][1:], ("1500", "1350", "MPa", "0.9", "xi = 1 mm"))
        self.assertEqual(rows[1][1:], ("300", "", "MPa", "1.2", "s = 4 mm, 0.2 mm deep"))
        self.assertEqual(rows[2][1:], ("400", "", "K", "", "over the path of contact"))

    def test_what_has_no_input_has_no_verdict(self):
        self.run_well("periodic", BARBIERI, *SMALL, "-rating_contact_limit", "1.5e9", "-periodic_multipliers", "no",
                      "-output_dir", "rated")
        summary = summary_in(self.folder / "rated")
        self.assertEqual([name for name, rating in summary["safety"].items() if rating], ["pitting"])
        self.assertEqual(summary["safety"]["pitting"]["stress"], summary["sigma_H_max"])
        self.assertNotIn("sigma_F_max_pinion", summary)

    def test_without_limits_nothing_is_rated(self):
        self.run_well("transient", BARBIERI, *SMALL, "-output_dir", "plain")
        self.assertNotIn("safety", summary_in(self.folder / "plain"))
        run = plot("damage", self.folder / "plain")
        self.assertEqual((run.returncode, run.stdout), (1, ""), run)
        self.assertIn("it has neither stresses below films nor ratings; give stress.model", run.stderr)
        names = table_in(self.folder / "plain", "history/contacts").dtype.names
        self.assertFalse({"sigma_H", "sigma_F_pinion", "lambda_GF", "contact_temperature", "von_mises_max_pinion"} & set(names))

    def setUp(self):
        super().setUp()
        self.run_well("info", BARBIERI, "-output_dir", "info")
        pair = summary_in(self.folder / "info")
        tangent = numpy.tan(numpy.radians(pair["working_pressure_angle_deg"]))
        first, second = (pair[f"base_radius_{gear}"] * tangent for gear in ("pinion", "wheel"))
        self.reduced_radius = lambda xi: (first + xi) * (second - xi) / (first + second)
        self.face_width = 0.02


if __name__ == "__main__":
    unittest.main()
