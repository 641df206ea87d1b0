"""Legal but odd values: one warning each on stderr, and the run goes on."""
import re
import unittest

from films import BARBIERI, CIRCULAR, WANG, summary_in
from program import ProgramTest

# Case, options, words of each warning in turn.
ODD = [
    (BARBIERI, ["-pinion_torque", 20000],
     [["Hertz pressure is 8.922 GPa", "hardened steel"],  # along the whole face, which the contact reaches
      ["'grid.ny' is given", "grid.first_row"]]),
    (BARBIERI, ["-pinion_torque", 0.002], [["Hertz pressure is 0.04639 GPa"], ["central film", "um", "thicker"]]),
    (CIRCULAR, ["-contact_radius_x", 12.5, "-contact_radius_y", 12.5],
     [["Hertz pressure is 0.004496 GPa", "below 0.05 GPa"], ["central film", "thicker"]]),
    (CIRCULAR, ["-contact_entrainment_velocity", 250],
     [["'contact.entrainment_velocity' is 250 m/s", "faster"], ["central film", "thicker"]]),
    (BARBIERI, ["-lubricant_viscosity", 1e-3], [["'lubricant.viscosity' is 0.001 Pa s", "water"]]),
    (BARBIERI, ["-lubricant_viscosity", 40],
     [["'lubricant.viscosity' is 40 Pa s", "mPa s"], ["central film", "thicker"]]),
    (BARBIERI, ["-lubricant_pressure_viscosity", 2e-9], [["'lubricant.pressure_viscosity' is 2e-09 1/Pa"]]),
    (BARBIERI, ["-lubricant_pressure_viscosity", 1e-7], [["'lubricant.pressure_viscosity' is 1e-07 1/Pa"]]),
    (WANG, ["-wheel_youngs_modulus", 30e9], [["'wheel.youngs_modulus' is 3e+10 Pa", "softer"]]),
    (WANG, ["-wheel_youngs_modulus", 1e12], [["'wheel.youngs_modulus' is 1e+12 Pa", "stiffer"]]),
    (BARBIERI, ["-pinion_speed_rpm", 50000], [["pitch-line velocity is 229.2 m/s", "faster"]]),
    (BARBIERI, ["-gear_equivalent_mass", 370.9], [["equivalent mass is 370.9 kg", "steel discs"]]),
    (BARBIERI, ["-gear_equivalent_mass", 0.3709e-3], [["equivalent mass is 0.0003709 kg", "steel discs"]]),
    (WANG, ["-lubricant_viscosity", 2.2e-3, "-pinion_speed_rpm", 100], [["central film", "roughness"]]),
    (BARBIERI, ["-time_dt", 0.5], [["time steps a mesh period is 15", "below 30", "time.dt"],
                                    ["time steps a free oscillation is 20.4", "below 30", "vibration"]]),
    (BARBIERI, ["-mesh_periods", 1e6], [["time steps of a march is 2.88e+08", "mesh_periods"]]),
    (CIRCULAR, ["-grid_nx", 17, "-grid_ny", 17], [["half-axis a", "grid.nx"], ["half-axis b", "grid.ny"]]),
]


class Oddities(ProgramTest):
    def assert_warned(self, run, warnings):
        self.assertEqual(run.status, 0, run)
        lines = run.stderr.splitlines()
        self.assertEqual(len(lines), len(warnings), run)
        for line, words in zip(lines, warnings):
            self.assertTrue(line.startswith("gearfilm: warning: "), run)
            for word in words:
                self.assertIn(word, line)

    def test_each_is_said_once_and_the_run_goes_on(self):
        for case, options, warnings in ODD:
            with self.subTest(options=options):
                self.assert_warned(self.run_program("info", case, *options, "-output_dir", "odd"), warnings)
                self.assertIn("M", summary_in(self.folder / "odd"))

    def test_module_of_a_watch(self):
        """All lengths of the case a twentieth, and the torque in proportion to stress."""
        text = re.sub(r"((?:radius|crowning|module|distance|width): )([\d.e-]+)",
                      lambda given: given[1] + f"{float(given[2]) / 20:.10g}", BARBIERI.read_text(encoding="utf-8"))
        case = self.write_case(text.replace("torque: 470", "torque: 0.05875").replace("equivalent_mass: 0.3709",
                                                                                     "equivalent_mass: 4.6e-5"))
        self.assert_warned(self.run_program("info", case), [["'gear.module' is 0.00015 m", "finer"]])

    def test_two_processes_say_it_once_before_a_film(self):
        run = self.run_program("steady", WANG, "-lubricant_pressure_viscosity", 4e-9, processes=2)
        self.assert_warned(run, [["'lubricant.pressure_viscosity' is 4e-09 1/Pa"]])


if __name__ == "__main__":
    unittest.main()
