"""Heights that travel with the flanks, and flanks that wear, from outside.

Waves pass a slender contact at the pitch point of two like gears, held there by a large mass: amplitudes that are left
in its middle against those of line contacts in tests/reference/rough.json. Environment as for cli_test.py.
"""
import json
import math
import signal
import unittest

import numpy

from films import SAME, summary_in
from program import INPUT, SOURCE
from restarts import MARCH, RestartTest, stopped_after
from vibration import table_in

REFERENCE = json.loads((SOURCE / "tests/reference/rough.json").read_text(encoding="utf-8"))
MODULUS, VISCOSITY, COEFFICIENT = 2.26e11, 0.04, 2.2e-8
RADIUS = 60e-3 * math.sin(math.radians(20)) / 2  # reduced, at the pitch point
PAIR = """
case: {name: waves}
pinion: {teeth: 30, outer_radius: 64e-3, crowning: 10e-6, youngs_modulus: 205.66e9, poisson_ratio: 0.3, SPEED}
wheel: {teeth: 30, outer_radius: 64e-3, crowning: 10e-6, youngs_modulus: 205.66e9, poisson_ratio: 0.3}
gear: {module: 4e-3, pressure_angle_deg: 20, centre_distance: 120e-3, face_width: 20e-3, equivalent_mass: 10}
lubricant: {viscosity: 0.04, pressure_viscosity: 2.2e-8}
geometry: held
"""
GROUND = ["-pinion_roughness", "0.4e-6", "-wheel_roughness", "0.4e-6"]
FIRST_GEAR = INPUT / "first_gear.yaml"
SLOW = ["-pinion_speed_rpm", 300, "-motion", "quasi_static", "-grid_nx", 65, "-grid_ny", 17]
WORN = [INPUT / "mixed_first_gear.yaml", *SLOW, "-wear_coefficient_pinion", "2e-17", "-wear_coefficient_wheel", "1e-17"]


