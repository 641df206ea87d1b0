"""Films over a whole face, and line contacts, from outside.

The numbers are those of a program of its own, of the central discretisation: a contact without crowning, R_x 9 mm, face
14 mm, 4000 N, E' 226.3736 GPa, 0.04 Pa s, 2.2e-8 1/Pa, 10 m/s, from -3 to 1.5 a. Environment as for cli_test.py.
"""
import math
import sys
import unittest

import h5py
import numpy

from films import BALANCE, BARBIERI, SAME, summary_in
from program import RESULT_FILES, SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "scripts"))
from gearfilm.drawing import face  # noqa: E402
from gearfilm.folder import Film, Parameter  # noqa: E402

FIVE_DIGITS = 5e-5
CONTACT = """
case: {name: face, kind: contact}
contact:
  radius_x: 9e-3
  face_width: 14e-3
  load: 4000
  entrainment_velocity: 10
  reduced_modulus: 226.3736e9
lubricant: {viscosity: 0.04, pressure_viscosity: 2.2e-8}
grid: {x_min: -3, x_max: 1.5, largest_row: 2.5}
film: {discretisation: central}
"""
LINE = CONTACT.replace("kind: contact", "kind: line").replace("load: 4000", "line_load: 285714.2857").replace(
    "  face_width: 14e-3\n", "")
RELIEVED = ["-contact_end_relief", "10e-6", "-contact_end_relief_length", "3e-3"]
HALF_SPACE = ["-contact_end_face", "half_space"]


def history_in(folder):
    with h5py.File(folder / "results.h5") as results:
        return results["history/steps"][()]


class FaceTest(ProgramTest):
    def steady(self, text, *options, processes=1):
        """Summary of a film of a case."""
        case = self.write_case(text)
        self.run_well("steady", case, "-output_dir", "film", *options, processes=processes)
        return summary_in(self.folder / "film")

    def assert_near(self, computed, expected, tolerance, what=""):
        self.assertLess(abs(computed / expected - 1), tolerance, f"{what}: {computed}, expected {expected}")


