"""The program from outside: commands, results, exit statuses and messages.

Environment: GEARFILM, the binary; GEARFILM_MPIEXEC, the launcher with its process flag ("mpiexec -n").
"""
import os
import re
import shutil
import unittest
import xml.etree.ElementTree

import h5py
import numpy

from films import BALANCE, BARBIERI, CIRCULAR, REFERENCE, WANG, FilmTest, summary_in
from program import INPUT, RESULT_FILES, SOURCE, ProgramTest
from vibration import COARSE, MARCH, SAME_ORBIT, VibrationTest, barbieri_with_inertias, table_in

# Films of 1, 2 and 4 processes differ by 5e-12 where all take the same path of Newton steps, and by what Newton's
# tolerance of 1e-8 leaves where the sequence of grids, which depends on the number of processes, makes them differ.
SAME = 1e-6


def text(attribute):
    return attribute.decode() if isinstance(attribute, bytes) else attribute


class Info(ProgramTest):
    def test_derived_quantities_are_those_of_table_3(self):
        for processes in (1, 2):
            with self.subTest(processes=processes):
                run = self.run_well("info", BARBIERI, processes=processes)
                summary = summary_in(self.folder / "output/barbieri2013")
                for name, wanted in REFERENCE["derived"].items():
                    self.assertAlmostEqual(summary[name] / wanted["value"], 1, delta=wanted["rel_tol"], msg=name)
                    self.assertEqual(len(re.findall(rf"^{name} ", run.stdout, re.MULTILINE)), 1, name)
                self.assertEqual(os.listdir(self.folder / "output/barbieri2013"), ["summary.json"])

    def test_bare_contact_has_its_moes_groups_and_no_gears(self):
        self.run_well("info", CIRCULAR)
        summary = summary_in(self.folder / "output/circular_m20_l10")
        # Load and velocity of the case have four digits.
        self.assertAlmostEqual(summary["M"] / 20, 1, delta=1e-3)
        self.assertAlmostEqual(summary["L"] / 10, 1, delta=1e-3)
        self.assertAlmostEqual(summary["kappa"], 1, delta=1e-12)
        for name in ("contact_ratio", "f_m", "f_n", "I_n"):
            self.assertNotIn(name, summary)

    def test_pair_without_mass_has_no_natural_frequency(self):
        self.run_well("info", WANG)
        summary = summary_in(self.folder / "output/wang2004")
        self.assertIn("f_m", summary)
        self.assertNotIn("f_n", summary)


class Steady(FilmTest):
    def test_table_3_pitch_film_is_the_same_on_1_2_4_processes(self):
        row = REFERENCE["steady_pitch"][0]
        self.assertEqual((row["nx"], row["ny"]), (129, 65))
        fields = {}
        for processes in (1, 2, 4):
            self.assert_row(BARBIERI, row, processes=processes)
            with h5py.File(self.folder / "row/results.h5") as results:
                fields[processes] = {name: results["contact0"][name][:] for name in ("P", "H", "x", "y", "mesh")}
        for processes in (2, 4):
            for name, alone in fields[1].items():
                difference = numpy.abs(fields[processes][name] - alone).max()
                self.assertLessEqual(difference, SAME * numpy.abs(alone).max(), f"{name} on {processes} processes")
            # The film itself is a thirtieth of the largest H, at the inlet corner: compared node by node too.
            films = fields[processes]["H"] / fields[1]["H"]
            self.assertLessEqual(numpy.abs(films - 1).max(), SAME, f"H on {processes} processes")

    def test_circular_contact(self):
        self.assert_row(CIRCULAR, REFERENCE["steady_circular_M20_L10"][0], load=5.746)

    def test_wang_pair_under_its_equivalent_point_load(self):
        summary = self.assert_row(WANG, REFERENCE["table2_pitch"][0])
        # Eq. (27): 493.6 N, printed to that many digits.
        self.assertAlmostEqual(summary["force"], 493.6, delta=0.05)

    def test_film_grows_towards_the_exit_where_radius_and_velocity_grow(self):
        films = []
        for position in ("-5e-3", "0", "5e-3"):
            self.run_well("steady", BARBIERI, "-steady_position", position, "-grid_nx", 65, "-grid_ny", 33)
            summary = summary_in(self.folder / "output/barbieri2013")
            self.assertEqual(summary["position"], float(position))
            films.append(summary["h_central"])
        self.assertEqual(films, sorted(films))

    def test_arithmetic_of_the_preconditioner_does_not_change_the_film(self):
        films = []
        for precision in ("single", "double"):
            self.run_well("steady", CIRCULAR, "-solver_precision", precision, "-output_dir", precision)
            films.append(summary_in(self.folder / precision)["h_min"])
        self.assertAlmostEqual(films[0] / films[1], 1, delta=SAME)