class Waves(RestartTest):
    def pair(self, load, lubricant):
        """Case file of a contact with Moes' groups of a line, its half-width and its mesh period."""
        speed = (lubricant / (COEFFICIENT * MODULUS))**4 * MODULUS * RADIUS / (2 * VISCOSITY)
        pressure = MODULUS * math.sqrt(load * math.sqrt(speed * 2 * VISCOSITY / (MODULUS * RADIUS)) / (2 * math.pi))
        rpm = speed / (60e-3 * math.sin(math.radians(20))) * 30 / math.pi
        at_1_nm = self.derived(rpm, 1.0)["p_hertz"]
        torque = (pressure / at_1_nm)**3
        self.assertAlmostEqual(self.derived(rpm, torque)["p_hertz"], pressure, delta=1e-6 * pressure)
        return self.derived(rpm, torque)

    def derived(self, rpm, torque):
        self.case = self.write_case(PAIR.replace("SPEED", f"speed_rpm: {rpm:.12g}, torque: {torque:.12g}"))
        self.run_well("info", self.case, "-output_dir", "info")
        return summary_in(self.folder / "info")

    def middle(self, info, length, *options):
        """T and film in the middle of the contact, once waves of a length [a] have come there."""
        passages = (4.5 + 2 * length) / info["mesh_period_dimensionless"]
        self.run_well("transient", self.case, "-roughness_model", "deterministic", "-mesh_periods", passages,
                      "-output_dir", "waves", *options)
        contacts = table_in(self.folder / "waves", "history/contacts")
        late = (contacts["T"] > 4.5) & (contacts["contact"] == 0)
        return contacts["T"][late], contacts["h_central"][late]

    def test_waves_are_flattened_as_in_line_contacts(self):
        for row in REFERENCE["waves"]:
            with self.subTest(**row):
                info = self.pair(row["M"], row["L"])
                amplitude, length = 0.1 * info["nijenbanning_venner_moes_h_central"], row["wavelength"]
                _, film = self.middle(info, length, "-roughness_amplitude_1", amplitude, "-roughness_wavelength_1",
                                      length * info["a"])
                self.assertAlmostEqual(numpy.ptp(film) / 2 / amplitude, row["left"], delta=0.03)

    def test_what_is_left_of_low_waves_goes_with_their_height(self):
        info, length = self.pair(20, 10), 2.0
        heights = []
        for amplitude in (4e-9, 1.6e-8):
            _, film = self.middle(info, length, "-roughness_amplitude_1", amplitude, "-roughness_wavelength_1",
                                  length * info["a"])
            heights.append(numpy.ptp(film) / amplitude)
        self.assertAlmostEqual(heights[0] / heights[1], 1, delta=0.02)

    def test_heights_travel_with_their_flank(self):
        """Behind the pitch point the pinion is the faster one: its waves pass sooner, by the ratio of velocities."""
        info, length, beside = self.pair(20, 10), 1.0, 4e-3
        ratio = 1 + beside / (2 * RADIUS)  # u_1/u_m
        for flank, speed in ((1, ratio), (2, 2 - ratio)):
            T, film = self.middle(info, 3 * length, "-start_place", "position", "-start_position", beside,
                                  f"-roughness_amplitude_{flank}", 2e-9, f"-roughness_wavelength_{flank}",
                                  length * info["a"], "-time_dt", 0.02)
            ups = numpy.flatnonzero(numpy.diff(numpy.sign(film - film.mean())) > 0)
            level = film - film.mean()
            crossings = T[ups] - level[ups] * (T[ups + 1] - T[ups]) / (level[ups + 1] - level[ups])
            self.assertAlmostEqual(numpy.diff(crossings).mean(), length / speed, delta=0.01 * length)

    def test_waves_along_the_rolling_stand_in_a_contact_at_rest(self):
        """A crest in the middle of the face raises the pressure there, by twice as much if it is twice as high."""
        pressures = []
        for amplitude in (0, 1e-7, 2e-7):
            self.run_well("steady", FIRST_GEAR, *GROUND, "-roughness_model", "both", "-roughness_direction",
                          "longitudinal", "-roughness_amplitude_1", amplitude, "-roughness_wavelength_1", "16e-3",
                          "-grid_nx", 65, "-grid_ny", 65, "-output_dir", "ridges")
            pressures.append(summary_in(self.folder / "ridges")["p_central"])
        self.assertGreater(pressures[1], 1.0005 * pressures[0])
        self.assertAlmostEqual((pressures[2] - pressures[0]) / (pressures[1] - pressures[0]), 2, delta=0.02)

    def test_a_measured_profile_makes_the_film_of_its_heights(self):
        """A sine of three times the cutoff, in a file of points and in one of ISO 25178-71."""
        info = self.pair(20, 10)
        amplitude, length = 1e-8, 1.5 * info["a"]
        middle = (60e-3 * math.sin(math.radians(20)))**2 / (2 * 60e-3 * math.cos(math.radians(20)))
        step, count = length / 40, 1601
        s = middle + step * (numpy.arange(count) - (count - 1) / 2)
        z = amplitude * numpy.cos(2 * math.pi * s / length)
        points = "".join(f"{place:.12e}, {height:.12e}\n" for place, height in zip(s, z))
        header = f"aISO-1.0\nNumPoints = {count}\nNumProfiles = 1\nXscale = {step}\nYscale = 1\nZscale = 1e-12\n*\n"
        (self.folder / "sine.csv").write_text("# s [m], z [m]\n" + points, encoding="utf-8")
        (self.folder / "sine.sdf").write_text(header + "\n".join(f"{1e12 * height:.6f}" for height in z) + "\n*\n",
                                              encoding="utf-8")
        _, waves = self.middle(info, 1.5, "-roughness_amplitude_1", amplitude, "-roughness_wavelength_1", length,
                               "-grid_nx", 385, "-time_dt", 0.011)
        for name in ("sine.csv", "sine.sdf"):
            _, film = self.middle(info, 1.5, "-pinion_surface", self.folder / name, "-roughness_cutoff", length / 3,
                                  "-grid_nx", 385, "-time_dt", 0.011)
            self.assertLess(numpy.abs(film - waves).max(), 0.1 * amplitude)

    def test_what_is_shorter_than_the_cutoff_belongs_to_the_asperities(self):
        """Of waves of half the cutoff the Gaussian filter leaves a sixteenth to the heights."""
        info, amplitude = self.pair(20, 10), 1e-7
        cutoff = 3 * info["a"]
        s = 5e-3 + cutoff / 80 * numpy.arange(1601)
        z = amplitude * numpy.cos(4 * math.pi * s / cutoff)
        rows = (f"{place:.12e} {height:.12e}\n" for place, height in zip(s, z))
        (self.folder / "short").write_text("".join(rows), encoding="utf-8")
        self.run_well("transient", self.case, "-roughness_model", "both", "-pinion_surface", self.folder / "short",
                      "-roughness_cutoff", cutoff, "-mesh_periods", 0.02, "-output_dir", "fine")
        contacts = table_in(self.folder / "fine", "history/contacts")
        roughness = contacts["h_min"] / contacts["lambda"]
        self.assertAlmostEqual(roughness[-1], 15 / 16 * amplitude / math.sqrt(2), delta=5e-3 * amplitude)

    def test_a_measured_profile_is_a_profile_of_the_same_depth(self):
        """Given as heights along the flank, or as what the flank lacks of its involute; the filter leaves 0.926."""
        info, amplitude, base = self.pair(20, 10), 1e-8, 60e-3 * math.cos(math.radians(20))
        length = 1.5 * info["a"]
        rho = numpy.linspace(5e-3, 36e-3, 6001)
        s = numpy.linspace(rho[0]**2, rho[-1]**2, rho.size) / (2 * base)
        wave = [amplitude * numpy.cos(2 * math.pi * place / length) for place in (s, rho**2 / (2 * base))]
        for name, places, heights in (("heights", s, wave[0]), ("profile", rho, -0.926 * wave[1])):
            rows = (f"{place:.12e} {height:.12e}\n" for place, height in zip(places, heights))
            (self.folder / name).write_text("".join(rows), encoding="utf-8")
        films = []
        for options in (["-pinion_surface", self.folder / "heights", "-roughness_model", "deterministic",
                         "-roughness_cutoff", length / 3],
                        ["-pinion_profile_file", self.folder / "profile", "-gear_profile_local", "field"],
                        []):
            self.run_well("transient", self.case, "-geometry", "moving", "-mesh_periods", 0.1, "-grid_nx", 385,
                          "-time_dt", 0.011, "-output_dir", "moving", *options)
            contacts = table_in(self.folder / "moving", "history/contacts")
            films.append(contacts["h_central"][contacts["contact"] == 0])
        heights, profile, plain = films
        self.assertGreater(numpy.abs(profile - plain).max(), 0.2 * amplitude)
        self.assertLess(numpy.abs(heights - profile).max(), 0.1 * amplitude)

    def test_heights_over_asperities_repeat_with_the_mesh_on_two_processes_too(self):
        found = []
        for processes in (1, 2):
            self.run_well("periodic", FIRST_GEAR, *GROUND, "-pinion_speed_rpm", 1000, "-motion", "quasi_static",
                          "-roughness_model", "both", "-roughness_amplitude_1", "0.4e-6", "-roughness_wavelength_1",
                          "1e-3", "-grid_ny", 17, "-output_dir", "both", processes=processes)
            found.append(summary_in(self.folder / "both")["asperity_load_share_mean"])
        self.assertAlmostEqual(found[0], found[1], delta=SAME)

    def test_a_march_with_heights_and_wear_goes_on_to_the_bit(self):
        march = [*MARCH, *GROUND, "-roughness_model", "both", "-roughness_amplitude_2", "0.1e-6",
                 "-roughness_wavelength_2", "4e-3", "-wear_coefficient_wheel", "1e-17"]
        outcome = stopped_after(5, [*march, "-output_dir", "run"], self.folder, signal.SIGUSR1)
        self.assertEqual(outcome.status, 3, outcome)
        self.assert_same(self.complete(*march), self.uninterrupted(*march))