class Faces(FaceTest):
    def test_relieved_ends_are_those_of_the_reference(self):
        summary = self.steady(CONTACT, *RELIEVED, *HALF_SPACE, "-grid_nx", 129)
        self.assertEqual((summary["nx"], summary["ny"]), (129, 77))
        self.assert_near(summary["h_central"], 1.27808e-6, FIVE_DIGITS)
        self.assert_near(summary["h_min"], 1.11339e-6, FIVE_DIGITS)
        self.assert_near(summary["approach"], 8.64191e-6, FIVE_DIGITS)
        self.assert_near(summary["force"], 4000, BALANCE)
        self.assertEqual(summary["tilting_moment"], 0)
        # 0.399 u_m a^2/R_x a on twice as many lines; the outermost row passes all of it.
        self.assert_near(summary["side_flow_upper"], 0.399 * 10 * 3.2140e-6 * 170.077e-6, 0.02)
        self.assertEqual(summary["side_flow_lower"], summary["side_flow_upper"])
        # Where the relief begins, 4 mm from the middle.
        self.assert_near(abs(summary["h_min_y"]), 4.2175e-3, 1e-3)
        fitted = self.steady(CONTACT, *RELIEVED, *HALF_SPACE, "-grid_nx", 129, "-film_discretisation", "fitted")
        # What the reference's finest grids tend to: fitted films are nearer.
        for name, limit in (("h_central", 1.2862e-6), ("h_min", 1.1274e-6)):
            self.assertLess(abs(fitted[name] - limit), fitted[f"{name}_error"], name)
            self.assertLess(abs(fitted[name] - limit), 0.2 * abs(summary[name] - limit), name)
        self.assert_near(fitted["h_central"], 1.28646e-6, FIVE_DIGITS)  # as it was when the test was written
        self.assert_near(fitted["h_min"], 1.12831e-6, FIVE_DIGITS)

    def test_a_misaligned_face_is_that_of_the_reference_on_one_process_and_two(self):
        options = [*RELIEVED, *HALF_SPACE, "-contact_misalignment", "10e-6", "-grid_nx", 65]
        alone = self.steady(CONTACT, *options)
        self.assert_near(alone["h_min"], 0.72848e-6, 1e-3)  # rows differ a little
        self.assert_near(alone["h_central"], 1.26156e-6, 1e-4)  # between two lines, there at the nearer one
        self.assert_near(alone["tilting_moment"], -6.22015, FIVE_DIGITS)
        self.assertAlmostEqual(alone["h_min_y"], -7e-3, delta=1e-12)
        self.assertGreater(alone["side_flow_upper"], 1.5 * alone["side_flow_lower"])
        together = self.steady(CONTACT, *options, processes=2)
        self.assertEqual(together["provenance"]["processes"], 2)
        for name in ("h_central", "h_min", "p_max", "approach", "tilting_moment", "side_flow_upper", "side_flow_lower",
                     "h_min_y", "p_max_y"):
            self.assert_near(together[name], alone[name], SAME, name)

    def test_a_misaligned_face_has_the_temperatures_of_its_middle_on_any_process(self):
        across = []
        for processes in (1, 2):
            self.run_well("steady", SOURCE / "input/misaligned.yaml", "-friction_law", "eyring", "-thermal_model", "film",
                          "-lubricant_temperature_viscosity", 0.04, "-grid_nx", 65, "-grid_largest_row", 8,
                          "-solver_processes", "all", "-output_dir", f"film{processes}", processes=processes)
            with h5py.File(self.folder / f"film{processes}/results.h5") as results:
                across.append(results["contact0/temperature_across"][()])
        numpy.testing.assert_allclose(across[1], across[0], rtol=1e-6)
        self.assertGreater(across[0].max(), across[0].min() + 0.1)

    def test_rows_of_the_face_are_stored(self):
        summary = self.steady(CONTACT, *RELIEVED, *HALF_SPACE, "-contact_misalignment", "10e-6", "-grid_nx", 65)
        self.assertEqual({path.name for path in (self.folder / "film").iterdir()}, RESULT_FILES)
        with h5py.File(self.folder / "film/results.h5") as results:
            group = results["contact0"]
            y = group["y"][:]
            films, pressures = group["H"][:], group["P"][:]
            line_load, smallest, largest, central = (
                group[name][:, 0] for name in ("line_load", "h_min_of_row", "p_max_of_row", "h_central_of_row"))
            units = [group[name].attrs["unit"] for name in ("line_load", "h_min_of_row", "p_max_of_row")]
        self.assertEqual(units, ["N/m", "m", "Pa"])
        # Rows stand for the strips half-way to their neighbours.
        loads = numpy.gradient(y) * line_load
        self.assert_near(numpy.sum(loads[1:-1]), 4000, BALANCE)
        self.assert_near(numpy.sum((loads * y)[1:-1]), summary["tilting_moment"], BALANCE)
        self.assertEqual((line_load[0], line_load[-1]), (0, 0))
        self.assertAlmostEqual(smallest.min(), summary["h_min"], delta=1e-15)
        self.assertAlmostEqual(largest.max(), summary["p_max"], delta=1)
        self.assertAlmostEqual(central[numpy.argmin(abs(y))], summary["h_central"], delta=1e-15)
        numpy.testing.assert_allclose(smallest, films.min(axis=0), rtol=1e-12)
        numpy.testing.assert_allclose(largest, pressures.max(axis=0), rtol=1e-12)

    def test_a_contact_that_ends_in_a_relief_has_its_smallest_film_where_pressure_is_largest(self):
        self.run_well("steady", SOURCE / "input/misaligned.yaml", "-grid_nx", 97, "-output_dir", "film")
        summary = summary_in(self.folder / "film")
        # 0.1378 um on 161 x 143 nodes, 3.5 mm from the middle; the load ends 5.8 mm from it, on the other side.
        self.assertLess(abs(summary["h_min"] - 0.1378e-6), summary["h_min_error"])
        self.assertLess(summary["h_min_error"], 0.1 * summary["h_min"])
        self.assertLess(abs(summary["h_min_y"] + 3.5e-3), 0.5e-3)

    def test_thick_oil_between_misaligned_flanks_has_a_film(self):
        run = self.run_program("steady", SOURCE / "input/misaligned.yaml", "-lubricant_viscosity", 0.3,
                               "-lubricant_pressure_viscosity", 3e-8, "-pinion_speed_rpm", 4500, "-pinion_torque", 100,
                               "-grid_nx", 41, "-output_dir", "film")
        self.assertEqual(run.status, 0, run)
        summary = summary_in(self.folder / "film")
        self.assert_near(summary["h_min"], 4.0e-6, 0.05)

    def test_oil_that_an_entering_contact_presses_is_on_the_grid(self):
        def entering(folder, *options):
            run = self.run_program("transient", SOURCE / "input/misaligned.yaml", "-lubricant_viscosity", 0.3,
                                   "-lubricant_pressure_viscosity", 2e-8, "-pinion_speed_rpm", 4500, "-pinion_torque",
                                   30, "-grid_largest_row", 20, "-mesh_periods", 0.33, "-output_dir", folder, *options)
            self.assertEqual(run.status, 0, run)
            with h5py.File(self.folder / folder / "results.h5") as results:
                contacts = results["history/contacts"][()]
            return contacts[contacts["contact"] == 1]

        chosen, longer = entering("chosen"), entering("longer", "-grid_x_max", 30)
        self.assertLess(summary_in(self.folder / "chosen")["nx"], 200)  # pressure rises over 2.9 a
        # 11 % less behind an outlet at 1.25 a.
        self.assert_near(chosen["force"][-1], numpy.interp(chosen["T"][-1], longer["T"], longer["force"]), 3e-3)

    def test_free_ends_hold_a_film_that_the_half_space_does_not(self):
        free = self.steady(CONTACT, "-grid_nx", 33, "-grid_first_row", 0.06)
        corner = free["h_corner"]
        self.assert_near(free["tilting_stiffness"], 9096.5, 1e-2)  # of a dry contact on finer rows
        mirrored = self.steady(CONTACT, "-grid_nx", 33, "-grid_first_row", 0.06, "-contact_end_face",
                               "mirror")["h_corner"]
        self.assertGreater(corner, 0.3e-6)
        self.assertGreater(mirrored, 1.2 * corner)
        run = self.run_program("steady", self.write_case(CONTACT), "-output_dir", "none", *HALF_SPACE, "-grid_nx", 33)
        self.assert_message(run, 2, "gearfilm: not solved: ", ["end_face", "relief"])
        self.assertFalse(list((self.folder / "none").iterdir()))

    def test_a_march_whose_load_comes_to_the_ends_begins_again_over_the_whole_face(self):
        # The radii of the case study on a narrow face: its ends are reached under half as much force again.
        narrow = ["transient", BARBIERI, "-gear_face_width", 8e-3, "-pinion_crowning", 0.02096e-3, "-wheel_crowning",
                  0.02096e-3, "-grid_nx", 65, "-time_dt", 0.1]
        whole = self.run_program(*narrow, "-grid_whole_face", "yes", "-output_dir", "asked")
        self.assertEqual(whole.status, 0, whole)
        self.run_well(*narrow, "-mesh_periods", 1.2, "-keep_checkpoint", "-output_dir", "chosen")
        run = self.run_well(*narrow, "-restart", "-keep_checkpoint", "-output_dir", "chosen")
        self.assertIn("the march begins again with films over the whole face", run.stdout)
        asked, chosen = (history_in(self.folder / name) for name in ("asked", "chosen"))
        numpy.testing.assert_array_equal(chosen["H0"], asked["H0"])
        # There it also goes on.
        self.run_well(*narrow, "-mesh_periods", 2.1, "-restart", "-output_dir", "chosen")
        numpy.testing.assert_array_equal(history_in(self.folder / "chosen")["H0"][:len(asked)], asked["H0"])

    def test_a_crowned_contact_within_its_face_does_not_know_it(self):
        crowned = CONTACT.replace("load: 4000", "load: 400\n  radius_y: 0.1")
        endless = self.steady(crowned.replace("  face_width: 14e-3\n", ""), "-grid_nx", 33, "-grid_ny", 17)
        within = self.steady(crowned.replace("radius_y", "crowning_radius"), "-grid_nx", 33, "-grid_ny", 17)
        for summary in (endless, within):
            summary.pop("provenance")
        self.assertEqual(endless, within)
        self.assertNotIn("h_min_y", within)
        # Loaded as a whole where it slopes, or where its ellipse comes within a tenth of the ends.
        case = self.write_case(crowned)
        self.run_well("info", case, "-output_dir", "info")
        half_length = summary_in(self.folder / "info")["b"]
        for name, options, whole in (("wide", ["-contact_face_width", 2.3 * half_length], False),
                                     ("narrow", ["-contact_face_width", 2.1 * half_length], True),
                                     ("sloping", ["-contact_misalignment", 1e-7], True)):
            self.run_well("info", case, "-output_dir", name, *options)
            self.assertEqual("moes_line_h_central" in summary_in(self.folder / name), whole, name)


