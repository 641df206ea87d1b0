"""Films between rough surfaces from outside, against the numbers of tests/reference/rough.json.

The line contact: steel, R 10 mm, p_h 1 GPa, 0.04 Pa s, 2e-8 1/Pa, sigma 0.5 um, hardness 6 GPa; 5 m/s at 3000 rpm,
sliding a fifth of that. Environment as for cli_test.py.
"""
import json
import math
import signal
import unittest

import numpy

from films import SAME, summary_in
from program import INPUT, SOURCE
from restarts import MARCH, RestartTest, stopped_after
from vibration import table_in

REFERENCE = json.loads((SOURCE / "tests/reference/rough.json").read_text(encoding="utf-8"))
BOUNDARY = 0.11
LINE = """
case: {name: line, kind: line}
contact:
  radius_x: 0.01
  line_load: 277558
  youngs_modulus_1: 206e9
  youngs_modulus_2: 206e9
  poisson_ratio_1: 0.3
  poisson_ratio_2: 0.3
  entrainment_velocity: 5
  roughness_1: 0.353553390593e-6
  roughness_2: 0.353553390593e-6
lubricant: {viscosity: 0.04, pressure_viscosity: 2e-8}
friction: {law: eyring, eyring_stress: 5e6, limiting_ratio: 0.045, limiting_stress: 5e6, boundary_coefficient: 0.11}
roughness: {model: stochastic, hardness: 6e9}
wear: {coefficient_pinion: 1e-16, coefficient_wheel: 2e-16}
"""
ELLIPSE = """
case: {{name: ellipse, kind: contact}}
contact:
  radius_x: 0.01
  radius_y: {radius_y}
  load: {load}
  reduced_modulus: 2.26e11
  entrainment_velocity: {speed}
  roughness_1: 1.41421356e-7
  roughness_2: 1.41421356e-7
lubricant: {{viscosity: 0.04, pressure_viscosity: 1.9911504e-8}}
roughness: {{model: stochastic, hardness: 2.26e9}}
"""
FINE = ["-grid_nx", 385, "-grid_x_min", -4.5, "-grid_x_max", 1.5]
GROUND = ["-pinion_roughness_ra", "0.3e-6", "-wheel_roughness_ra", "0.3e-6", "-roughness_model", "stochastic"]
FIRST_GEAR = INPUT / "first_gear.yaml"


class RoughnessTest(RestartTest):
    def film(self, rpm, *options, slip=0.2):
        """Of the line contact; slip: u_s/u_m."""
        case = self.write_case(LINE)
        speed = rpm * 5 / 3000
        self.run_well("steady", case, "-output_dir", "film", "-contact_entrainment_velocity", speed,
                      "-contact_sliding_velocity", slip * speed, *options)
        return summary_in(self.folder / "film")