class Results(ProgramTest):
    def setUp(self):
        super().setUp()
        self.output = self.folder / "output/barbieri2013"

    def test_results_carry_program_parameters_and_units(self):
        self.run_well("steady", BARBIERI)
        version = self.run_well("-version").stdout.split()[1]
        required = re.findall(r"^\| `((?:pinion|wheel|gear|lubricant)\.\w+)` .*\| (?:required|default [^|]*) \|",
                              self.run_well("parameters").stdout, re.MULTILINE)
        self.assertGreater(len(required), 15)
        with h5py.File(self.output / "results.h5") as results:
            self.assertEqual(text(results.attrs["program"]), "gearfilm")
            self.assertEqual(text(results.attrs["version"]), version)
            self.assertEqual(text(results.attrs["command"]), "steady")
            parameters = {name: text(value) for name, value in results["parameters"].attrs.items()}
            for name in required:
                self.assertIn(name, parameters)
            self.assertEqual(parameters["pinion.teeth"], "28")
            self.assertEqual(parameters["gear.module"], "0.003 m")
            self.assertEqual(parameters["lubricant.viscosity"], "0.04 Pa s")
            self.assertEqual(parameters["grid.nx"], "129")
            units = {name: text(data.attrs["unit"]) for name, data in results["contact0"].items()}
            self.assertEqual(units, {"P": "Pa", "H": "m", "x": "m", "y": "m", "mesh": "m"})

    def test_fields_agree_with_the_summary(self):
        self.run_well("steady", BARBIERI)
        summary = summary_in(self.output)
        with h5py.File(self.output / "results.h5") as results:
            contact = results["contact0"]
            x, y, pressure, film, mesh = (contact[name][:] for name in ("x", "y", "P", "H", "mesh"))
            a, b = contact.attrs["a"], contact.attrs["b"]
        self.assertEqual(pressure.shape, (129, 65))
        self.assertEqual(film.shape, (129, 65))
        # The paper's domain for M >= 200.
        numpy.testing.assert_allclose((x[0], x[-1], y[0], y[-1]), (-2.083 * a, 1.25 * a, -1.1 * b, 1.1 * b), rtol=1e-12)
        numpy.testing.assert_array_equal(mesh, numpy.stack(numpy.meshgrid(x, y, indexing="ij"), axis=-1))
        for field in (pressure, film):
            numpy.testing.assert_array_equal(field, field[:, ::-1])  # one half is computed
        for edge in (pressure[0], pressure[-1], pressure[:, 0], pressure[:, -1]):
            self.assertLess(numpy.abs(edge).max(), 1e-9 * pressure.max())
        self.assertGreater(pressure.min(), -1e-9 * pressure.max())
        self.assertEqual(pressure.max(), summary["p_max"])
        self.assertEqual(film.min(), summary["h_min"])
        self.assertEqual(film[abs(x).argmin(), 32], summary["h_central"])
        carried = pressure.sum() * (x[1] - x[0]) * (y[1] - y[0])
        self.assertAlmostEqual(carried / summary["force"], 1, delta=BALANCE)

    def test_xdmf_is_well_formed_and_its_references_resolve(self):
        for processes in (1, 2):
            self.run_well("steady", CIRCULAR, "-output_dir", "x", "-grid_nx", 33, "-grid_ny", 41, processes=processes)
            root = xml.etree.ElementTree.parse(self.folder / "x/results.xmf").getroot()
            self.assertEqual(root.tag, "Xdmf")
            topology = root.find(".//Topology")
            self.assertEqual(topology.get("Dimensions"), "33 41")
            attributes = [item.get("Name") for item in root.iter("Attribute")]
            self.assertEqual(attributes, ["P", "H"])
            items = list(root.iter("DataItem"))
            self.assertEqual(len(items), 3)
            for item in items:
                name, dataset = item.text.strip().split(":")
                with h5py.File(self.folder / "x" / name) as results:
                    self.assertEqual(" ".join(map(str, results[dataset].shape)), item.get("Dimensions"))
                    self.assertEqual(results[dataset].dtype.itemsize, int(item.get("Precision")))

    def test_a_second_run_replaces_the_results(self):
        for nx in (33, 65):
            self.run_well("steady", CIRCULAR, "-output_dir", "again", "-grid_nx", nx, "-grid_ny", 33)
            with h5py.File(self.folder / "again/results.h5") as results:
                self.assertEqual(results["contact0/P"].shape, (nx, 33))
            self.assertEqual(summary_in(self.folder / "again")["nx"], nx)
            self.assertEqual(set(os.listdir(self.folder / "again")), RESULT_FILES)

    def test_two_runs_give_the_same_bits(self):
        fields = []
        for folder in ("once", "again"):
            self.run_well("steady", BARBIERI, "-grid_ny", 129, "-output_dir", folder, processes=2)
            with h5py.File(self.folder / folder / "results.h5") as results:
                fields.append([results["contact0"][name][:] for name in ("P", "H")])
        numpy.testing.assert_array_equal(*fields)

    def test_command_line_overrides_the_case_file(self):
        options = ["-grid_nx", 33, "-grid_ny", 35, "-contact_load", "7", "-output_dir", "deep/down"]
        self.run_well("steady", CIRCULAR, *options)
        summary = summary_in(self.folder / "deep/down")
        self.assertEqual((summary["nx"], summary["ny"]), (33, 35))
        self.assertAlmostEqual(summary["force"] / 7, 1, delta=BALANCE)
        with h5py.File(self.folder / "deep/down/results.h5") as results:
            self.assertEqual(text(results["parameters"].attrs["contact.load"]), "7 N")
        self.assertFalse((self.folder / "output").exists())


