"""The page of a run: its names and units, its order, its width on small screens, and the case file that repeats it."""
import html.parser
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import numpy

from films import BARBIERI, CIRCULAR, summary_in
from program import INPUT, PROGRAM, SECONDS, SOURCE, ProgramTest
from vibration import MARCH

sys.path.insert(0, str(SOURCE / "scripts"))
import gearfilm  # noqa: E402  pylint: disable=wrong-import-position
from gearfilm import defaults, quantities  # noqa: E402  pylint: disable=wrong-import-position
from gearfilm.folder import ResultsError  # noqa: E402  pylint: disable=wrong-import-position
from gearfilm.report import BARE, main_results, page, write_report  # noqa: E402  pylint: disable=wrong-import-position

COARSE = {"grid_nx": 65, "grid_ny": 33, "grid_y_half": 1.4}
DRY = ["-model", "dry", "-dry_damping_ratio", 0.02]
UNITS = {"m", "-", "Pa", "N", "W", "K", "m/s", "s", "m^3/s"}
OWN_WORDS = {"mesh_period", "nx"}       # of figures that mean more than one thing in the manual
CHROMIUM = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
            "--disable-background-networking", "--disable-component-update", "--disable-sync"]


def printed(command):
    return subprocess.run([PROGRAM, command], capture_output=True, text=True, check=True, timeout=SECONDS).stdout


def rows_of(command):
    """Cells of the rows of all tables that a command prints."""
    for line in printed(command).splitlines():
        if line.startswith("| `"):
            yield [cell.strip(" `") for cell in line.strip("|").split("|")]


