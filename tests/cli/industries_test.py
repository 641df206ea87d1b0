"""scripts/studies/industries: twelve pairs of as many industries beside hand formulas; environment as for cli_test.py."""
import json
import pathlib
import sys
import tempfile
import unittest

from program import SOURCE
from script import run_script

SCRIPTS = SOURCE / "scripts"
sys.path.insert(0, str(SCRIPTS))
from studies.industries import formulas as hand  # noqa: E402
from studies.industries.cases import PAIRS, commands, parameters  # noqa: E402
from studies.industries.dry_motion import repeated  # noqa: E402

# Both solve closed formulas or the ratio of an ellipse to round-off.
EXACT = 1e-10
# The script integrates over a mesh period by 200 steps, the program by 400.
INTEGRAL = 2e-6
# Two schemes of integration in time, each with errors of some 1e-5; the program has the force at the ends of its steps.
MOTION, LARGEST = 1e-4, 2e-3
# Constants of Dowson and Higginson's density are rounded in two ways, 5.9e8 and 1.34 or 0.6e-9 and 1.7e-9.
DENSITY = 0.01
# Crowned faces touch on a part of their length, and ISO's teeth are loaded evenly: less stiff, but no other order.
CROWNED = 0.6


class Industries(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        cls.done = run_script(SCRIPTS / "studies/industries/run", cls.folder, "--commands", "info", "static", "bending",
                              "dry", "--time-limit", 60)

    def summary(self, pair, name):
        became = json.loads((self.folder / pair.name / f"{name}.json").read_text(encoding="utf-8"))
        self.assertEqual(became["status"], 0, became["errors"])
        return became["summary"]

    def assert_near(self, found, expected, tolerance, name):
        self.assertAlmostEqual(found / expected, 1, delta=tolerance, msg=name)

    def test_derived_quantities_are_those_of_the_textbooks(self):
        for pair in PAIRS:
            with self.subTest(pair.name):
                info, contact = self.summary(pair, "info"), hand.hertz(pair)
                for name, expected in (
                        ("contact_ratio", hand.contact_ratio(pair)), ("load", hand.tooth_force(pair)),
                        ("f_m", hand.mesh_frequency(pair)), ("m_ge", hand.equivalent_mass(pair)), ("a", contact.a),
                        ("b", contact.b), ("p_hertz", contact.pressure), ("hertz_approach", contact.approach),
                        ("f_n", hand.natural_frequency(pair)), ("entrainment_velocity", hand.entrainment(pair)),
                        ("hamrock_dowson_h_central", hand.hamrock_dowson(pair))):
                    self.assert_near(info[name], expected, EXACT, name)
                self.assert_near(info["nijenbanning_venner_moes_h_central"], hand.nijenbanning(pair), DENSITY, "film")
                self.assertLess(2 * info["b"], 0.85 * pair.width)  # the ellipse ends on the face

    def test_turned_slowly(self):
        for pair in PAIRS:
            with self.subTest(pair.name):
                rigid, (mean, swing) = self.summary(pair, "static"), hand.static_error(pair)
                self.assert_near(rigid["te_pitch"], hand.hertz(pair).approach, EXACT, "te_pitch")
                self.assert_near(rigid["te_mean"], mean, INTEGRAL, "te_mean")
                self.assert_near(rigid["te_peak_to_peak"], swing, INTEGRAL, "te_peak_to_peak")

    def test_teeth_that_bend_are_about_as_stiff_as_those_of_the_standard(self):
        for pair in PAIRS:
            with self.subTest(pair.name):
                bending, (single, factor) = self.summary(pair, "bending"), hand.iso_single(pair)
                self.assert_near(bending["iso_stiffness_single"], single, EXACT, "iso")
                self.assert_near(bending["mesh_stiffness_pitch"], single * factor, CROWNED, "stiffness")

    def test_dry_motion_repeats_in_another_integration(self):
        for pair in PAIRS[::2]:
            with self.subTest(pair.name):
                dry = self.summary(pair, "dry")
                change, largest = repeated(pair, dry["H0_after_leaving"], dry["V0_after_leaving"])
                self.assertLess(change, MOTION)
                self.assert_near(dry["force_ratio_max"], largest, LARGEST, "force_ratio_max")

    def test_tables(self):
        self.assertEqual((self.done.returncode, self.done.stderr), (0, ""))
        for pair in PAIRS:
            # Pairs, geometry, Hertz contact, teeth, commands.
            self.assertEqual(self.done.stdout.count(f"\n| {pair.name} |"), 5)
        for title in ("The pairs", "Hertz contact", "Teeth", "Commands"):
            self.assertIn(f"\n**{title}", self.done.stdout)
        self.assertIn("- `bending`, all: warning: an entering tooth meets its mate", self.done.stdout)

    def test_twelve_industries_and_all_commands(self):
        self.assertEqual(len({pair.industry for pair in PAIRS}), 12)
        self.assertEqual({words[0] for words in commands(PAIRS[0]).values()},
                         {"info", "static", "steady", "eigen", "transient", "periodic", "sweep", "continuation"})
        for pair in PAIRS:
            self.assertFalse([name for name in parameters(pair) if name.startswith(("grid.", "time.", "solver."))])


if __name__ == "__main__":
    unittest.main()