class NotSolved(ProgramTest):
    """Exit status 2: the message names contact, position and remedy, and nothing that looks like a result is left."""

    def assert_not_solved(self, words, *options):
        for processes in (1, 2):
            with self.subTest(options=options, processes=processes):
                run = self.run_program("steady", BARBIERI, *options, processes=processes)
                self.assert_message(run, 2, "gearfilm: not solved: ", words)
                self.assertEqual([path.name for path in self.folder.rglob("*") if path.is_file()], [])

    def test_domain_too_narrow_for_the_load(self):
        # The ellipse grows with the cube root of the load: 2^(1/3) = 1.26 > 1.05.
        self.assert_not_solved(["contact 0", "xi = 0 mm", "side edge", "1.05", "1.2599", "grid_y_half"],
                               "-grid_y_half", 1.05, "-steady_load_ratio", 2)

    def test_outlet_too_near_for_the_load(self):
        self.assert_not_solved(["contact 0", "xi = 2 mm", "outlet edge", "grid_x_max"], "-grid_x_max", 1.05,
                               "-grid_y_half", 2, "-steady_load_ratio", 2, "-steady_position", 2e-3)

    def test_newton_stopped_before_convergence(self):
        self.assert_not_solved(["contact 0", "xi = 0 mm", "not converged", "solver_newton_max_iterations"],
                               "-solver_newton_max_iterations", 1)

    def test_grid_too_coarse_for_a_positive_film(self):
        self.assert_not_solved(["contact 0", "xi = 0 mm", "not positive", "grid_nx"], "-grid_nx", 17, "-grid_ny", 9)


