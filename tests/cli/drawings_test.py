"""The drawings of the model for both pairs of the paper, and the teeth they show."""
import json
import sys
import unittest

import numpy

from drawn import require_drawn
from program import INPUT, SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "scripts"))
from studies.common.gears import gear_pair  # noqa: E402
from studies.common.plotting import PlotError, pyplot, save  # noqa: E402
from studies.paper.figures import FIGURES  # noqa: E402

# Teeth, outer radii, centre distance as the case files have them.
CASES = {"barbieri2013": ((28, 43), (46.55e-3, 69.85e-3), 111e-3),
         "wang2004": ((35, 140), (36.50e-3, 141.04e-3), 174.5e-3)}
NEAR = 5e-4  # mm: outlines are lines through points
DRAWINGS = (1, 2, 4, 5, 6)


def distance(point, line):
    """From a point to a line through points."""
    steps = numpy.diff(line, axis=0)
    line = numpy.concatenate([line[:-1][(steps ** 2).sum(axis=1) > 0], line[-1:]])  # without points that are given twice
    steps = numpy.diff(line, axis=0)
    along = numpy.clip(((point - line[:-1]) * steps).sum(axis=1) / (steps ** 2).sum(axis=1), 0, 1)
    return numpy.hypot(*(line[:-1] + along[:, None] * steps - point).T).min()


class Drawings(ProgramTest):
    def inform(self, case):
        """Results of `gearfilm info`, as scripts/studies/paper finds them."""
        self.run_well("info", INPUT / f"{case}.yaml", "-output_dir", f"{case}/info")
        return self.folder / case

    def mesh(self, case):
        return gear_pair(json.loads((self.inform(case) / "info/summary.json").read_text(encoding="utf-8")))

    def test_drawings_of_both_pairs(self):
        for case in CASES:
            folder = self.inform(case)
            for number in DRAWINGS:
                with self.subTest(case=case, figure=number):
                    figure = FIGURES[number].draw(folder)
                    paths = [folder / f"{number}.png", folder / f"{number}.pdf"]
                    require_drawn(figure)
                    save(figure, paths)
                    pyplot.close(figure)
                    for path, beginning in zip(paths, (b"\x89PNG", b"%PDF")):
                        self.assertTrue(path.read_bytes().startswith(beginning), path)

    def test_an_axes_without_a_finite_value_is_noticed(self):
        for values in ([], [float("nan")] * 2):
            figure, axes = pyplot.subplots(1, 2)
            axes[0].plot([0, 1], [0, 1])
            axes[1].plot(values, values)
            with self.assertRaisesRegex(AssertionError, "shows no finite value"):
                require_drawn(figure)
            pyplot.close(figure)

    def test_a_bare_contact_is_refused(self):
        folder = self.inform("circular_m20_l10")
        for number in DRAWINGS:
            with self.subTest(figure=number), self.assertRaisesRegex(PlotError, "not that of a gear pair"):
                FIGURES[number].draw(folder)

    def test_drawn_gears_are_those_of_the_case(self):
        for case, (teeth, outer_radii, centre_distance) in CASES.items():
            with self.subTest(case=case):
                mesh = self.mesh(case)
                for gear, number, radius in zip((mesh.pinion, mesh.wheel), teeth, outer_radii):
                    self.assertEqual(gear.teeth, number)
                    self.assertAlmostEqual(gear.tip, 1e3 * radius, delta=1e-6)
                self.assertAlmostEqual(numpy.hypot(*(mesh.wheel.centre - mesh.pinion.centre)), 1e3 * centre_distance,
                                       delta=1e-6)

    def test_flanks_turned_with_their_gears_touch_on_the_line_of_action(self):
        for case in CASES:
            mesh = self.mesh(case)
            for n, (gear, forwards) in enumerate(((mesh.pinion, 1), (mesh.wheel, -1))):
                for xi in numpy.linspace(0.99 * mesh.entry, 0.99 * mesh.exit, 9):
                    with self.subTest(case=case, gear=n + 1, xi=xi):
                        outline = gear.outline(forwards * xi, 0)
                        self.assertLess(distance(mesh.at(xi), outline), NEAR)



if __name__ == "__main__":
    unittest.main()
