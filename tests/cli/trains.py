"""What tests of drive trains share: the case study with tip relief, of given inertias, on bearings or with shafts, with
the numbers of tests/reference/drivetrain.json. Its grid on films is that of the reference.
"""
import json
import re

from films import summary_in
from program import INPUT, SOURCE, ProgramTest

REFERENCE = json.loads((SOURCE / "tests/reference/drivetrain.json").read_text(encoding="utf-8"))
CASE_STUDY = REFERENCE["table3"]["input"]
RELIEF = re.sub(r"^  equivalent_mass.*\n", "", (INPUT / "barbieri2013_relief.yaml").read_text(encoding="utf-8"),
                flags=re.MULTILINE)
for gear, inertia in zip(("pinion", "wheel"), CASE_STUDY["I"]):
    RELIEF = RELIEF.replace(f"{gear}:\n", f"{gear}:\n  inertia: {inertia!r}\n")
MASSES = ["-pinion_mass", CASE_STUDY["m"][0], "-wheel_mass", CASE_STUDY["m"][1]]
SHAFTS = ["-motor_inertia", 0.02, "-motor_shaft_stiffness", 2e4, "-load_inertia", 0.15, "-load_shaft_stiffness", 8e4]
GRID = ["-grid_nx", 97, "-grid_ny", 33]


def bearings(stiffness):
    return [*MASSES, "-pinion_bearing_stiffness", stiffness, "-wheel_bearing_stiffness", stiffness]


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