class Lines(FaceTest):
    def test_line_contacts_are_those_of_the_reference(self):
        for x_min, central, smallest in ((-3, 1.30953e-6, 1.16738e-6), (-4.5, 1.37263e-6, 1.21319e-6),
                                         (-9, 1.39427e-6, 1.2266e-6)):
            with self.subTest(x_min=x_min):
                summary = self.steady(LINE, "-grid_nx", 513, "-grid_x_min", x_min)
                self.assertEqual(summary["ny"], 1)
                self.assert_near(summary["h_central"], central, FIVE_DIGITS)
                self.assert_near(summary["h_min"], smallest, FIVE_DIGITS)
                self.assert_near(summary["force"], 285714.2857, BALANCE)
                self.assertNotIn("tilting_moment", summary)

    def test_a_line_contact_needs_one_process(self):
        case = self.write_case(LINE)
        run = self.run_program("steady", case, "-output_dir", "film", "-grid_nx", 65, processes=2)
        self.assert_message(run, 1, "gearfilm: wrong input: ", ["ny = 1", "one process"])
        self.assertEqual(self.content(), ["case.yaml"])

    def test_info_gives_the_groups_of_the_line_load(self):
        known = {}
        for name, text in (("line", LINE), ("face", CONTACT)):
            run = self.run_well("info", self.write_case(text), "-output_dir", name)
            known[name] = summary_in(self.folder / name)
            self.assertIn("moes_line_h_central", run.stdout)
            # w'/(E' R_x) s^(-1/2), s = 2 eta_0 u_m/(E' R_x)
            stiffness = 226.3736e9 * 9e-3
            group = 4000 / 14e-3 / stiffness / (2 * 0.04 * 10 / stiffness) ** 0.5
            self.assert_near(known[name]["M"], group, 1e-9, name)
            self.assert_near(known[name]["p_hertz"], 1069.47e6, 1e-5)
            self.assert_near(known[name]["moes_line_h_central"], 1.3375e-6, FIVE_DIGITS)
        self.assertEqual(known["face"]["b"], 7e-3)
        self.assertNotIn("b", known["line"])


