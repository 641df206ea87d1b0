"""The figures of `python3 -m gearfilm plot` from outside, on small results made up here: figures, exit statuses and messages."""
import json
import math
import sys
import unittest

import h5py
import numpy

from program import SOURCE, ProgramTest
from script import plot, run_script

sys.path.insert(0, str(SOURCE / "scripts"))
from gearfilm.drawing import KINDS  # noqa: E402
from gearfilm.drawing import march as march_figure  # noqa: E402
from gearfilm.drawing.orbit import read_orbit  # noqa: E402
from gearfilm.drawing.static import read_static, shares_of_contact  # noqa: E402

MESH_PERIOD = 7.5      # dimensionless
TIME_SCALE = 2e-5      # s
STEPS_PER_PERIOD = 20
ENTRY_STEP = 14        # of a mesh period, which begins when a contact leaves
STATIC_FORCE = 1000.0  # N
COMMANDS_OF = {"film": ["steady"],
               "face": ["steady"],
               "march": ["transient", "periodic"],
               "orbit": ["transient", "periodic"],
               "static": ["static"],
               "sweep": ["sweep"],
               "branch": ["continuation"]}


def table(columns, rows):
    """Rows as gearfilm writes them: a table of named columns, of whole numbers where all values are."""
    kinds = ["i4" if all(isinstance(row[n], int) for row in rows) else "f8" for n in range(len(columns))]
    return numpy.array([tuple(row) for row in rows], dtype=list(zip(columns, kinds)))


class Motion:
    """A periodic motion of two contacts in turn, as rows of the tables of a history."""

    def __init__(self, periods, held=False):
        self.held = held
        self.steps, self.contacts = [], []
        present = [0]
        self.add(0, 0.0, present)
        for n in range(1, periods * STEPS_PER_PERIOD + 1):
            self.add(n, MESH_PERIOD / STEPS_PER_PERIOD, present)
            if held or n % STEPS_PER_PERIOD not in (0, ENTRY_STEP):
                continue
            present = present[1:] if n % STEPS_PER_PERIOD == 0 else [*present, present[-1] + 1]
            self.add(n, 0.0, present)

    def add(self, n, dT, present):
        phase = 2 * math.pi * n / STEPS_PER_PERIOD
        T, step = n * MESH_PERIOD / STEPS_PER_PERIOD, len(self.steps)
        force = STATIC_FORCE * (1 + 0.2 * math.cos(phase))
        self.steps.append((step, T, TIME_SCALE * T, dT, 1e-3 * T, -1 + 0.5 * math.cos(phase), -0.4 * math.sin(phase),
                           len(present) * force, len(present)))
        for contact in present:
            xi = 0.0 if self.held else 6e-3 * (n / STEPS_PER_PERIOD - contact - 0.35)
            self.contacts.append((step, contact, T, xi, force, 2e9, 2e-6, 1.8e-6))