class Eigen(VibrationTest):
    def test_pair_swings_at_its_natural_frequencies_on_1_and_2_processes(self):
        alone, shared = (self.eigen(processes=processes) for processes in (1, 2))
        for summary in (alone, shared):
            # Table 3 of the paper, and the mode in which the gears turn against each other: what the tooth force gives
            # to one it takes from the other, I_1 phi_1/R_b1 = -I_2 phi_2/R_b2. In the rigid mode they turn as geared.
            self.assertAlmostEqual(summary["f_n"] / 5138.8, 1, delta=1e-3)
            self.assertLess(summary["rigid_frequency"], 1e-3 * summary["f_n"])
            self.run_well("info", BARBIERI)
            derived = summary_in(self.folder / "output/barbieri2013")
            pinion, wheel = (summary[f"inertia_{gear}"] / derived[f"base_radius_{gear}"]
                             for gear in ("pinion", "wheel"))
            swinging, rigid = summary["mode_shape"], summary["rigid_mode_shape"]
            self.assertAlmostEqual(pinion * swinging[0] / (wheel * swinging[1]), -1, delta=1e-9)
            self.assertAlmostEqual(rigid[1] / rigid[0] / (28 / 43), 1, delta=1e-9)
            self.assertEqual(summary["contacts"], 1)
        for name in ("film_frequency", "film_damping_ratio"):
            self.assertGreater(alone[name], 0)
            self.assertAlmostEqual(shared[name] / alone[name], 1, delta=SAME, msg=name)
        # As many as eigen.modes asks for, however many SLEPc has found beyond them.
        for summary in (alone, shared):
            self.assertEqual(len(summary["film_eigenvalues"]), 4)

    def test_inertias_in_the_place_of_the_mass(self):
        inertias = {"pinion": 1e-3, "wheel": 4e-3}
        summary = self.eigen(case=self.write_case(barbieri_with_inertias(**inertias)))
        self.run_well("info", BARBIERI)
        derived = summary_in(self.folder / "output/barbieri2013")
        mass = 1 / sum(derived[f"base_radius_{gear}"]**2 / inertia for gear, inertia in inertias.items())
        self.assertAlmostEqual(summary["m_ge"] / mass, 1, delta=1e-12)
        self.assertAlmostEqual(summary["f_n"] / (derived["f_n"] * (derived["m_ge"] / mass)**0.5), 1, delta=1e-9)
        for gear, inertia in inertias.items():
            self.assertEqual(summary[f"inertia_{gear}"], inertia)

    def test_films_ring_down_as_the_eigenvalue_says(self):
        summary = self.eigen()
        frequency, damping_ratio, rest = self.ring_down(summary["film_frequency"], "-start_H0", summary["H0"] + 2e-3,
                                                        "-output_spectrum_periods", 5)
        # The rest is the time step's: at half of it the differences are 3e-5 and 1e-4.
        self.assertAlmostEqual(frequency / summary["film_frequency"], 1, delta=1e-3)
        self.assertAlmostEqual(damping_ratio / summary["film_damping_ratio"], 1, delta=0.03)
        self.assertAlmostEqual(rest, summary["H0"], delta=1e-5)
        # Lines are 1400 Hz apart. The mean of H0 is not an oscillation.
        highest = summary_in(self.folder / "ringing")["spectrum_peaks"][0]
        self.assertAlmostEqual(highest["frequency"], frequency, delta=700.1)
        self.assertLess(highest["H0"], 2e-3)

    def test_dry_pair_rings_without_damping(self):
        frequency, damping_ratio, _ = self.ring_down(5139.07, "-model", "dry", "-start_H0", -1.648, "-time_dt", 0.2)
        self.assertAlmostEqual(frequency / 5139.07, 1, delta=1e-4)
        self.assertLess(abs(damping_ratio), 1e-4)