class Wear(RestartTest):
    def worn(self, *options, cycles=3.5e4, processes=1):
        self.run_well("wear", *WORN, "-wear_cycles", cycles, "-output_dir", "worn", *options, processes=processes)
        return summary_in(self.folder / "worn")

    def test_flanks_lose_what_asperities_rub_off(self):
        worn = self.worn()
        first, second = worn["steps"][:2]
        revolutions, period = second["revolutions"], 60 / (15 * 300)
        for gear, passages in (("pinion", 1), ("wheel", 15 / 47)):
            lost = second[f"worn_volume_{gear}"] / (passages * revolutions)
            expected = first[f"wear_rate_{gear}_mean"] * period
            self.assertLess(abs(lost / expected - 1), 1e-12)
            # What one passage takes, by the contact as it is while a place passes.
            depth = second[f"worn_depth_{gear}"] / (passages * revolutions)
            self.assertAlmostEqual(depth / first[f"wear_depth_{gear}_max"], 1, delta=0.15)
        self.assertAlmostEqual(worn["worn_volume_pinion"] / worn["worn_volume_wheel"], 2 * 47 / 15, delta=1e-2)
        # At the pitch point nothing slides; contacts are a few tenths of a millimetre wide.
        places = table_in(self.folder / "worn", "wear/pinion")
        middle = places[places["y"] == 0]
        at_pitch = numpy.argmin(numpy.abs(middle["roll_angle"] - math.tan(math.radians(20))))
        self.assertLess(middle["depth"][at_pitch], 0.2 * middle["depth"].max())

    def test_a_run_goes_on_to_the_bit_on_other_processes_nearly(self):
        runs_in = ["-wear_final_roughness", "0.2e-6", "-wear_running_in_work", 3e7]
        whole = self.worn(*runs_in, cycles=3e3)
        steps = sorted((self.folder / "worn/points").iterdir())
        self.assertGreater(len(steps), 2)
        for last in steps[-2:]:
            last.unlink()
        again = self.worn(*runs_in, cycles=3e3)
        for name in ("worn_depth_pinion", "worn_depth_wheel", "worn_volume_pinion", "roughness"):
            self.assertEqual(again[name], whole[name])
        for step in steps:
            step.unlink()
        together = self.worn(*runs_in, cycles=3e3, processes=2)
        self.assertAlmostEqual(together["worn_depth_pinion"] / whole["worn_depth_pinion"], 1, delta=1e-6)

    def test_roughness_runs_in_and_unloads_asperities(self):
        worn = self.worn("-wear_final_roughness", "0.2e-6", "-wear_running_in_work", 3e7)
        roughness = [step["roughness"] for step in worn["steps"]] + [worn["roughness"]]
        self.assertEqual(roughness, sorted(roughness, reverse=True))
        self.assertLess(roughness[-1], 0.9 * roughness[0])
        self.assertLess(worn["steps"][-1]["asperity_load_share_mean"], worn["steps"][0]["asperity_load_share_mean"])


if __name__ == "__main__":
    unittest.main()
