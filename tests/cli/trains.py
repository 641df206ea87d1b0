"""What tests of drive trains share: the case study with tip relief, of given inertias, on bearings or with shafts, with
the numbers of tests/reference/drivetrain.json. Its grid on films is that of the reference.
"""
import sys

from films import summary_in
from program import SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "scripts"))
from studies.common.trains import CASE_STUDY, MASSES, REFERENCE, RELIEF, bearings  # noqa: E402,F401

SHAFTS = ["-motor_inertia", 0.02, "-motor_shaft_stiffness", 2e4, "-load_inertia", 0.15, "-load_shaft_stiffness", 8e4]
GRID = ["-grid_nx", 97, "-grid_ny", 33]


class TrainTest(ProgramTest):
    def summary(self, command, *options, processes=1):
        run = self.run_program(command, self.write_case(RELIEF), "-output_dir", command, *options, processes=processes)
        self.assertEqual(run.status, 0, run)
        self.warnings = run.stderr
        return summary_in(self.folder / command)

    def assert_frequencies(self, modes, expected, relative=1e-6):
        """expected: the rotation of the whole, which is no mode, first."""
        self.assertEqual(len(modes), len(expected) - 1)
        for mode, frequency in zip(modes, expected[1:]):
            self.assertAlmostEqual(mode["frequency_dry"] / frequency, 1, delta=relative)