class Sweep(VibrationTest):
    OPTIONS = [*MARCH, "-periodic_multipliers", "no", "-output_dir", "sweep"]

    def setUp(self):
        super().setUp()
        self.output = self.folder / "sweep"

    def sweep(self, values, *options, processes=1):
        return self.run_well("sweep", BARBIERI, *self.OPTIONS, "-sweep_values", values, *options, processes=processes)

    def points(self):
        """Time of writing and content of each point's file."""
        return {path.name: (path.stat().st_mtime_ns, path.read_bytes()) for path in (self.output / "points").iterdir()}

    def test_two_speeds_in_both_directions(self):
        values = "16000, 15000"
        run = self.sweep(values)
        rows = table_in(self.output, "sweep")
        self.assertEqual(set(os.listdir(self.output)), {"points", "results.h5", "summary.json", "sweep.json"})
        numpy.testing.assert_array_equal(rows["speed_rpm"], [15000, 16000, 16000, 15000])
        numpy.testing.assert_array_equal(rows["up"], [1, 1, 0, 0])
        numpy.testing.assert_array_equal(rows["found"], 1)
        numpy.testing.assert_allclose(rows["f_m"], rows["speed_rpm"] / 60 * 28, rtol=1e-12)
        for name in ("H0_after_leaving", "force_ratio_max"):
            numpy.testing.assert_allclose(rows[name][2:], rows[name][1::-1], rtol=0, atol=SAME_ORBIT, err_msg=name)
        self.assertRegex(run.stdout, r"(?m)^up 15000 rpm: force ratio 1\.28")
        summary = summary_in(self.output)
        self.assertEqual((summary["points_found"], summary["points_failed"]), (4, 0))
        for row, point in zip(rows, summary["points"]):
            self.assertEqual(row["p_max"], point["p_max"])

        with self.subTest("deals its chains out to two processes"):
            shutil.move(self.output, self.folder / "alone")
            self.sweep(values, "-sweep_groups", 2, processes=2)
            shared = table_in(self.output, "sweep")
            # What is left of the change over a period is the difference of nearly equal numbers.
            for name in set(rows.dtype.names) - {"defect", "film_defect"}:
                numpy.testing.assert_allclose(shared[name], rows[name], rtol=SAME, err_msg=name)

        with self.subTest("goes on where it was interrupted"):
            shutil.rmtree(self.output, ignore_errors=True)
            shutil.move(self.folder / "alone", self.output)
            before = self.points()
            (self.output / "points/down_0000.json").unlink()
            (self.output / "summary.json").unlink()
            self.sweep(values)
            after = self.points()
            self.assertEqual([name for name in before if before[name] != after[name]], ["down_0000.json"])
            again = summary_in(self.output)
            self.assertEqual((again["points_found"], again["points_failed"]), (4, 0))
            self.assertEqual(again["points"][:3], summary["points"][:3])
            for name in ("H0_after_leaving", "force_ratio_max"):
                self.assertAlmostEqual(again["points"][3][name], summary["points"][3][name], delta=SAME_ORBIT)

        with self.subTest("keeps its folder from another sweep"):
            before = self.points()
            for processes in (1, 2):
                other = self.run_program("sweep", BARBIERI, *self.OPTIONS, "-sweep_values", "15000, 16500",
                                         processes=processes)
                self.assertEqual(other.status, 1, other)
                self.assertEqual(other.stdout, "", other)
                self.assertRegex(other.stderr, r"\Agearfilm: wrong input: .*sweep\.values.*-output_dir.*\n\Z")
                self.assertEqual(self.points(), before)
                self.assertEqual(summary_in(self.output), again)

    def test_a_point_that_fails_leaves_the_others(self):
        # At 8000 rpm the dynamic force widens the contact beyond the sides of the short domain.
        run = self.sweep("8000, 15000", "-sweep_direction", "up", "-grid_y_half", 1.1)
        self.assertRegex(run.stdout, r"(?m)^up 8000 rpm: failed: .*grid_y_half")
        rows = table_in(self.output, "sweep")
        numpy.testing.assert_array_equal(rows["found"], [0, 1])
        numpy.testing.assert_array_equal(numpy.isnan(rows["force_ratio_max"]), [True, False])
        summary = summary_in(self.output)
        self.assertEqual((summary["points_found"], summary["points_failed"]), (1, 1))
        failed, found = summary["points"]
        self.assertIn("side edge", failed["error"])
        self.assertNotIn("force_ratio_max", failed)
        self.assertNotIn("error", found)
        self.assertEqual(found["start"], "dry orbit")

    def test_a_sweep_without_any_state_is_not_solved(self):
        run = self.run_program("sweep", BARBIERI, "-grid_nx", 33, "-grid_ny", 9, "-sweep_values", "15000, 16000",
                               "-output_dir", "sweep")
        self.assertEqual(run.status, 2, run)
        self.assertRegex(run.stderr, r"\Agearfilm: not solved: .*summary\.json\n\Z")
        summary = summary_in(self.output)
        self.assertEqual((summary["points_found"], summary["points_failed"]), (0, 4))
        numpy.testing.assert_array_equal(table_in(self.output, "sweep")["found"], 0)


