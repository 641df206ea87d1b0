"""Friction, heat and losses in what commands write, and wrong input for them."""
import math
import unittest

import h5py
import numpy

from film_equations import FilmEquations
from films import BARBIERI, CIRCULAR, summary_in
from program import SOURCE, ProgramTest
from restarts import SMALL
from script import plot
from vibration import table_in

HEAT = ["-friction_law", "eyring", "-thermal_model", "friction", "-lubricant_temperature_viscosity", 0.04]
OF_FRICTION = {"friction_force", "friction_coefficient", "power_sliding", "power_rolling", "flash_temperature"}
OF_HEAT = {"surface_temperature_pinion", "surface_temperature_wheel", "film_temperature_max", "heat_balance"}
FIELDS = {"shear_stress", "temperature_pinion", "temperature_wheel", "temperature_mean", "temperature_mid",
          "temperature_max", "heat_flux_pinion", "heat_flux_wheel"}


class Friction(ProgramTest):
    def summary(self, command, case, *options, processes=1):
        run = self.run_program(command, case, *options, "-output_dir", "out", processes=processes)
        self.assertEqual(run.status, 0, run)
        return summary_in(self.folder / "out"), run

    def test_without_the_keys_there_is_none(self):
        summary, _ = self.summary("steady", BARBIERI, "-grid_nx", 65, "-grid_ny", 33)
        self.assertFalse((OF_FRICTION | OF_HEAT | {"lambda"}) & summary.keys())

    def test_a_stationary_film_has_friction_fields_and_predictions(self):
        summary, run = self.summary("steady", BARBIERI, *HEAT, "-grid_nx", 65, "-grid_ny", 33, "-steady_position",
                                    0.002, "-pinion_roughness", 2e-6, "-wheel_roughness", 2e-6)
        self.assertLess(OF_FRICTION | OF_HEAT, summary.keys())
        self.assertIn("friction coefficient", run.stdout)
        self.assertIn("inlet", run.of_case)  # heated far too much for an isothermal film
        self.assertIn("asperities", run.stderr)
        self.assertAlmostEqual(summary["lambda"], summary["h_min"] / (2e-6 * 2 ** 0.5), delta=1e-9)
        self.assertLess({"xu_kahraman_friction", "blok_flash_temperature", "schlenk_mean_friction",
                         "murch_wilson_thermal_factor"}, summary["predictions"].keys())
        with h5py.File(self.folder / "out/results.h5") as file:
            contact = file["contact0"]
            self.assertLess(FIELDS, set(contact))
            stress, pressure = contact["shear_stress"][:], contact["P"][:]
            self.assertAlmostEqual(stress.sum() / pressure.sum() / summary["friction_coefficient"], 1, delta=1e-9)
            self.assertEqual(contact["temperature_mid"].attrs["unit"], "K")
            across, middle = contact["temperature_across"][:], numpy.argmin(abs(contact["y"][:]))
            self.assertEqual(across.shape, (65, 17))
            for point, name in ((0, "wheel"), (8, "mid"), (16, "pinion")):
                numpy.testing.assert_array_equal(across[:, point], contact[f"temperature_{name}"][:, middle])
        drawn = plot("friction", self.folder / "out")
        self.assertEqual(drawn.returncode, 0, drawn.stderr)

    def test_a_film_that_feels_its_shear_obeys_reynolds_equation_of_that_oil(self):
        """Rows of the film that was written, with the flow of Eyring's law integrated again."""
        summary, run = self.summary("steady", BARBIERI, "-friction_law", "eyring", "-friction_in_film", "yes",
                                    "-grid_nx", 129, "-grid_ny", 65, "-steady_position", 0.005)
        self.assertIn("shear thinning", run.stdout)
        self.assertLess(summary["shear_factor_min"], 0.96)
        self.run_program("info", BARBIERI, "-output_dir", "info")
        with h5py.File(self.folder / "out/results.h5") as file:
            given = dict(file["parameters"].attrs)
            contact = file["contact0"]
            P, H, x, y = (contact[name][:] for name in ("P", "H", "x", "y"))
            xi = contact.attrs["xi"]
        parameters = {name: float(given[name].split()[0]) for name in ("pinion.teeth", "wheel.teeth", "lubricant.viscosity",
                                                            "lubricant.pressure_viscosity")}
        parameters |= {name: given[name] for name in ("lubricant.viscosity_law", "lubricant.density_law",
                                                   "film.discretisation")}
        equations = FilmEquations(parameters, summary_in(self.folder / "info"), x, y)
        P, H = P / equations.pressure, H / equations.film
        thinning = equations.eyring_thinning(P, H, summary["sliding_velocity"], 8e6)
        inside = P[1:-1, 1:-1] > 0.01
        thin, newtonian = (abs(equations.rows(P, H, xi, thinning=factors)[inside]).max()
                           for factors in (thinning, (1.0, 1.0)))
        self.assertLess(thin, 0.02 * newtonian)

    def test_an_oil_by_measured_rheology_is_cold_and_warm(self):
        squalane = SOURCE / "input/squalane.yaml"
        options = ["-grid_nx", 65, "-grid_ny", 65]
        info = self.summary("info", squalane)[0]
        self.assertAlmostEqual(info["L"], 19.5e-9 * info["E_prime"] * (
            2 * 0.0276 * info["entrainment_velocity"] / (info["E_prime"] * info["R_x"])) ** 0.25, delta=0.01)
        cold = self.summary("steady", squalane, *options)[0]
        warm = self.summary("steady", squalane, *options, "-thermal_model", "film", "-contact_entrainment_velocity", 20,
                            "-contact_sliding_velocity", 5)[0]
        self.assertGreater(cold["friction_coefficient"], 1.5 * warm["friction_coefficient"])
        self.assertLess(warm["thermal_factor"], 0.9)
        for words, change in ((["'lubricant.pressure_viscosity'", "follows"], ["-lubricant_pressure_viscosity", 2e-8]),
                              (["'lubricant.yasutomi_glass_temperature'", "missing"],
                               ["-lubricant_viscosity_law", "yasutomi"]),
                              (["no free volume"], ["-lubricant_doolittle_r0", 0.98, "-thermal_temperature", 250])):
            self.assert_wrong(words, "steady", squalane, *change)

    def test_coulombs_friction_loses_what_the_loss_factor_says(self):
        """One contact with the share 1/n, along the whole line of action: exact but for the quadrature in time."""
        _, _ = self.summary("transient", BARBIERI, *SMALL, "-model", "quasistatic", "-friction_law", "coulomb",
                            "-friction_coefficient", 0.05, "-load_sharing_jump_time", 1e-3)
        with h5py.File(self.folder / "out/results.h5") as file:
            steps = file["history/steps"][:]
        energy = numpy.trapezoid(steps["power_sliding"], steps["t"]) if hasattr(numpy, "trapezoid") else numpy.trapz(
            steps["power_sliding"], steps["t"])
        period = summary_in(self.folder / "out")["mesh_period"]
        self.assertAlmostEqual(energy / period / (0.05 * 0.1002022 * 738274.27), 1, delta=1e-3)

    def test_a_periodic_state_has_losses_and_an_efficiency(self):
        alone, _ = self.summary("periodic", BARBIERI, *SMALL, *HEAT, "-periodic_multipliers", "no",
                                "-friction_in_motion", "yes")
        self.check_energy(alone)
        self.assertAlmostEqual(alone["power_loss"], alone["power_sliding"] + alone["power_rolling"], delta=1e-6)
        self.assertAlmostEqual(alone["efficiency"], 1 - alone["power_loss"] / alone["transmitted_power"], delta=1e-12)
        self.assertAlmostEqual(alone["mean_friction_coefficient"],
                               alone["power_sliding"] / (0.1002022 * alone["transmitted_power"]), delta=1e-6)
        with h5py.File(self.folder / "out/results.h5") as file:
            self.assertLess(FIELDS, set(next(iter(file["snapshots/0000"].values()))))
        for options, status in ((["--at", "-3"], 0), (["--name", "no/folder"], 1)):
            drawn = plot("friction", self.folder / "out", *options)
            self.assertEqual(drawn.returncode, status, drawn.stderr)
        self.assertTrue((self.folder / "out/friction.png").exists())
        together, _ = self.summary("periodic", BARBIERI, *SMALL, *HEAT, "-periodic_multipliers", "no",
                                   "-friction_in_motion", "yes", processes=2)
        for name in ("power_loss", "film_temperature_max", "surface_temperature_pinion_max"):
            self.assertAlmostEqual(together[name] / alone[name], 1, delta=1e-4, msg=name)

    def test_energy_closes_where_asperities_rub_too(self):
        rough, _ = self.summary("periodic", BARBIERI, *SMALL, *HEAT[:2], "-periodic_multipliers", "no",
                                "-friction_in_motion", "yes", "-roughness_model", "stochastic", "-pinion_roughness",
                                1.5e-6, "-wheel_roughness", 1e-6)
        self.check_energy(rough)
        self.assertGreater(table_in(self.folder / "out", "history/contacts")["power_boundary"].max(),
                           0.1 * rough["power_loss"])

    def check_energy(self, summary):
        """What the pinion's torque brings in goes out by the wheel's or is lost; and it is what the case asks for."""
        self.run_program("info", BARBIERI, "-output_dir", "info")
        derived = summary_in(self.folder / "info")
        radii = [derived[f"base_radius_{gear}"] for gear in ("pinion", "wheel")]
        speeds = [15000 * math.pi / 30, 15000 * math.pi / 30 * radii[0] / radii[1]]
        with h5py.File(self.folder / "out/results.h5") as file:
            steps, rows = file["history/steps"][:], file["history/contacts"][:]
            begin, end = (file["history"].attrs[f"periodic_{name}"] for name in ("from", "to"))
        inside = numpy.flatnonzero((steps["T"] > begin - 1e-9) & (steps["T"] < end + 1e-9))
        T = steps["T"][inside]

        def mean(values):
            sums = numpy.bincount(rows["step"].astype(int), weights=values, minlength=len(steps))[inside]
            return (0.5 * (sums[1:] + sums[:-1]) * numpy.diff(T)).sum() / (T[-1] - T[0])

        tangent = math.tan(math.radians(derived["working_pressure_angle_deg"]))
        drags = (-rows["friction_force"] - rows["rolling_force"], rows["friction_force"] - rows["rolling_force"])
        given = speeds[0] * mean(rows["force"] * radii[0] - drags[0] * (radii[0] * tangent + rows["xi"]))
        taken = speeds[1] * mean(rows["force"] * radii[1] + drags[1] * (radii[1] * tangent - rows["xi"]))
        self.assertAlmostEqual((taken + summary["power_loss"]) / given, 1, delta=1e-9)
        # Both gears together are slowed by what is lost; less than half of it is the lighter one's, the pinion's.
        asked = summary["transmitted_power"]
        self.assertAlmostEqual(given / asked, 1, delta=0.5 * summary["power_loss"] / asked)

    def test_a_bare_contact_slides_as_it_is_told(self):
        summary, _ = self.summary("steady", CIRCULAR, "-friction_law", "newtonian", "-contact_sliding_velocity", 0.1,
                                  "-grid_nx", 33, "-grid_ny", 33)
        self.assertGreater(summary["power_sliding"], 0)
        self.assertNotIn("schlenk_mean_friction", summary["predictions"])

    def test_a_film_feels_its_heat(self):
        film = ["-thermal_model", "film", "-steady_position", 0.002, "-grid_nx", 129, "-grid_ny", 65]
        alone, run = self.summary("steady", BARBIERI, *HEAT[:2], *HEAT[4:], *film)
        self.assertIn("thermal factors", run.stdout)
        self.assertNotIn("inlet", run.stderr)
        self.assertAlmostEqual(alone["thermal_factor"], alone["h_central"] / alone["h_central_isothermal"], delta=1e-12)
        self.assertTrue(0.45 < alone["thermal_factor"] < 0.55, alone["thermal_factor"])
        self.assertLess(alone["thermal_factor_min"], 0.4)
        self.assertGreater(alone["h_central_error"], 0)
        with h5py.File(self.folder / "out/results.h5") as file:
            self.assertGreater(file["contact0/log_flow_factor"][:].max(), 10)
        together, _ = self.summary("steady", BARBIERI, *HEAT[:2], *HEAT[4:], *film, processes=2)
        for name in ("h_central", "h_min", "friction_coefficient"):
            self.assertAlmostEqual(together[name] / alone[name], 1, delta=1e-3, msg=name)
        self.assert_wrong(["'thermal.model'", "modes"], "eigen", BARBIERI, *HEAT[:2], *HEAT[4:], "-thermal_model",
                          "film")

    def test_a_periodic_state_of_films_that_feel_their_heat(self):
        heat = [*HEAT[:2], "-thermal_model", "film", *HEAT[4:], "-friction_in_motion", "yes", "-periodic_multipliers", "no"]
        warm, run = self.summary("periodic", BARBIERI, *SMALL, *heat)
        self.assertNotIn("inlet", run.stderr)
        cold, _ = self.summary("periodic", BARBIERI, *SMALL, "-periodic_multipliers", "no", "-friction_law", "eyring")
        self.assertTrue(0.4 < warm["pitch_h_central"] / cold["pitch_h_central"] < 0.6)
        self.assertTrue(0.9965 < warm["efficiency"] < 0.9985, warm["efficiency"])

    def test_wrong_input_is_named_in_one_line(self):
        heat = ["-thermal_model", "friction", "-friction_law", "eyring"]
        for words, options in (
                (["'friction.law'", "none"], ["-thermal_model", "friction"]),
                (["'lubricant.temperature_viscosity'", "missing"], heat),
                (["'friction.coefficient'", "missing"], ["-friction_law", "coulomb"]),
                (["'friction.in_film'", "none"], ["-friction_in_film", "yes"]),
                (["'friction.in_film'", "Coulomb"],
                 ["-friction_law", "coulomb", "-friction_coefficient", 0.1, "-friction_in_film", "yes"]),
                (["'thermal.temperature'", "200"], [*heat, "-thermal_temperature", -5]),
                (["'thermal.points'", "odd"], [*heat, "-thermal_points", 16]),
                (["'friction.law'", "sinh"], ["-friction_law", "sinh"])):
            with self.subTest(options=options):
                self.assert_wrong(words, "steady", BARBIERI, *options)
        self.assert_wrong(["'friction.in_motion'", "none"], "transient", BARBIERI, "-friction_in_motion", "yes")
        self.assert_wrong(["'friction.in_film'", "Newtonian"], "eigen", BARBIERI, "-friction_law", "eyring",
                          "-friction_in_film", "yes")
        self.assert_wrong(["'friction.in_motion'", "dynamic"], "transient", BARBIERI, "-friction_in_motion", "yes",
                          "-friction_law", "eyring", "-model", "dry")
        self.assert_wrong(["'contact.sliding_velocity'", "twice"], "steady", CIRCULAR, "-friction_law", "eyring",
                          "-contact_sliding_velocity", 1e4)


if __name__ == "__main__":
    unittest.main()
