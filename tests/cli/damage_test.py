"""Stresses below films from outside, against the numbers of tests/reference/damage.json. Environment as for
cli_test.py."""
import json
import unittest

import h5py
import numpy

from films import BARBIERI, SAME, summary_in
from program import INPUT, SOURCE
from restarts import RestartTest

REFERENCE = json.loads((SOURCE / "tests/reference/damage.json").read_text(encoding="utf-8"))
# The film of the reference's steady numbers, whose discretisation is the paper's.
STUDY = ["-steady_position", "4e-3", "-friction_law", "eyring", "-pinion_speed_rpm", 6000, "-grid_nx", 129, "-grid_ny", 33,
         "-film_discretisation", "central"]
COARSE = ["-steady_position", "4e-3", "-friction_law", "eyring", "-grid_nx", 65, "-grid_ny", 17]
OF_STRESS = ("von_mises_max", "von_mises_depth", "shear_max", "shear_depth", "orthogonal_shear", "orthogonal_shear_depth",
             "surface_tension")


def reference(name):
    return REFERENCE[name]["value"]


class DamageTest(RestartTest):
    def steady(self, *options, case=BARBIERI, processes=1, name="film"):
        self.run_well("steady", case, "-output_dir", name, *options, processes=processes)
        return summary_in(self.folder / name)

    def section(self, name="film"):
        with h5py.File(self.folder / name / "results.h5") as file:
            return {key: values[()] for key, values in file["contact0/section"].items()}


class Steady(DamageTest):
    def test_stresses_are_those_of_the_reference(self):
        film = self.steady(*STUDY, "-stress_model", "row")
        self.assertAlmostEqual(film["von_mises_max_pinion"] / 1e6 / reference("ehl_steady_von_mises_max_MPa"), 1, delta=5e-3)
        self.assertAlmostEqual(
            film["orthogonal_shear_pinion"] / 1e6 / reference("ehl_steady_orthogonal_amplitude_max_MPa"), 1, delta=5e-3)

    def test_the_section_has_what_the_summary_says(self):
        film = self.steady(*COARSE, "-stress_model", "row")
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


if __name__ == "__main__":
    unittest.main()
