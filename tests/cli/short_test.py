"""Every command of the program for a moment: for the sanitizers and for valgrind. Environment as for cli_test.py.

Other tests hold the numbers; what these add is that every part of the program runs, and that only errors are said on
stderr.
"""
import unittest

from films import BARBIERI, summary_in
from program import INPUT, ProgramTest

COARSE = ["-grid_nx", 33, "-grid_ny", 17, "-time_dt", 0.24]
# The films of a tenth of the case study's torque are thick enough for this grid and these steps.
LIGHT = [*COARSE, "-pinion_torque", 50]
FEW_PERIODS = ["-periodic_tolerance", 0.1, "-periodic_film_tolerance", 0.9]


class Short(ProgramTest):
    def test_steady_on_2_processes(self):
        self.run_well("steady", BARBIERI, *LIGHT, processes=2)

    def test_march_through_an_entry_on_2_processes(self):
        self.march("-mesh_periods", 0.5, "-output_snapshot_interval", 0.1, processes=2)

    def test_march_of_one_contact(self):
        for model in ("quasistatic", "simplified"):
            with self.subTest(model=model):
                self.march("-model", model)

    def test_march_of_the_dry_pair(self):
        self.march("-model", "dry", "-mesh_periods", 1, "-output_spectrum_periods", 0.5)

    def test_periodic(self):
        self.run_well("periodic", BARBIERI, *LIGHT, *FEW_PERIODS)

    def test_eigen(self):
        self.run_well("eigen", BARBIERI, *LIGHT)

    def test_continuation(self):
        self.run_well("continuation", BARBIERI, *LIGHT, "-model", "dry", "-continuation_from", 26600,
                      "-continuation_to", 26300)

    def test_sweep(self):
        self.run_well("sweep", BARBIERI, *LIGHT, *FEW_PERIODS, "-periodic_multipliers", "no", "-sweep_values", "15000",
                      "-sweep_direction", "up")

    def test_wear(self):
        self.run_well("wear", INPUT / "mixed_first_gear.yaml", "-pinion_speed_rpm", 300, "-grid_nx", 49, "-grid_ny", 13,
                      "-time_dt", 0.24, "-wear_cycles", 10)

    def test_waves_and_stresses(self):
        self.march("-roughness_model", "both", "-pinion_roughness", "0.1e-6", "-roughness_amplitude_2", "0.1e-6",
                   "-roughness_wavelength_2", "0.05", "-stress_model", "row", "-mesh_periods", 0.2)

    def test_drive_train(self):
        self.run_well("info", INPUT / "electric_reducer.yaml")

    def test_wrong_inputs(self):
        self.assert_wrong(["-1"], "steady", BARBIERI, "-lubricant_viscosity", -1)
        self.assert_wrong(["list"], "info", self.write_case("pinion: [28]\n"), processes=2)

    def test_film_that_is_not_positive(self):
        run = self.run_program("steady", BARBIERI, *COARSE, "-steady_position", -5.63e-3)
        self.assert_message(run, 2, "gearfilm: not solved: ", ["not positive"])

    def march(self, *options, **arguments):
        self.run_well("transient", BARBIERI, *LIGHT, "-output_dir", "march", *options, **arguments)
        self.assertTrue(summary_in(self.folder / "march")["completed"])


if __name__ == "__main__":
    unittest.main()
