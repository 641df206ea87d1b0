"""The program from outside: derived quantities, films, their results, and what it says of itself.

Environment: GEARFILM, the binary; GEARFILM_MPIEXEC, the launcher with its process flag ("mpiexec -n").
"""
import os
import re
import unittest
import xml.etree.ElementTree

import h5py
import numpy

from films import BALANCE, BARBIERI, CIRCULAR, REFERENCE, SAME, WANG, FilmTest, summary_in
from program import RESULT_FILES, ProgramTest
from vibration import COARSE


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
        version = self.run_well("version").stdout.split()[1]
        required = re.findall(r"^\| `((?:pinion|wheel|gear|lubricant)\.\w+)` .*\| (?:required|default [^|]*) \|",
                              self.run_well("parameters").stdout, re.MULTILINE)
        self.assertGreater(len(required), 15)
        with h5py.File(self.output / "results.h5") as results:
            self.assertEqual(results.attrs["program"], "gearfilm")
            self.assertEqual(results.attrs["format_version"], 1)
            self.assertEqual(results.attrs["version"], version)
            self.assertEqual(results.attrs["command"], "steady")
            parameters = dict(results["parameters"].attrs)
            for name in required:
                self.assertIn(name, parameters)
            self.assertEqual(parameters["pinion.teeth"], "28")
            self.assertEqual(parameters["gear.module"], "0.003 m")
            self.assertEqual(parameters["lubricant.viscosity"], "0.04 Pa s")
            self.assertEqual(parameters["grid.nx"], "129")
            units = {name: data.attrs["unit"] for name, data in results["contact0"].items()}
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
        for edge in (pressure[0], pressure[-1], pressure[:, 0], pressure[:, -1]):
            self.assertLess(numpy.abs(edge).max(), 1e-9 * pressure.max())
        self.assertGreater(pressure.min(), -1e-9 * pressure.max())
        self.assertEqual(pressure.max(), summary["p_max"])
        self.assertEqual(film.min(), summary["h_min"])
        self.assertAlmostEqual(numpy.interp(0, x, film[:, 32]) / summary["h_central"], 1, delta=1e-12)
        self.assertAlmostEqual(numpy.interp(0, x, pressure[:, 32]) / summary["p_central"], 1, delta=1e-12)
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
            self.assertEqual(results["parameters"].attrs["contact.load"], "7 N")
        self.assertFalse((self.folder / "output").exists())


class NotSolved(ProgramTest):
    """Exit status 2: the message names contact, position and remedy, and nothing that looks like a result is left."""

    def assert_not_solved(self, words, *options):
        for processes in (1, 2):
            with self.subTest(options=options, processes=processes):
                run = self.run_program("steady", BARBIERI, *options, processes=processes)
                self.assert_message(run, 2, "gearfilm: not solved: ", words)
                self.assertEqual([path.name for path in self.folder.rglob("*") if path.is_file()], [])

    def test_face_too_narrow_for_the_load(self):
        # The ellipse, 7 mm long, grows with the cube root of the load: 30^(1/3) = 3.1.
        self.assert_not_solved(["contact 0", "xi = 0 mm", "30 times", "21.7", "20 mm wide", "crowning"],
                               "-steady_load_ratio", 30)

    def test_newton_stopped_before_convergence(self):
        self.assert_not_solved(["contact 0", "xi = 0 mm", "not converged", "solver_newton_max_iterations"],
                               "-solver_newton_max_iterations", 1)

    def test_grid_too_coarse_for_a_positive_film(self):
        self.assert_not_solved(["contact 0", "xi = 0 mm", "not positive", "grid_nx"], "-grid_nx", 17, "-grid_ny", 9)


class Texts(ProgramTest):
    def test_help_names_commands_and_parameters_once(self):
        for processes in (1, 2):
            help_text = self.run_well("-help", processes=processes).stdout
            for word in ("  info ", "  steady ", "  bench ", "  parameters ", "  -grid_nx ", "  -pinion_teeth "):
                self.assertEqual(help_text.count("\n" + word), 1, word)
        self.assertEqual(self.run_well("--help").stdout, self.run_well("-h").stdout)

    def test_version(self):
        for words in ("-version", "version"):
            self.assertRegex(self.run_well(words).stdout, r"\Agearfilm \d+\.\d+\.\d+\S*\n"
                             r"(?:(?:FFTW|HDF5|MPI|PETSc|SLEPc): \S.*\n){5}\Z")

    def test_parameters_need_no_case(self):
        table = self.run_well("parameters").stdout
        self.assertTrue(table.startswith("# Parameters\n"))
        self.assertIn("| `pinion.teeth` | `Z_1` |", table)
        self.assertEqual(self.run_well("parameters", processes=2).stdout, table)

    def test_petsc_options_pass(self):
        for option in ("-steady_snes_monitor", "-log_view"):
            run = self.run_well("steady", CIRCULAR, "-grid_nx", 33, "-grid_ny", 33, option)
            self.assertGreater(run.stdout.count("\n"), 10, option)
        run = self.run_well("eigen", BARBIERI, *COARSE, "-modes_eps_view")
        self.assertGreater(run.stdout.count("\n"), 10)

    def test_unused_petsc_option_is_a_warning(self):
        run = self.run_program("info", CIRCULAR, "-ksp_tpye", "cg")
        self.assertEqual(run.status, 0, run)
        self.assertEqual(run.stderr, "gearfilm: warning: option -ksp_tpye cg was not used; options of PETSc's "
                         "solvers have a prefix here, as in -steady_snes_monitor\n")


if __name__ == "__main__":
    unittest.main()
