"""Wrong input from outside: one message, exit status 1, nothing written."""
import unittest

from films import BARBIERI, CIRCULAR, WANG
from program import INPUT, SOURCE, ProgramTest
from vibration import barbieri_with_inertias


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


if __name__ == "__main__":
    unittest.main()