class Figure(unittest.TestCase):
    def test_rows_have_their_loads(self):
        x, y = numpy.linspace(-0.2, 0.2, 401), numpy.array([-7.0, -2.0, 1.0, 7.0])
        ellipse = numpy.sqrt(numpy.maximum(1 - (x / 0.1) ** 2, 0))[:, None]

        def film(xi, pressure):
            across = numpy.where(abs(y) < 7, pressure, 0)
            return Film(contact=0, xi=xi, time=0, x=x, y=y, thickness=0.1 + 0 * ellipse * across, pressure=ellipse * across)

        # A semi-ellipse of 1 GPa and the half-width 0.1 mm carries 50 pi N/mm.
        numpy.testing.assert_allclose(face.rows_of(film(-3.0, 1.0), y).line_load, [0, 50 * math.pi, 50 * math.pi, 0], rtol=2e-3)
        numpy.testing.assert_allclose(face.rows_of(film(2.0, 1.5), y).pressure, [0, 1.5, 1.5, 0])

    def test_roll_angle_of_the_pitch_point_is_the_tangent_of_the_working_pressure_angle(self):
        base_radius, angles = 36 * math.cos(math.radians(20)), numpy.radians([20.0, 21.0])
        rho = base_radius * numpy.tan(angles)
        numpy.testing.assert_allclose(face.roll_angles({"s": rho**2 / (2 * base_radius), "rho": rho}),
                                      numpy.degrees(numpy.tan(angles)), rtol=1e-12)


if __name__ == "__main__":
    unittest.main()
