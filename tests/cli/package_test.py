"""The Python package of the results: runs, tables, films, CSV and the HTML page; the notebook of docs/examples."""
import base64
import contextlib
import csv
import html.parser
import importlib.util
import io
import json
import os
import re
import shutil
import subprocess
import sys
import unittest
from unittest import mock

import h5py
import numpy
from PIL import Image

from films import BARBIERI, summary_in
from program import PROGRAM, SECONDS, SOURCE, ProgramTest, names_below
from vibration import MARCH

sys.path.insert(0, str(SOURCE / "scripts"))
import gearfilm  # noqa: E402  pylint: disable=wrong-import-position

NOTEBOOK = SOURCE / "docs/examples/first_look.ipynb"


class Page(html.parser.HTMLParser):
    """What a page is made of; every tag that is opened must be closed."""

    EMPTY = {"meta", "img", "br"}

    def __init__(self, text):
        super().__init__()
        self.open, self.images, self.text, self.links = [], [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        if tag == "img":
            self.images.append(attributes["src"])
        self.links += [value for name, value in attrs if name in ("href", "src") and not value.startswith("data:")]
        if tag not in self.EMPTY:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if self.open.pop() != tag:
            raise AssertionError(f"</{tag}> closes another tag")

    def handle_data(self, data):
        self.text.append(data)


class Package(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        os.environ["GEARFILM"] = str(PROGRAM)

    def command(self, *words):
        environment = {**os.environ, "PYTHONPATH": str(SOURCE / "scripts")}
        return subprocess.run([sys.executable, "-B", "-m", "gearfilm", *map(str, words)], capture_output=True,
                              text=True, timeout=SECONDS, check=False, cwd=self.folder, env=environment)

    def steady(self):
        return gearfilm.run(BARBIERI, "steady", self.folder / "steady", grid_nx=65, grid_ny=33, grid_y_half=1.4)

    def march(self):
        self.run_well("transient", BARBIERI, *MARCH, "-grid_y_half", 1.4, "-mesh_periods", 1, "-output_dir", "march")
        return gearfilm.open(self.folder / "march")

    def test_film_in_units_of_the_field(self):
        run = self.steady()
        film, summary = run.film(), summary_in(run.folder)
        middle = numpy.unravel_index(film.pressure.argmax(), film.pressure.shape)
        self.assertAlmostEqual(film.pressure.max(), 1e-9 * summary["p_max"], places=9)
        self.assertAlmostEqual(film.thickness[film.pressure > 0.01].min(), 1e6 * summary["h_min"], places=6)
        self.assertEqual(film.thickness.shape, (film.x.size, film.y.size))
        self.assertLess(abs(film.y[middle[1]]), 0.5)
        self.assertEqual(run.parameters["grid.nx"].value, 65)
        self.assertEqual(run.parameters["pinion.torque"].unit, "N m")
        with h5py.File(run.folder / "results.h5") as results:
            for field in ("P", "H"):
                axes = [axis[0].name for axis in results[f"contact0/{field}"].dims]
                self.assertEqual(axes, ["/contact0/x", "/contact0/y"])
            self.assertEqual(results["parameters"].attrs["pinion.torque"], "470 N m")   # text, not bytes

    def test_tables_and_their_export(self):
        run = self.march()
        steps = run.table("history/steps")
        with h5py.File(run.folder / "results.h5") as results:
            numpy.testing.assert_array_equal(steps, results["history/steps"][...])
        time, error = run.transmission_error()
        numpy.testing.assert_allclose(error, -1e6 * steps["h0"])
        self.assertGreater(error.mean(), 0)     # teeth under load have approached
        self.assertEqual(len(time), len(steps))
        done = self.command("export", "march", "history/steps", "-o", "steps.csv")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done)
        with (self.folder / "steps.csv").open(encoding="utf-8", newline="") as stream:
            header, *rows = csv.reader(stream)
        self.assertIn("t [s]", header)
        numpy.testing.assert_allclose([float(row[header.index("H0")]) for row in rows], steps["H0"], rtol=1e-11)
        self.assertIn("history/contacts: ", self.command("export", "march").stdout)
        self.assertEqual(set(run.history), {"contacts", "poincare", "steps"})
        number, (place, force) = next(iter(run.forces().items()))
        rows = run.history["contacts"][run.history["contacts"]["contact"] == number]
        numpy.testing.assert_array_equal(place, 1e3 * rows["xi"])
        numpy.testing.assert_array_equal(force, rows["force"])

    def test_optional_packages(self):
        self.run_well("transient", BARBIERI, *MARCH, "-grid_y_half", 1.4, "-mesh_periods", 0.3, "-output_snapshot_interval",
                      0.1, "-output_dir", "march")
        run = gearfilm.open(self.folder / "march")
        for package, use in (("pandas", lambda: run.frame("history/steps")), ("xarray", run.fields),
                             ("xarray", run.film().dataset)):
            with mock.patch.dict(sys.modules, {package: None}):
                with self.assertRaisesRegex(gearfilm.ResultsError, f"needs the Python package {package}"):
                    use()
        if importlib.util.find_spec("pandas"):
            self.assertEqual(run.frame("history/steps").attrs["units"]["t"], "s")
        if importlib.util.find_spec("xarray"):
            fields = run.fields()
            self.assertEqual(fields.pressure.dims, ("film", "x", "y"))
            numpy.testing.assert_array_equal(fields.pressure[0], run.films()[0].pressure)

    def test_pages_stand_alone(self):
        self.run_well("periodic", BARBIERI, *MARCH, "-output_dir", "periodic")
        self.run_well("info", BARBIERI, "-output_dir", "info")
        self.steady()
        self.march()
        dry = ("-model", "dry", "-dry_damping_ratio", 0.02)
        for command, *options in (("static",), ("eigen", *dry),
                                  ("continuation", *dry, "-continuation_from", 28000, "-continuation_to", 26000),
                                  ("sweep", *dry, "-sweep_from", 14000, "-sweep_to", 15000, "-sweep_points", 3)):
            done = self.run_program(command, BARBIERI, *options, "-output_dir", command)   # may warn of the entering
            self.assertEqual(done.status, 0, done)
        for name, figures in (("steady", 1), ("march", 1), ("periodic", 3), ("info", 0), ("static", 1),
                              ("continuation", 1), ("eigen", 0), ("sweep", 1)):
            with self.subTest(name=name):
                done = self.command("report", name)
                self.assertEqual((done.returncode, done.stderr), (0, ""), done)
                text = (self.folder / name / "report.html").read_text(encoding="utf-8")
                page = Page(text)
                self.assertEqual((page.open, page.links), ([], []))
                self.assertIsNone(re.search(r"https?://|url\(|@import", text))
                self.assertEqual(len(page.images), figures)
                for image in page.images:
                    content = base64.b64decode(image.partition(",")[2], validate=True)
                    self.assertTrue(content.startswith(b"\x89PNG"))
                words = set(page.text)
                for key in summary_in(self.folder / name):
                    if key in ("h_central", "force_ratio_max", "floquet_modulus", "contact_ratio"):
                        self.assertIn(key, words)

    def test_figures_by_the_package(self):
        run = self.march()
        self.assertEqual(len(run.draw().axes), 4)
        self.assertGreater(len(run.draw("orbit", periods=1).axes), 1)
        done = self.command("plot", "poincare", "march", "--format", "pdf")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (1, "", done.stderr), done)
        self.assertRegex(done.stderr, r"\Agearfilm: .* has 1 point\(s\); .*\n\Z")
        done = self.command("plot", "orbit", "march", "--format", "pdf", "--name", "last")
        self.assertEqual((done.stdout, done.stderr), ("figure: march/last.pdf\n", ""))
        self.assertFalse((self.folder / "march/last.png").exists())
        for kind, message in (("film", "not a result of gearfilm steady"), ("nothing", "no figure 'nothing'; there are"),
                              ("compare", "no figure of one run")):
            with self.assertRaisesRegex(gearfilm.ResultsError, message):
                run.draw(kind)

    def test_recurrence_and_animation_of_a_march(self):
        self.run_well("transient", BARBIERI, *MARCH, "-grid_y_half", 1.4, "-mesh_periods", 3, "-output_snapshot_interval",
                      0.2, "-output_dir", "march")
        for kind, name, beginning in (("poincare", "poincare.png", b"\x89PNG"), ("animation", "cycle.gif", b"GIF8")):
            done = self.command("plot", kind, "march")
            self.assertEqual((done.returncode, done.stderr), (0, ""), done)
            self.assertTrue((self.folder / "march" / name).read_bytes().startswith(beginning))
        with Image.open(self.folder / "march/cycle.gif") as movie:
            self.assertGreater(movie.n_frames, 4)
        done = self.command("plot", "animation", "march", "--contact", 99)
        self.assertRegex(done.stderr, r"\Agearfilm: .* no snapshot of contact 99; it has \[.*\n\Z")

    @unittest.skipUnless(shutil.which("chromium"), "no chromium on this machine")
    def test_a_browser_shows_a_page(self):
        self.steady()
        self.command("report", "steady")
        subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--window-size=1000,1400",
                        f"--screenshot={self.folder / 'page.png'}", (self.folder / "steady/report.html").as_uri()],
                       capture_output=True, timeout=SECONDS, check=True)
        shown = numpy.asarray(Image.open(self.folder / "page.png").convert("L"))
        self.assertGreater(numpy.ptp(shown), 200)       # dark letters on white
        self.assertGreater((shown < 128).mean(), 0.005)

    def test_what_is_missing_or_wrong_is_said_in_a_line(self):
        (self.folder / "empty").mkdir()
        for words, message in ((("report", "empty"), "holds no results of gearfilm"),
                               (("export", "nowhere"), "holds no results of gearfilm")):
            done = self.command(*words)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (1, "", 1), done)
            self.assertIn(message, done.stderr)
        self.march()
        done = self.command("export", "march", "history/nothing")
        self.assertRegex(done.stderr, r"no table 'history/nothing'; it has history/contacts, .*\n\Z")
        with self.assertRaisesRegex(gearfilm.ResultsError, "wrong input: .*grid.nx"):
            gearfilm.run(BARBIERI, "steady", self.folder / "wrong", grid_nx=1)

    def test_options_are_named_as_in_a_case_file_too(self):
        run = gearfilm.run(BARBIERI, "steady", self.folder / "steady", keep_checkpoint=True, grid_y_half=1.4,
                           **{"grid.nx": 65, "grid.ny": 33, "periodic.multipliers": False})
        self.assertEqual([run.parameters[name].value for name in ("grid.nx", "grid.ny", "grid.y_half", "keep_checkpoint",
                                                                  "periodic.multipliers")], [65, 33, 1.4, "yes", "no"])

    def test_the_notebook_runs(self):
        cells = json.loads(NOTEBOOK.read_text(encoding="utf-8"))["cells"]
        code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
        self.assertTrue(all(not cell.get("outputs") for cell in cells))
        self.assertGreater(len(code), 3)
        names, printed = {}, io.StringIO()
        with contextlib.chdir(self.folder), contextlib.redirect_stdout(printed), \
                mock.patch.dict(os.environ, {"MPLBACKEND": "Agg", "GEARFILM_SOURCE": str(SOURCE)}):
            for cell in code:
                exec(compile(cell, str(NOTEBOOK), "exec"), names)  # pylint: disable=exec-used
        self.assertIn("um", printed.getvalue())

    def test_the_notebook_leaves_nothing_in_the_clone(self):
        clone = self.folder / "clone"
        for name in ("docs/examples", "scripts/gearfilm", "input"):
            shutil.copytree(SOURCE / name, clone / name, ignore=shutil.ignore_patterns("__pycache__"))
        before = names_below(clone)
        cells = json.loads((clone / "docs/examples/first_look.ipynb").read_text(encoding="utf-8"))["cells"]
        (self.folder / "cells.py").write_text("\n".join("".join(cell["source"]) for cell in cells
                                                        if cell["cell_type"] == "code"), encoding="utf-8")
        environment = {name: value for name, value in os.environ.items()
                       if name not in ("GEARFILM_SOURCE", "PYTHONDONTWRITEBYTECODE")}
        done = subprocess.run([sys.executable, self.folder / "cells.py"], cwd=clone / "docs/examples", check=False,
                              capture_output=True, text=True, timeout=SECONDS, env={**environment, "MPLBACKEND": "Agg"})
        self.assertEqual((done.returncode, done.stderr), (0, ""), done)
        self.assertIn("largest force", done.stdout)
        self.assertEqual(names_below(clone), before)


if __name__ == "__main__":
    unittest.main()