class Spectrum(VibrationTest):
    def test_dry_march_has_the_mesh_frequency_among_its_peaks(self):
        self.run_well("transient", BARBIERI, "-model", "dry", "-mesh_periods", 8, "-output_spectrum_periods", 8,
                      "-time_dt", 0.1, "-output_dir", "dry")
        lines = table_in(self.folder / "dry", "spectrum")
        numpy.testing.assert_allclose(lines["frequency"], 875.0 * numpy.arange(len(lines)), rtol=1e-9)
        peaks = [peak["frequency"] for peak in summary_in(self.folder / "dry")["spectrum_peaks"]]
        self.assertLess(min(abs(frequency - 7000) for frequency in peaks), 437.5)


class WrongInput(ProgramTest):
    """Exit status 1: one line on stderr that says what to do, nothing written."""

    def case_with(self, old, new):
        original = BARBIERI.read_text(encoding="utf-8")
        self.assertEqual(original.count(old), 1, old)
        return self.write_case(original.replace(old, new))

    def test_command_line(self):
        trials = [
            ([], ["no command", "info", "steady"]),
            (["steady"], ["no case file", "gearfilm steady CASE.yaml"]),
            (["stedy", BARBIERI], ["unknown command 'stedy'", "steady"]),
            ([BARBIERI], ["unknown command"]),
            (["steady", BARBIERI, WANG], ["wang2004.yaml"]),
            (["steady", "no_such_case.yaml"], ["no_such_case.yaml", "does not exist"]),
            (["steady", INPUT], ["is a directory"]),
            (["steady", BARBIERI, "-grid_nz", "65"], ["unknown option '-grid_nz 65'", "-grid_nx"]),
            (["steady", BARBIERI, "-grid_nx=65"], ["unknown option", "-grid_nx"]),
            (["steady", BARBIERI, "-grid_nx"], ["-grid_nx", "no value"]),
            (["steady", BARBIERI, "-grid_nx", "15"], ["-grid_nx", "15", "17"]),
            (["steady", BARBIERI, "-grid_nx", "many"], ["-grid_nx", "many", "whole number"]),
            (["steady", BARBIERI, "-pinion_torque", "nan"], ["-pinion_torque", "nan"]),
            (["steady", BARBIERI, "-contact_load", "5"], ["-contact_load", "case.kind"]),
            (["transient", WANG], ["wang2004", "gear.equivalent_mass"]),
            (["transient", CIRCULAR], ["gear.equivalent_mass", "gear pair"]),
            (["steady", BARBIERI, "-steady_position", "6e-3"], ["-steady_position", "0.006", "0.00574"]),
            (["eigen", BARBIERI, "-steady_position", "6e-3"], ["-steady_position", "0.006", "0.00574"]),
            (["eigen", CIRCULAR], ["circular_m20_l10", "gear.equivalent_mass", "gear pair"]),
            (["periodic", CIRCULAR], ["circular_m20_l10", "gear.equivalent_mass", "gear pair"]),
            (["periodic", WANG], ["wang2004", "gear.equivalent_mass"]),
            (["transient", BARBIERI, "-mesh_periods", 2, "-output_spectrum_periods", 3],
             ["-output_spectrum_periods", "is 3", "2 mesh periods"]),
        ]
        for arguments, words in trials:
            with self.subTest(arguments=[str(argument) for argument in arguments]):
                self.assert_wrong(words, *arguments)

    def test_sweep(self):
        both_ends = ["-sweep_from", 15000, "-sweep_to", 16000]
        trials = [
            ([], ["sweep.from", "sweep.to", "sweep.values"]),
            (["-sweep_from", 15000], ["-sweep_from", "'sweep.to'", "both ends"]),
            (["-sweep_to", 15000], ["-sweep_to", "'sweep.from'", "both ends"]),
            (["-sweep_from", 15000, "-sweep_to", 15000], ["'sweep.from' is 15000", "'sweep.to', 15000"]),
            (["-sweep_from", 16000, "-sweep_to", 15000], ["'sweep.from' is 16000", "'sweep.to', 15000"]),
            ([*both_ends, "-sweep_values", "15000"], ["'sweep.values'", "'sweep.from'"]),
            ([*both_ends, "-sweep_points", 1], ["sweep.points", "is 1"]),
            ([*both_ends, "-sweep_over", "load"], ["sweep.over", "load", "torque"]),
            (["-sweep_values", "15000, fast"], ["sweep.values", "'fast'", "not a number"]),
            (["-sweep_values", "15000, -1"], ["sweep.values", "-1 rpm", "out of range"]),
            (["-sweep_values", ", ,"], ["sweep.values", "no number"]),
        ]
        for options, words in trials:
            with self.subTest(options=options):
                self.assert_wrong(words, "sweep", BARBIERI, *options)
        self.assert_wrong(["sweep.values", "gear_pair"], "sweep", CIRCULAR, "-sweep_values", "1, 2")
        with_inertias = self.write_case(barbieri_with_inertias(pinion=1e-3, wheel=4e-3))
        for values in (["-sweep_values", "0.3, 0.4"], ["-sweep_from", 0.3, "-sweep_to", 0.4]):
            self.assert_wrong(["equivalent_mass", "inertias"], "sweep", with_inertias, "-sweep_over", "equivalent_mass",
                              *values)

    def test_case_file(self):
        trials = [
            ("  outer_radius: 46.55e-3", " outer_radius: 46.55e-3", ["case.yaml:8", "malformed YAML"]),
            ("teeth: 28", "teth: 28", ["case.yaml:7", "unknown key 'pinion.teth'", "'pinion.teeth'"]),
            ("teeth: 28", "teeth: 28\n  teeth: 28", ["case.yaml:8", "duplicate key 'pinion.teeth'"]),
            ("teeth: 28", "teeth: many", ["case.yaml:7", "'many'", "whole number"]),
            ("teeth: 28", "teeth: 'two\n\n    lines'", ["case.yaml:7", "several lines"]),
            ("module: 3e-3", "module: -3e-3", ["gear.module", "-3e-3"]),
            ("centre_distance: 111e-3", "centre_distance: 90e-3", ["centre_distance", "0.09", "base"]),
            ("outer_radius: 46.55e-3", "outer_radius: 43e-3", ["contact ratio", "below 1"]),
            ("face_width: 20e-3", "face_width: 20", ["gear.face_width", "20 m"]),
        ]
        for old, new, words in trials:
            with self.subTest(new=new):
                self.assert_wrong(words, "info", self.case_with(old, new))

    def test_every_bad_input_file(self):
        files = sorted((SOURCE / "tests/bad_input").glob("*.yaml"))
        self.assertGreater(len(files), 20)
        for file in files:
            with self.subTest(file=file.name):
                self.assert_wrong([file.name], "steady", file)

    def test_output_folder_that_cannot_be_made(self):
        below_a_file = self.write_case("not a folder", "file") / "deeper"
        for command in ("info", "steady", "bench"):
            self.assert_wrong(["deeper", "-output_dir"], command, BARBIERI, "-output_dir", below_a_file)

    def test_two_processes_say_it_once(self):
        below_a_file = self.write_case("not a folder", "file") / "deeper"
        trials = [
            ([], ["no command"]),
            (["steady", "no_such_case.yaml"], ["does not exist"]),
            (["steady", BARBIERI, "-grid_nz", "65"], ["-grid_nx"]),
            (["steady", BARBIERI, "-grid_nx", "15"], ["17"]),
            (["steady", SOURCE / "tests/bad_input/unknown_key.yaml"], ["pinion.teeth"]),
            (["steady", SOURCE / "tests/bad_input/low_contact_ratio.yaml"], ["contact ratio"]),
            (["steady", BARBIERI, "-output_dir", below_a_file], ["-output_dir"]),
        ]
        for arguments, words in trials:
            with self.subTest(arguments=[str(argument) for argument in arguments]):
                self.assert_wrong(words, *arguments, processes=2)

    def test_more_processes_than_rows(self):
        self.assert_wrong(["ny = 9", "10 processes"], "steady", CIRCULAR, "-grid_ny", 9, processes=10)
        self.assert_wrong(["ny = 9", "10 processes"], "sweep", BARBIERI, "-grid_ny", 9, "-sweep_values", 15000,
                          "-sweep_groups", 1, processes=10)