class Scrolled(html.parser.HTMLParser):
    """Tables and pictures, and whether each is in a box that scrolls by itself."""

    def __init__(self, text):
        super().__init__()
        self.boxes, self.inside = [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        if tag == "div":
            self.boxes.append(dict(attrs).get("class"))
        if tag in ("table", "img"):
            self.inside.append("wide" in self.boxes)

    def handle_endtag(self, tag):
        if tag == "div":
            self.boxes.pop()


class Manual(unittest.TestCase):
    def test_units_and_words_are_those_of_the_manual(self):
        meanings = {}
        for name, *cells in rows_of("figures"):
            # Of mesh periods there is no symbol, but where else a figure stands; of fields neither.
            of_period = cells[0] in UNITS or len(cells) == 2
            unit, meaning = cells[:2] if of_period else cells[1:3]
            meanings.setdefault(name, []).append(meaning)
            if name in quantities.KNOWN and unit:
                self.assertEqual(quantities.KNOWN[name].unit, unit, name)
        common = set(meanings) & set(quantities.KNOWN) - OWN_WORDS
        self.assertGreater(len(common), 80)
        for name in common:
            words = quantities.KNOWN[name].meaning
            self.assertTrue(any(meaning.startswith(words) for meaning in meanings[name]), f"{name}: {words}")

    def test_defaults_are_those_of_the_program(self):
        rows = [(cells[0], cells[4].removeprefix("default ")) for cells in rows_of("parameters")
                if cells[4].startswith("default ")]
        self.assertEqual(defaults.KNOWN, dict(rows), "write the table of scripts/gearfilm/defaults.py again")

    def test_numbers_are_shown_in_units_that_fit(self):
        headings, rows = main_results({"h_min": 1.7904e-6, "h_min_error": 2.536e-7, "h_min_extrapolated": 2.044e-6,
                                       "p_max": 3.2976e9, "mesh_period": 1.4286e-4, "force_ratio_max": 1.2886,
                                       "te_harmonics": [1.2e-5, 8.5e-6], "stable": True, "newton_iterations": 7})
        self.assertEqual(headings, ["quantity", "value", "unit", "error", "finer grids"])
        self.assertEqual([[name[1], *rest] for name, *rest in rows],
                         [["h_min", "1.7904", "µm", "0.25", "2.044"], ["p_max", "3.2976", "GPa", "", ""],
                          ["mesh_period", "142.86", "µs", "", ""], ["force_ratio_max", "1.2886", "-", "", ""],
                          ["te_harmonics", "12, 8.5", "µm", "", ""], ["stable", "yes", "", "", ""]])
        self.assertEqual(rows[0][0][0], "smallest film thickness")


class Report(ProgramTest):
    def setUp(self):
        super().setUp()
        self.enterContext(mock.patch.dict(os.environ, {"GEARFILM": str(PROGRAM)}))

    def steady(self, **options):
        return gearfilm.run(BARBIERI, "steady", self.folder / "steady", **COARSE, **options)

    def periodic(self):
        self.run_well("periodic", BARBIERI, *MARCH, "-output_dir", "periodic")
        return gearfilm.open(self.folder / "periodic")

    def runs(self):
        """One of every command with a page."""
        yield self.steady()
        yield self.periodic()
        for command, *options in (("static",), ("eigen", *DRY), ("info",), ("transient", *DRY),
                                  ("continuation", *DRY, "-continuation_from", 28000, "-continuation_to", 26000),
                                  ("sweep", *DRY, "-sweep_from", 14000, "-sweep_to", 15000, "-sweep_points", 3)):
            done = self.run_program(command, BARBIERI, *options, "-output_dir", command)
            self.assertEqual(done.status, 0, done)
            yield gearfilm.open(self.folder / command)

    def test_a_page_of_somebody_else_stays(self):
        run, own = self.steady(), self.folder / "steady/report.html"
        own.write_text("<title>of a measurement</title>", encoding="utf-8")
        with self.assertRaisesRegex(ResultsError, "report.html is no page of gearfilm.* --output"):
            write_report(run)
        self.assertEqual(own.read_text(encoding="utf-8"), "<title>of a measurement</title>")
        own.unlink()
        for _ in range(2):
            self.assertIn("gearfilm", write_report(run).read_text(encoding="utf-8")[:400])

    def test_every_figure_has_a_meaning_and_internals_come_last(self):
        for run in self.runs():
            with self.subTest(command=run.command, folder=run.folder.name):
                for name, value in run.summary.items():
                    if name not in BARE and not isinstance(value, (dict, list)):
                        self.assertIsNotNone(quantities.quantity(name), name)
                text = page(run)
                self.assertIn('<meta name="viewport" content="width=device-width, initial-scale=1">', text)
                inside = Scrolled(text).inside
                self.assertTrue(inside and all(inside))
                below = text.index("<h2>Internals</h2>")
                self.assertLess(text.index("<h2>Main results</h2>"), below)
                if run.parameters:
                    self.assertLess(text.index("<h2>How to repeat it</h2>"), below)
                for name in ("newton_iterations", "residual", "defect", "wall_time", "petsc"):
                    self.assertNotIn(f">{name}<", text[:below])

    def test_the_page_has_the_case_file_that_repeats_the_run(self):
        for name, command, case, *options in (
                ("static", "static", "barbieri2013_relief", "-static_positions", 50, "-static_load_ratios", "0.5, 1"),
                ("march", "transient", "bad_tooth", *DRY[:2], "-mesh_periods", 1)):
            done = self.run_program(command, INPUT / f"{case}.yaml", *options, "-output_dir", name)
            self.assertEqual(done.status, 0, done)
        self.run_well("steady", CIRCULAR, "-output_dir", "circular")
        self.steady(lubricant_viscosity=0.0398765432109876)
        for name, most in (("steady", 25), ("static", 35), ("march", 40), ("circular", 15)):
            with self.subTest(name=name):
                run = gearfilm.open(self.folder / name)
                command, case = re.findall(r"<pre>(.*?)</pre>", page(run), re.DOTALL)
                self.assertLessEqual(len(re.findall(r"(?m): \S", case)), most)
                words = command.split()
                self.assertEqual(words[:2], ["gearfilm", run.command])
                path = self.write_case(case.replace("&quot;", '"'), words[2])
                self.assertEqual(self.run_program(words[1], path, "-output_dir", "again").status, 0)
                again = gearfilm.open(self.folder / "again")
                self.assertEqual({key: value for key, value in again.parameters.items() if key != "output.dir"},
                                 {key: value for key, value in run.parameters.items() if key != "output.dir"})
                for key in ("h_min", "te_peak_to_peak", "force_ratio_max"):
                    self.assertEqual(again.summary.get(key), run.summary.get(key))

    def test_film_of_a_periodic_state(self):
        run = self.periodic()
        film, figure = run.film(xi=0.0), run.draw("film")
        maps, _, pressure, thickness = figure.axes     # the second one is that of the colours
        middle = abs(film.y).argmin()
        numpy.testing.assert_array_equal(pressure.lines[0].get_ydata(), film.pressure[:, middle])
        numpy.testing.assert_array_equal(thickness.lines[0].get_ydata(), film.thickness[:, middle])
        with self.subTest("the ellipse of the reference contact"):
            reference = self.steady().folder / "results.h5"
            with gearfilm.folder.h5py.File(reference) as results:
                a, b = (1e3 * results["contact0"].attrs[name] for name in ("a", "b"))
            y, x = maps.lines[0].get_data()
            numpy.testing.assert_allclose([x.max(), y.max()], [a, b], rtol=1e-3)
        elsewhere = run.draw("film", at=-3.0)
        nearest = run.film(xi=-3.0)
        numpy.testing.assert_array_equal(elsewhere.axes[2].lines[0].get_ydata(), nearest.pressure[:, middle])
        self.assertNotEqual(nearest.xi, film.xi)
        self.assertEqual(page(run).count("<img "), 3)
        with self.subTest("dry states have none"):
            self.run_well("periodic", BARBIERI, *DRY, "-output_dir", "dry")
            text = page(gearfilm.open(self.folder / "dry"))
            self.assertEqual((text.count("<img "), text.count("stores no films")), (2, 0))

    @unittest.skipUnless(shutil.which("chromium"), "no chromium on this machine")
    def test_a_page_is_as_wide_as_a_telephone(self):
        for run in (self.steady(), self.periodic()):
            path = self.folder / "page.html"
            measure = "<script>document.title = document.documentElement.scrollWidth + ' of ' + innerWidth;</script>"
            path.write_text(page(run).replace("</body>", measure + "</body>"), encoding="utf-8")
            with tempfile.TemporaryDirectory() as profile:
                shown = subprocess.run([*CHROMIUM, f"--user-data-dir={profile}", "--window-size=390,3000", "--dump-dom",
                                        path.as_uri()], capture_output=True, text=True, timeout=SECONDS, check=True)
            wide, screen = map(int, re.search(r"<title>(\d+) of (\d+)</title>", shown.stdout).groups())
            self.assertLessEqual(wide, screen)
            self.assertLess(screen, 600)


class Numbers(unittest.TestCase):
    def test_lists_of_numbers_are_no_number_with_a_unit(self):
        read = gearfilm.folder._parameter  # pylint: disable=protected-access
        for text, value, unit in (("470 N m", 470.0, "N m"), ("2.2e-8 1/Pa", 2.2e-8, "1/Pa"), ("28", 28.0, ""),
                                  ("0 0 5e-6 0", "0 0 5e-6 0", ""), ("15000, 16000", "15000, 16000", "")):
            self.assertEqual((read(text).value, read(text).unit), (value, unit))


if __name__ == "__main__":
    unittest.main()