class Lines(RoughnessTest):
    def test_load_shares_gaps_and_friction_are_those_of_the_reference(self):
        for row in REFERENCE["line"][::2]:
            with self.subTest(rpm=row["rpm"]):
                film = self.film(row["rpm"], *FINE)
                self.assertAlmostEqual(film["asperity_load_share"], row["La"], delta=0.005)
                self.assertAlmostEqual(film["h_central"] / 0.5e-6, row["h_c_over_sigma"], delta=0.01)
                self.assertAlmostEqual(film["mean_gap_central"] / 0.5e-6, row["hT_c_over_sigma"], delta=0.01)
                self.assertAlmostEqual(film["friction_coefficient"], row["mu"], delta=5e-4)
                self.assertAlmostEqual(film["lambda_central"], film["h_central"] / 0.5e-6, delta=1e-9)
                self.assertAlmostEqual(film["lambda_smooth"], film["predictions"]["moes_line_h_central"] / 0.5e-6,
                                       delta=1e-6)

    def test_slow_contacts_are_dry_but_for_a_share_that_speed_gives(self):
        """The reference continues the law of flow as this program does."""
        lacking = []
        for rpm, expected in REFERENCE["low_speed"].items():
            if float(rpm) < 1e-3:
                continue  # slower than any case may be
            share = self.film(float(rpm), *FINE)["asperity_load_share"]
            lacking.append(1 - share)
            self.assertAlmostEqual(lacking[-1] / expected, 1, delta=0.02)
        self.assertAlmostEqual(lacking[0] / lacking[1], 10, delta=0.1)

    def test_oil_flows_along_the_lay(self):
        across, isotropic, along = (self.film(100, "-contact_lay", lay) for lay in (1 / 3, 1, 3))
        self.assertLess(across["asperity_load_share"], isotropic["asperity_load_share"])
        self.assertLess(isotropic["asperity_load_share"], along["asperity_load_share"])
        self.assertGreater(across["h_central"], isotropic["h_central"])
        self.assertGreater(isotropic["h_central"], along["h_central"])
        self.assertAlmostEqual(across["asperity_load_share"], REFERENCE["laws"]["zmc_transverse_1_3"], delta=0.01)

    def test_every_law_and_gap_serves(self):
        table = self.folder / "asperities.txt"
        table.write_text("# z, p [Pa]\n-2 2e9\n0 6e8\n1 2e8\n2 3e7\n3 2e6\n", encoding="utf-8")
        for options in (["-roughness_asperity_law", "greenwood_tripp"],
                        ["-roughness_asperity_law", "greenwood_williamson", "-roughness_mean_gap", "nominal"],
                        ["-roughness_asperity_law", "exponential", "-roughness_exponential_pressure", "2.7e9"],
                        ["-roughness_asperity_law", "table", "-roughness_table", table]):
            share = self.film(300, *options)["asperity_load_share"]
            self.assertTrue(0.05 < share < 0.9, f"{options}: {share}")

    def test_friction_is_that_of_oil_and_asperities_and_wear_goes_with_its_work(self):
        film = self.film(300)
        self.assertAlmostEqual(film["friction_coefficient"],
                               film["friction_coefficient_fluid"] + film["friction_coefficient_boundary"], delta=1e-15)
        self.assertAlmostEqual(film["friction_coefficient_boundary"], BOUNDARY * film["asperity_load_share"],
                               delta=1e-12)
        self.assertAlmostEqual(film["wear_rate_pinion"] * BOUNDARY / (1e-16 * film["power_boundary"]), 1, delta=1e-12)
        # u_1 = 1.1 u_m and u_2 = 0.9 u_m, k_2 = 2 k_1.
        self.assertAlmostEqual(film["wear_depth_wheel"] / film["wear_depth_pinion"], 2 * 1.1 / 0.9, delta=1e-12)
        expected = 1e-16 * 0.2 / 1.1 * film["asperity_load_share"] * 277558
        self.assertAlmostEqual(film["wear_depth_pinion"] / expected, 1, delta=1e-6)

    def test_peak_to_valley_heights_are_taken_with_a_warning(self):
        case = self.write_case(LINE.replace("roughness_1: 0.353553390593e-6", "roughness_rz_1: 2e-6"))
        outcome = self.run_program("steady", case, "-output_dir", "film")
        self.assertEqual(outcome.status, 0, outcome)
        self.assertIn("taken for Rq = 0.47 um", outcome.stderr)
        film = summary_in(self.folder / "film")
        sigma = math.hypot(math.sqrt(math.pi / 2) * 2e-6 / 5.3, 0.353553390593e-6)
        self.assertAlmostEqual(film["lambda"], film["h_min"] / sigma, delta=1e-9)

    def test_flanks_may_change_places(self):
        there = self.film(300, "-contact_roughness_1", "0.6e-6", "-contact_roughness_2", "0.2e-6")
        turned = self.film(300, "-contact_roughness_1", "0.2e-6", "-contact_roughness_2", "0.6e-6", slip=-0.2)
        back = self.film(300, "-contact_roughness_1", "0.6e-6", "-contact_roughness_2", "0.2e-6", slip=-0.2)
        self.assertAlmostEqual(there["h_central"] / turned["h_central"], 1, delta=SAME)
        # The rougher surface, if it is the faster one, carries more oil.
        self.assertGreater(there["h_central"], back["h_central"])

    def test_heat_of_asperities_goes_into_the_flanks(self):
        film = self.film(300, "-thermal_model", "film", "-lubricant_temperature_viscosity", 0.04)
        self.assertLess(abs(film["heat_balance"]), 1e-8)
        self.assertAlmostEqual((film["heat_pinion"] + film["heat_wheel"] + film["heat_oil"]) / film["power_sliding"], 1,
                               delta=0.02)