class Figures(ProgramTest):
    def plot(self, name, *options):
        return plot(name, self.folder, *options)

    def assert_drawn(self, name, *options, figure=None):
        run = self.plot(name, *options)
        self.assertEqual((run.returncode, run.stderr), (0, ""), run)
        for ending, beginning in (("png", b"\x89PNG"), ("pdf", b"%PDF")):
            path = self.folder / f"{figure or name}.{ending}"
            self.assertIn(f"figure: {path}\n", run.stdout)
            self.assertTrue(path.read_bytes().startswith(beginning), path)
            path.unlink()

    def assert_refused(self, name, *words):
        before = self.content()
        run = self.plot(name)
        self.assertEqual((run.returncode, run.stdout), (1, ""), run)
        self.assertEqual(run.stderr.count("\n"), 1, run)
        self.assertTrue(run.stderr.startswith("gearfilm: "), run)
        for word in words:
            self.assertIn(word, run.stderr)
        self.assertEqual(self.content(), before, run)

    def new_results(self, command, **parameters):
        results = h5py.File(self.folder / "results.h5", "w")
        self.addCleanup(results.close)
        results.attrs["command"] = numpy.bytes_(command)
        results.attrs["format_version"] = 1
        results.create_group("parameters").attrs.update(
            {name.replace("__", "."): numpy.bytes_(value) for name, value in parameters.items()})
        return results

    def write_summary(self, **values):
        (self.folder / "summary.json").write_text(json.dumps(values), encoding="utf-8")

    def write_film(self):
        with self.new_results("steady") as results:
            contact = results.create_group("contact0")
            contact.attrs.update({"a": 5e-4, "b": 2e-3, "p_hertz": 1e9})
            x, y = contact["x"], contact["y"] = numpy.linspace(-1e-3, 6e-4, 17), numpy.linspace(-2.2e-3, 2.2e-3, 9)
            distance = (x[:, None] / 5e-4) ** 2 + (y[None, :] / 2e-3) ** 2
            contact["P"] = 1e9 * numpy.sqrt(numpy.maximum(1 - distance, 0))
            contact["H"] = 1e-6 * (1 + numpy.maximum(distance - 1, 0))
            for name, unit in (("P", "Pa"), ("H", "m")):
                contact[name].attrs["unit"] = unit

    def write_history(self, command, held=False, spectrum=False, found=True):
        motion = Motion(periods=4, held=held)
        begin = 3 * MESH_PERIOD
        with self.new_results(command) as results:
            results["history/steps"] = table(
                ["step", "T", "t", "dT", "distance", "H0", "V0", "force_total", "contacts"], motion.steps)
            results["history/contacts"] = table(
                ["step", "contact", "T", "xi", "force", "p_max", "h_central", "h_min"], motion.contacts)
            if command == "periodic" and found:
                results["history"].attrs.update({"periodic_from": begin, "periodic_to": begin + MESH_PERIOD})
            if spectrum:
                f_m = 1 / (TIME_SCALE * MESH_PERIOD)
                results["spectrum"] = table(["frequency", "H0", "h0"], [
                    (n * f_m, 0.5 * 0.1 ** n, 1e-6 * 0.1 ** n) for n in range(10)])
        if command == "periodic":
            self.write_summary(static_force=STATIC_FORCE, free_frequency=5200.0)
        else:
            self.write_summary(static_force=STATIC_FORCE,
                               mesh_period=TIME_SCALE * MESH_PERIOD,
                               spectrum_peaks=[{"frequency": 6000.0, "H0": 0.1}, {"frequency": 70e3, "H0": 0.01}])

    def write_sweep(self, over="speed", multipliers=True):
        absent = math.nan
        columns = ["up", "found", "speed_rpm", "torque", "I_n", "f_m", "f_n", "force_ratio_max", "h_min",
                   "transmission_error_peak_to_peak", "contact_lost", "floquet_modulus", "floquet_modulus_error",
                   "stable"]
        rows = []
        for up in (1, 0):
            for n in range(5):
                figures = [1.5 + 0.1 * n + 0.2 * up, 1e-6 * n, 1e-5 * n, 1.0 * (n == 3),
                           *((0.9 + 0.03 * n, 0.01, 1.0 * (n < 4)) if multipliers else 3 * [absent])]
                found = not (up and n == 2)
                rows.append([up, int(found), 8000.0 + 1000 * n, 400.0 + n, 20.0 + n, 4e3 + 500.0 * n, 5200.0,
                             *(figures if found else len(figures) * [absent])])
        with self.new_results("sweep", sweep__over=over) as results:
            results["sweep"] = table(columns, rows)

    def write_continuation(self, parameter="speed"):
        columns = ["branch", "order", "kind", "speed_rpm", "torque", "m_ge", "f_m", "f_n", "H0_after_leaving",
                   "V0_after_leaving", "force_ratio_max", "stable"]
        rows = []
        for branch in (1, 2):
            for n, kind in enumerate((0, 0, 2, 0, 4, 0, 1, 0)):
                rows.append([branch, branch, kind, 8000.0 + 100 * n, 400.0 + n, 0.3 + 0.01 * n, 4e3 + 50.0 * n, 5200.0,
                             -1.0 + 0.1 * n * branch, 0.2 * n, 1.5 + 0.1 * n, int(n < 2 or n == 5)])
        with self.new_results("continuation", continuation__parameter=parameter) as results:
            results["continuation"] = table(columns, rows)

    def write_static(self, load_ratios=(0.5, 1.25)):
        columns = ["load_ratio", "mesh_period", "xi", "te", "stiffness", "p_max_dry", "force_0", "force_1", "force_2",
                   "gap_0", "compliance_0", "gap_1", "compliance_1", "gap_2", "compliance_2"]
        absent = [math.nan, math.nan]
        rows = []
        for ratio in load_ratios:
            # A second contact enters after 0.75 of the mesh period, and has a quarter of the load at once.
            for part, second in ((0.0, False), (0.25, False), (0.75, False), (0.75, True), (1.0, True)):
                load = ratio * STATIC_FORCE
                share = part - 0.5 if second else 0.0
                rows.append([ratio, part, 6e-3 * (part - 0.25), 1e-5 * ratio * (2 - share), 2e8 * (1 + share), 1e9,
                             (1 - share) * load, share * load, 0.0, 1e-6, 1e-9,
                             *([1e-6, 1e-9] if second else absent), *absent])
        with self.new_results("static") as results:
            results["static"] = table(columns, rows)

    def write_results(self, command):
        if command == "steady":
            self.write_film()
        elif command == "static":
            self.write_static()
        elif command == "sweep":
            self.write_sweep()
        elif command == "continuation":
            self.write_continuation()
        else:
            self.write_history(command)

    def test_every_kind_draws_the_results_of_its_commands_and_refuses_others(self):
        for command in ("steady", "transient", "periodic", "static", "sweep", "continuation"):
            self.write_results(command)
            for name, own in COMMANDS_OF.items():
                with self.subTest(command=command, kind=name):
                    if command in own:
                        self.assert_drawn(name)
                    elif name == "film" and command in ("transient", "periodic"):
                        self.assert_refused(name, "it stores no films; run it with -output_snapshot_interval")
                    else:
                        self.assert_refused(name, "results.h5 is not a result of gearfilm", own[0])

    def test_wrong_words_are_answered_in_a_line(self):
        for name, words in (("nothing", "invalid choice: 'nothing'"), ("film", "unrecognized arguments: --bad"),
                            ("compare", "is not LABEL=FOLDER"), ("animation", "unrecognized arguments")):
            run = self.plot(name, "--bad")
            self.assertEqual((run.returncode, run.stdout, run.stderr.count("\n")), (1, "", 1), run)
            self.assertTrue(run.stderr.startswith("gearfilm: "), run)
            self.assertIn(words, run.stderr)

    def test_every_kind_has_help(self):
        for name in KINDS:
            run = plot(name, "--help")
            self.assertEqual((run.returncode, run.stderr), (0, ""), run)
            self.assertIn(f"python3 -m gearfilm plot {name} ", run.stdout)
            self.assertRegex(plot("--help").stdout, rf"(?m)^  {name} +[a-z]")

    def test_scripts_of_earlier_versions_say_the_new_command(self):
        for name in set(KINDS) - {"face", "mixed", "wear", "damage", "campbell", "modes", "train"}:  # new ones
            old = {"compare": "compare_runs", "animation": "animate_march"}.get(name, f"plot_{name}")
            run = run_script(SOURCE / f"scripts/{old}.py", "output/a b", "--name", "c")
            self.assertEqual((run.returncode, run.stdout, run.stderr.count("\n")), (1, "", 1), run)
            self.assertTrue(run.stderr.endswith(f" python3 -m gearfilm plot {name} 'output/a b' --name c\n"), run)

    def test_missing_results(self):
        for name, own in COMMANDS_OF.items():
            self.assert_refused(name, "results.h5 does not exist; run gearfilm", own[0])

    def test_file_that_is_not_hdf5(self):
        (self.folder / "results.h5").write_text("no table", encoding="utf-8")
        for name in COMMANDS_OF:
            self.assert_refused(name, "results.h5 is not an HDF5 file")

    def test_results_of_another_version(self):
        for version, words in ((7, "format version 7"), (None, "no format version")):
            self.write_results("transient")
            with h5py.File(self.folder / "results.h5", "a") as results:
                del results.attrs["format_version"]
                if version is not None:
                    results.attrs["format_version"] = version
            self.assert_refused("march", words, "version 1", "run gearfilm transient again")

    def test_missing_columns(self):
        for name, dataset in (("march", "history/contacts"), ("orbit", "history/steps"), ("sweep", "sweep")):
            with self.subTest(kind=name):
                self.write_results(COMMANDS_OF[name][0])
                with h5py.File(self.folder / "results.h5", "a") as results:
                    first_column = results[dataset][:][[results[dataset].dtype.names[0]]]
                    del results[dataset]
                    results[dataset] = first_column
                self.assert_refused(name, "columns", "are missing")

    def test_figure_has_the_wanted_name(self):
        self.write_results("transient")
        self.assert_drawn("orbit", "--name", "last", figure="last")

    def test_folder_that_cannot_be_written_to(self):
        self.write_results("sweep")
        (self.folder / "sweep.png").mkdir()
        self.assert_refused("sweep", "cannot write the figure")

    def test_a_march_has_gaps_where_time_is_missing(self):
        self.write_history("periodic")
        before, after = 1.4 * MESH_PERIOD, 2.2 * MESH_PERIOD
        with h5py.File(self.folder / "results.h5", "a") as results:
            for name in ("history/steps", "history/contacts"):
                rows = results[name][:]
                del results[name]
                results[name] = rows[(rows["T"] < before) | (rows["T"] > after)]
            steps, contacts = results["history/steps"][:], results["history/contacts"][:]
        figure = march_figure.draw(march_figure.read_march(self.folder / "results.h5"))
        begin, end = (1e3 * steps["distance"][k] for k in (numpy.flatnonzero(steps["T"] < before)[-1],
                                                           numpy.flatnonzero(steps["T"] > after)[0]))
        drawn = {axes: [] for axes in figure.axes}
        for axes in figure.axes:
            for line in axes.lines:
                x, y = map(numpy.asarray, line.get_data())
                numpy.testing.assert_array_equal(numpy.isnan(x), numpy.isnan(y))
                joined = (x[:-1] <= begin) & (x[1:] >= end)
                self.assertFalse(joined.any(), "a line over the gap")
                drawn[axes].append(x[numpy.isfinite(x)])
        motion, _, pressure, films = figure.axes
        numpy.testing.assert_allclose(drawn[motion][0], 1e3 * steps["distance"])
        self.assertEqual(sum(map(len, drawn[pressure])), len(contacts))
        self.assertEqual(sum(map(len, drawn[films])), 2 * len(contacts))

    def test_a_march_without_missing_time_is_whole(self):
        self.write_history("transient")
        figure = march_figure.draw(march_figure.read_march(self.folder / "results.h5"))
        self.assertFalse(any(numpy.isnan(line.get_xdata()).any() for axes in figure.axes for line in axes.lines))

    def test_orbit_with_spectrum_and_of_several_periods(self):
        for command in ("transient", "periodic"):
            self.write_history(command, spectrum=True)
            self.assert_drawn("orbit", "--periods", "3")

    def test_orbit_of_held_contacts(self):
        self.write_history("transient", held=True)
        self.assert_drawn("orbit")

    def test_orbit_is_one_period_from_the_leaving_of_a_contact_to_the_next(self):
        for command in ("transient", "periodic"):
            with self.subTest(command=command):
                self.write_history(command)
                orbit = read_orbit(self.folder, periods=1)
                self.assertEqual((orbit.steps["T"][0], orbit.steps["T"][-1]), (3 * MESH_PERIOD, 4 * MESH_PERIOD))
                self.assertEqual((orbit.steps["contacts"][0], orbit.steps["contacts"][-1]), (1, 2))
                self.assertEqual(sorted(orbit.change[orbit.change != 0]), [-1, 1])
                self.assertEqual(set(orbit.contacts["contact"]), {3, 4})
                self.assertEqual(orbit.static_force, STATIC_FORCE)
                self.assertAlmostEqual(orbit.mesh_frequency * 1e3 * TIME_SCALE * MESH_PERIOD, 1, delta=1e-12)

    def test_orbit_of_two_mesh_periods(self):
        self.write_history("periodic")
        self.write_summary(order=2, static_force=STATIC_FORCE)
        with h5py.File(self.folder / "results.h5", "a") as results:
            results["history"].attrs["periodic_from"] = 2 * MESH_PERIOD
        orbit = read_orbit(self.folder, periods=1)
        self.assertEqual(numpy.ptp(orbit.steps["T"]), 2 * MESH_PERIOD)
        self.assertEqual(orbit.mesh_period, MESH_PERIOD)

    def compare(self, *runs):
        return plot("compare", *runs, "--into", self.folder)

    def test_runs_side_by_side(self):
        for command in ("sweep", "periodic"):
            with self.subTest(command=command):
                self.write_results(command)
                run = self.compare(f"one={self.folder}", f"other={self.folder}")
                self.assertEqual((run.returncode, run.stderr), (0, ""), run)
                self.assertTrue((self.folder / "compare.png").read_bytes().startswith(b"\x89PNG"))
                (self.folder / "compare.png").unlink()

    def test_runs_that_cannot_be_compared(self):
        self.write_results("static")
        self.assertIn("not all of gearfilm sweep", self.compare(f"one={self.folder}").stderr)
        self.assertIn("is not LABEL=FOLDER", self.compare("one").stderr)
        self.write_results("sweep")
        self.assertIn("too many", self.compare(*(f"{n}={self.folder}" for n in range(5))).stderr)
        self.assertIn("does not exist", self.compare(f"one={self.folder / 'nothing'}").stderr)

    def test_search_that_found_no_orbit(self):
        self.write_history("periodic", found=False)
        self.assert_refused("orbit", "found no periodic state")

    def test_orbit_needs_the_summary(self):
        self.write_results("transient")
        self.write_summary()
        self.assert_refused("orbit", "summary.json", "mesh_period")
        (self.folder / "summary.json").write_text("{", encoding="utf-8")
        self.assert_refused("orbit", "summary.json")
        (self.folder / "summary.json").unlink()
        self.assert_refused("orbit", "summary.json")

    def test_static_of_one_load(self):
        self.write_static(load_ratios=[1.0])
        self.assert_drawn("static")

    def test_shares_of_a_contact_go_from_its_entry_to_its_exit(self):
        self.write_static()
        loads = read_static(self.folder / "results.h5")
        self.assertEqual([load.ratio for load in loads], [0.5, 1.25])
        for load in loads:
            places, shares = shares_of_contact(load.rows)
            numpy.testing.assert_allclose(places, [-3e-3, -1.5e-3, -1.5e-3, 0, 3e-3, 3e-3, 4.5e-3], atol=1e-15)
            numpy.testing.assert_allclose(shares, [0.25, 0.5, 1, 1, 1, 0.75, 0.5], atol=1e-15)

    def test_static_without_transmission_error(self):
        self.write_static()
        with h5py.File(self.folder / "results.h5", "a") as results:
            rows = results["static"][:]
            del results["static"]
            results["static"] = rows[[column for column in rows.dtype.names if column != "te"]]
        self.assert_refused("static", "columns of the static are missing")

    def test_static_without_positions(self):
        self.write_static(load_ratios=[])
        self.assert_refused("static", "no rows")

    def test_sweeps_over_all_quantities(self):
        for over in ("speed", "torque", "equivalent_mass"):
            self.write_sweep(over, multipliers=over == "torque")
            self.assert_drawn("sweep")

    def test_branches_over_all_quantities(self):
        for parameter in ("speed", "torque", "mass"):
            self.write_continuation(parameter)
            self.assert_drawn("branch")

    def test_sweep_whose_points_all_failed(self):
        self.write_sweep()
        with h5py.File(self.folder / "results.h5", "a") as results:
            points = results["sweep"][:]
            points["found"] = 0
            results["sweep"][:] = points
        self.assert_refused("sweep", "no periodic state")


if __name__ == "__main__":
    unittest.main()
