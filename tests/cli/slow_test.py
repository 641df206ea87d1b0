"""Fine grids of tests/reference/table3.json, and periodic states; environment as for cli_test.py."""
import json
import unittest

import h5py
import numpy

from films import BARBIERI, CIRCULAR, REFERENCE, WANG, FilmTest, summary_in
from program import SOURCE
from vibration import MARCH, VibrationTest, table_in


class FineGrids(FilmTest):
    def test_fine_rows_of_table_3(self):
        for row in REFERENCE["steady_pitch"][1:]:
            for processes in (1, 2):
                with self.subTest(nx=row["nx"], ny=row["ny"], processes=processes):
                    self.assert_row(BARBIERI, row, processes=processes)

    def test_fine_circular_contact(self):
        for row in REFERENCE["steady_circular_M20_L10"][1:]:
            self.assert_row(CIRCULAR, row, processes=2, load=5.746)

    def test_fine_wang_pair(self):
        for row in REFERENCE["table2_pitch"][1:]:
            self.assert_row(WANG, row, processes=2)


class Periodic(VibrationTest):
    def test_periodic_state_is_the_same_on_1_and_2_processes(self):
        summaries = []
        for processes in (1, 2):
            self.run_well("periodic", BARBIERI, *MARCH, "-output_dir", "periodic", processes=processes)
            summaries.append(summary_in(self.folder / "periodic"))
            with self.subTest(processes=processes):
                self.assert_results_are_of_one_period(summaries[-1])
        alone, shared = summaries
        for name in ("H0_after_leaving", "force_ratio_max", "p_max", "floquet_modulus", "free_frequency"):
            self.assertAlmostEqual(shared[name] / alone[name], 1, delta=1e-4, msg=name)

    def assert_results_are_of_one_period(self, summary):
        self.assertTrue(summary["completed"])
        self.assertTrue(summary["stable"])
        self.assertLess(summary["defect"], 1e-4)
        mesh_frequency = 7000.0
        steps = table_in(self.folder / "periodic", "history/steps")
        with h5py.File(self.folder / "periodic/results.h5") as results:
            begin, end = (results["history"].attrs[f"periodic_{name}"] for name in ("from", "to"))
            times = [snapshot.attrs["T"] for snapshot in results["snapshots"].values()]
            for snapshot in results["snapshots"].values():
                for contact in snapshot.values():
                    self.assertEqual(contact["P"].shape, (65, 33))
                    self.assertLess(contact["P"][:].max(), summary["p_max"] * (1 + 1e-12))
                    self.assertGreater(contact["H"][:].min(), summary["h_min"] * (1 - 1e-12))
        # One a twentieth of a mesh period, at the first time step from there on; the last at the end of the period.
        self.assertEqual(len(times), 20)
        lateness = times - numpy.linspace(begin, end, 21)[1:]
        self.assertGreater(lateness.min(), -1e-6)
        self.assertLess(lateness.max(), summary["dT"])
        lines = table_in(self.folder / "periodic", "spectrum")
        numpy.testing.assert_allclose(lines["frequency"], mesh_frequency * numpy.arange(len(lines)), rtol=1e-9)
        peaks = summary["spectrum_peaks"]
        self.assertAlmostEqual(peaks[0]["frequency"] / mesh_frequency, 1, delta=1e-9)
        for peak in peaks:
            multiple = peak["frequency"] / mesh_frequency
            self.assertAlmostEqual(multiple, round(multiple), delta=1e-9)
        # The last of several states at one time counts.
        first, last = (steps["H0"][numpy.flatnonzero(steps["T"] <= T + 1e-9)[-1]] for T in (begin, end))
        self.assertAlmostEqual(first, summary["H0_after_leaving"], delta=1e-12)
        self.assertAlmostEqual(last, first, delta=summary["defect"])


class Flanks(FilmTest):
    def test_dang_van_stress_of_the_case_study_is_that_of_the_reference(self):
        reference = json.loads((SOURCE / "tests/reference/damage.json").read_text(encoding="utf-8"))
        self.run_well("periodic", BARBIERI, "-friction_law", "eyring", "-periodic_multipliers", "no", "-output_snapshot_interval",
                      0, "-grid_ny", 33, "-film_discretisation", "central", "-stress_model", "row", "-fatigue_criterion",
                      "dang_van", "-output_dir", "study")
        summary = summary_in(self.folder / "study")
        expected = reference["per1_dv_alpha.3_pinion_max_MPa"]["value"]
        self.assertAlmostEqual(summary["dang_van_max_pinion"] / 1e6 / expected, 1, delta=0.03)
        # Where no limit is given there is no verdict.
        self.assertIsNone(summary["safety_dang_van_pinion"])
        # The resonance unloads the middle of the flank: 1.5 against frozen fields.
        self.assertGreater(summary["life_ratio"], 1)
        self.assertLess(summary["life_ratio"], 1.5)


if __name__ == "__main__":
    unittest.main()