class Ellipses(RoughnessTest):
    def test_load_shares_and_gaps_are_those_of_the_reference(self):
        modulus, radius = 2.26e11, 0.01
        for row in REFERENCE["ellipses"]:
            with self.subTest(**row):
                force = (1e-6 if row["D"] == 1 else 4e-6) * modulus * radius**2
                case = self.write_case(ELLIPSE.format(radius_y=radius / row["D"], load=force,
                                                      speed=row["U"] * modulus * radius / 0.04))
                self.run_well("steady", case, "-output_dir", "film", "-grid_nx", 97, "-grid_ny", 33, "-grid_x_min", -3,
                              "-grid_x_max", 1.5, "-grid_y_half", 1.6)
                film = summary_in(self.folder / "film")
                self.assertAlmostEqual(film["asperity_load_share"], row["La"], delta=0.03)
                for name, gap in (("h_central", "h_c"), ("mean_gap_central", "hT_c"), ("h_min", "h_min")):
                    self.assertAlmostEqual(film[name] / 2e-7, row[f"{gap}_over_sigma"], delta=0.05)


class Gears(RoughnessTest):
    def test_from_boundary_lubrication_to_full_films(self):
        """Slow pairs too: where asperities carry there is no speed too low."""
        shares = []
        for rpm in (3000, 300, 30, 3):
            self.run_well("steady", FIRST_GEAR, *GROUND, "-pinion_speed_rpm", rpm, "-output_dir", "film")
            film = summary_in(self.folder / "film")
            shares.append(film["asperity_load_share"])
            self.assertLess(film["newton_iterations"], 16)
        self.assertEqual(shares, sorted(shares))

    def test_periodic_state_of_a_slow_pair(self):
        self.run_well("periodic", FIRST_GEAR, *GROUND, "-pinion_speed_rpm", 30, "-motion", "quasi_static", "-grid_nx",
                      65, "-grid_ny", 17, "-wear_coefficient_pinion", "1e-17", "-output_dir", "slow")
        slow = summary_in(self.folder / "slow")
        self.assertTrue(0.6 < slow["asperity_load_share_mean"] < 0.9)
        contacts = table_in(self.folder / "slow", "history/contacts")
        loaded = contacts[contacts["force"] > 0.2 * contacts["force"].max()]
        split = loaded["friction_coefficient_fluid"] + loaded["friction_coefficient_boundary"]
        self.assertLess(numpy.abs(split - loaded["friction_coefficient"]).max(), 1e-12)
        # What oil and asperities lose is what the mesh loses.
        of_oil = loaded["friction_coefficient_fluid"] * loaded["force"] * numpy.abs(loaded["sliding_velocity"])
        left = loaded["power_sliding"] - loaded["power_boundary"] - numpy.abs(of_oil)
        self.assertLess(numpy.abs(left).max(), 1e-12 * loaded["power_sliding"].max())
        steps = table_in(self.folder / "slow", "history/steps")
        period = steps[steps["t"] > steps["t"][-1] - (1 + 1e-9) * 60 / (15 * 30)]
        energy = (numpy.diff(period["t"]) * (period["power_sliding"][1:] + period["power_sliding"][:-1]) / 2).sum()
        self.assertAlmostEqual(energy * (15 * 30) / 60 / slow["power_sliding"], 1, delta=2e-3)
        transmitted = 90 * math.pi * 30 / 30
        self.assertAlmostEqual(slow["efficiency"], 1 - slow["power_loss"] / transmitted, delta=1e-9)
        self.assertLess(table_in(self.folder / "slow", "history/steps")["newton"].mean(), 5)
        # Flanks wear where they slide: least at the pitch point.
        at_pitch = numpy.argmin(numpy.abs(loaded["xi"]))
        self.assertLess(loaded["wear_depth_pinion"][at_pitch], 0.2 * slow["wear_depth_pinion_max"])

    def test_a_sweep_gives_the_whole_curve_of_stribeck(self):
        """Friction lies between that of full films, which smooth flanks have at 3000 rpm, and that of asperities."""
        self.run_well("periodic", FIRST_GEAR, "-motion", "quasi_static", "-grid_nx", 65, "-grid_ny", 17,
                      "-friction_limiting_ratio", 0.045, "-output_dir", "full")
        of_oil = summary_in(self.folder / "full")["mean_friction_coefficient"]
        self.run_well("sweep", INPUT / "mixed_first_gear.yaml", "-grid_nx", 65, "-grid_ny", 17, "-sweep_values",
                      "3000, 300, 30, 1", "-output_dir", "sweep")
        summary = summary_in(self.folder / "sweep")
        self.assertEqual(summary["points_failed"], 0)
        for name, least, largest in (("asperity_load_share_mean", 0, 1),
                                     ("mean_friction_coefficient", min(of_oil, BOUNDARY), max(of_oil, BOUNDARY))):
            values = [point[name] for point in summary["points"]]
            self.assertEqual(values, sorted(values))
            self.assertTrue(least < values[0] and values[-1] < largest, values)

    def test_two_processes_find_the_same(self):
        shares = []
        for processes in (1, 2):
            self.run_well("steady", FIRST_GEAR, *GROUND, "-pinion_speed_rpm", 100, "-grid_nx", 65, "-grid_ny", 33,
                          "-output_dir", "film", processes=processes)
            shares.append(summary_in(self.folder / "film")["asperity_load_share"])
        self.assertAlmostEqual(shares[0], shares[1], delta=SAME)

    def test_a_march_goes_on_to_the_bit(self):
        march = [*MARCH, *GROUND, "-friction_law", "eyring", "-wear_coefficient_pinion", "1e-17"]
        outcome = stopped_after(5, [*march, "-output_dir", "run"], self.folder, signal.SIGUSR1)
        self.assertEqual(outcome.status, 3, outcome)
        self.assert_same(self.complete(*march), self.uninterrupted(*march))