class Texts(ProgramTest):
    def test_help_names_commands_and_parameters_once(self):
        for processes in (1, 2):
            help_text = self.run_well("-help", processes=processes).stdout
            for word in ("  info ", "  steady ", "  bench ", "  parameters ", "  -grid_nx ", "  -pinion_teeth "):
                self.assertEqual(help_text.count("\n" + word), 1, word)
        self.assertEqual(self.run_well("--help").stdout, self.run_well("-h").stdout)

    def test_version(self):
        self.assertRegex(self.run_well("-version").stdout, r"\Agearfilm \d+\.\d+\.\d+\S*\n\Z")

    def test_parameters_need_no_case(self):
        table = self.run_well("parameters").stdout
        self.assertTrue(table.startswith("# Parameters\n"))
        self.assertIn("| `pinion.teeth` | `Z_1` |", table)
        self.assertEqual(self.run_well("parameters", processes=2).stdout, table)

    def test_petsc_options_pass(self):
        for option in ("-steady_snes_monitor", "-log_view"):
            run = self.run_well("steady", CIRCULAR, "-grid_nx", 33, "-grid_ny", 33, option)
            self.assertGreater(run.stdout.count("\n"), 10, option)
        for option in ("-dry_eps_view", "-modes_eps_view"):
            run = self.run_well("eigen", BARBIERI, *COARSE, option)
            self.assertGreater(run.stdout.count("\n"), 10, option)

    def test_unused_petsc_option_is_a_warning(self):
        run = self.run_program("info", CIRCULAR, "-ksp_tpye", "cg")
        self.assertEqual(run.status, 0, run)
        self.assertEqual(run.stderr, "gearfilm: warning: option -ksp_tpye cg was not used\n")


if __name__ == "__main__":
    unittest.main()