class Formulas(RoughnessTest):
    def test_formulas_of_films_and_shares_stand_beside_them(self):
        """W 1e-4, U 1e-11, G 4500, sigma/R 2e-5, H/E' 0.01: 0.183 and 1.015 sigma."""
        case = self.write_case(LINE)
        self.run_well("steady", case, "-output_dir", "film", "-contact_line_load", 1e-4 * 206e9 / 0.91 * 0.01,
                      "-contact_entrainment_velocity", 1e-11 * 206e9 / 0.91 * 0.01 / 0.04,
                      "-lubricant_pressure_viscosity", 4500 / (206e9 / 0.91), "-contact_roughness_1",
                      2e-7 / math.sqrt(2), "-contact_roughness_2", 2e-7 / math.sqrt(2), "-roughness_hardness",
                      0.01 * 206e9 / 0.91, "-roughness_mean_gap", "nominal")
        film = summary_in(self.folder / "film")
        predicted = film["predictions"]
        self.assertTrue(predicted["masjedi_khonsari_valid"])
        self.assertAlmostEqual(predicted["masjedi_khonsari_asperity_load_share"], 0.183, delta=5e-4)
        self.assertAlmostEqual(predicted["masjedi_khonsari_h_central"] / 2e-7, 1.015, delta=5e-4)
        self.assertAlmostEqual(film["asperity_load_share"], 0.189, delta=0.005)


if __name__ == "__main__":
    unittest.main()
