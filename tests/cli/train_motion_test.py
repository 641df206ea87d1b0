"""Drive trains in motion, dry and on films, from outside, against the numbers of tests/reference/drivetrain.json.
Environment as for cli_test.py.
"""
import shutil
import unittest

import numpy

from films import SAME, summary_in
from program import INPUT
from restarts import stopped_after
from trains import CASE_STUDY, GRID, MASSES, REFERENCE, RELIEF, SHAFTS, TrainTest, bearings
from vibration import table_in


class DryMotion(TrainTest):
    def damped_bearings(self, stiffness):
        """With 0.04 sqrt(k m), 2 % of the critical damping of each gear on its own."""
        file = self.folder / f"bearings_{stiffness}.train"
        file.write_text("".join(f"bearing {gear} {stiffness} {stiffness} 0 0 {c!r} {c!r}\n" for gear, c in zip(
            ("pinion", "wheel"), (0.04 * (stiffness * mass) ** 0.5 for mass in CASE_STUDY["m"]))), encoding="utf-8")
        return [*MASSES, "-train_file", file]

    def periodic(self, *options, zeta=0.05):
        return self.summary("periodic", "-model", "dry", "-dry_damping_ratio", zeta, *options)

    def assert_moduli(self, summary, expected, relative):
        """Of pairs of multipliers, in any order."""
        found = sorted(abs(complex(*mu)) for mu in summary["floquet"])
        self.assertEqual(len(found), 2 * len(expected))
        for n, modulus in enumerate(sorted(expected)):
            for one in found[2 * n:2 * n + 2]:
                self.assertAlmostEqual(one / modulus, 1, delta=relative)

    def test_two_gears_that_only_turn_move_as_the_pair(self):
        expected, tolerance = REFERENCE["dry_orbit_1dof"], REFERENCE["dry_orbit_1dof"]["tol"]
        orbit = self.periodic("-train_damping_ratio", 0)
        self.assertAlmostEqual(orbit["H0_after_leaving"] / expected["H0"], 1, delta=tolerance["H0"])
        self.assertAlmostEqual(orbit["V0_after_leaving"], expected["V0"], delta=2 * tolerance["V0_abs"])
        self.assertAlmostEqual(orbit["total_force_ratio_max"], expected["total_force_ratio_max"],
                               delta=tolerance["force"])
        self.assert_moduli(orbit, [abs(complex(*expected["multiplier"]))], tolerance["mu"])

    def test_orbits_on_bearings_are_those_of_the_reference(self):
        tolerance = REFERENCE["dry_orbit_bearings"]["tol"]
        for stiffness in ("1e10", "1e9", "1e8"):
            with self.subTest(stiffness=stiffness):
                expected = REFERENCE["dry_orbit_bearings"][stiffness]
                orbit = self.periodic(*self.damped_bearings(float(stiffness)))
                self.assertAlmostEqual(orbit["H0_after_leaving"] / expected["H0"], 1, delta=tolerance["H0"])
                self.assertAlmostEqual(orbit["V0_after_leaving"], expected["V0"], delta=tolerance["V0_abs"])
                self.assertAlmostEqual(orbit["total_force_ratio_max"], expected["total_max"], delta=tolerance["force"])
                # Across the line of action gears on such bearings do not move: three pairs of multipliers.
                self.assert_moduli(orbit, expected["mu_abs"], tolerance["mu"])
                self.assertLess(orbit["floquet_modulus_error"], 1e-6)
                self.assertIsNone(orbit["free_frequency"])

    def test_resonances_over_the_speed_are_those_of_the_reference(self):
        tolerance = REFERENCE["speed_sweep"]["tol"]["total_max"]
        for stiffness, speeds in ((1e9, (6500, 13000)), (1e8, (7000, 7500))):
            sweep = self.summary("sweep", "-model", "dry", "-dry_damping_ratio", 0.02, "-sweep_direction", "up",
                                 "-sweep_values", ", ".join(map(str, speeds)), "-periodic_multipliers", "no",
                                 *self.damped_bearings(stiffness))
            expected = {row[0]: row[1] for row in
                        REFERENCE["speed_sweep"]["rpm__total_max__total_min"][str(stiffness)]}
            self.assertEqual(sweep["points_found"], 2)
            for point in sweep["points"]:
                self.assertAlmostEqual(point["total_force_ratio_max"] / expected[point["value"]], 1, delta=tolerance)
            shutil.rmtree(self.folder / "sweep")

    def test_loads_of_the_bearings_and_the_balance_of_energy(self):
        orbit = self.periodic(*self.damped_bearings(1e9))
        for gear, loads, mass in zip(("pinion", "wheel"), orbit["bearing_forces"], CASE_STUDY["m"]):
            self.assertEqual(loads["bearing"], f"bearing_{gear}")
            self.assertAlmostEqual(loads["force_mean"] / orbit["static_force"], 1, delta=1e-6)
            self.assertAlmostEqual(numpy.hypot(loads["force_x_mean"], loads["force_y_mean"]) / loads["force_mean"], 1,
                                   delta=1e-6)  # all along the line of action
            rows, damper = table_in(self.folder / "periodic", "history/train"), 0.04 * (1e9 * mass) ** 0.5
            force = 1e9 * rows[f"x_{gear}"] + damper * rows[f"x_velocity_{gear}"]
            self.assertLess(abs(force - rows[f"bearing_{gear}_x"]).max(), 1e-9 * abs(force).max())
        moved = numpy.flatnonzero(numpy.diff(rows["t"]) > 0)
        way = numpy.diff(rows["x_pinion"])[moved]
        mean = (0.5 * (rows["x_velocity_pinion"][1:] + rows["x_velocity_pinion"][:-1]) * numpy.diff(rows["t"]))[moved]
        self.assertLess(abs(way - mean).max(), 1e-3 * abs(way).max())
        self.assertLess(orbit["energy_balance_residual"], 1e-4)
        self.assertAlmostEqual(orbit["work_of_teeth"] / orbit["dissipated_energy"], 1, delta=1e-3)
        self.assertLess(abs(orbit["stored_energy_change"]), 1e-6 * orbit["dissipated_energy"])
        orders = table_in(self.folder / "periodic", "orders")
        numpy.testing.assert_allclose(orders["order"], 28 * numpy.arange(1, len(orders) + 1), rtol=1e-9)
        swing = numpy.ptp(rows["bearing_pinion_x"]) / 2
        self.assertTrue(0.8 < orders["bearing_pinion_x"][0] / swing < 1.2)

    def test_an_imposed_speed_is_that_of_a_vast_inertia(self):
        file = self.folder / "line.train"
        file.write_text("node motor pinion 0.02\nshaft motor pinion 2e4\nfixed motor\n", encoding="utf-8")
        shaft = ["-motor_shaft_stiffness", 2e4]
        by_key, by_file = self.periodic(*shaft, "-motor_fixed", "yes"), self.periodic("-train_file", file)
        vast = self.periodic(*shaft, "-motor_inertia", 1e6)
        self.assertEqual(by_key["floquet"], by_file["floquet"])
        self.assertAlmostEqual(by_key["total_force_ratio_max"], vast["total_force_ratio_max"], delta=1e-8)
        for ours, theirs in zip(by_key["floquet"], vast["floquet"]):
            self.assertAlmostEqual(abs(complex(*ours)), abs(complex(*theirs)), delta=1e-5)
        self.assertLess(by_key["energy_balance_residual"], 1e-4)

    def test_a_run_up_loads_the_teeth_where_it_is_asked_for(self):
        end = 15300
        march = self.summary("transient", "-model", "dry", "-dry_damping_ratio", 0.05, "-mesh_periods", 100,
                             "-ramp_to_rpm", end, "-ramp_inertia_torque", "yes", *Ripple.LINE)
        rows = table_in(self.folder / "transient", "history/steps")
        late = rows[rows["T"] > 0.5 * rows["T"].max()]
        force = (numpy.diff(late["t"]) * (late["force_total"][1:] + late["force_total"][:-1]) / 2).sum()
        acceleration = (end - 15000) * 2 * numpy.pi / 60 / rows["t"].max()
        taken = (0.02 + CASE_STUDY["I"][0]) * acceleration / 470
        self.assertAlmostEqual(force / numpy.ptp(late["t"]) / march["static_force"], 1 - taken, delta=1e-3)
        self.assertLess(march["energy_balance_residual"], 1e-4)

    def test_a_sweep_over_a_number_of_the_train(self):
        sweep = self.summary("sweep", "-model", "dry", "-dry_damping_ratio", 0.05, "-sweep_direction", "up",
                             "-sweep_over", "motor.shaft_stiffness", "-sweep_values", "1e4, 2e4", *Ripple.LINE)
        orbit = self.periodic(*Ripple.LINE)
        soft, stiff = sweep["points"]
        self.assertEqual((sweep["over"], soft["value"]), ("motor.shaft_stiffness", 1e4))
        self.assertAlmostEqual(stiff["floquet_modulus"] / orbit["floquet_modulus"], 1, delta=1e-7)
        self.assertGreater(abs(soft["floquet_modulus"] - stiff["floquet_modulus"]), 1e-4)

    def test_a_train_has_the_same_motions_at_all_speeds(self):
        file = self.folder / "coupling.train"
        file.write_text("node coupling pinion 2e-3\nshaft coupling pinion 3e4 0.5\n", encoding="utf-8")
        run = self.run_program("sweep", INPUT / "electric_reducer.yaml", "-model", "dry", "-sweep_values",
                               "8238.19, 8277.89, 8317.59", "-sweep_direction", "up", "-train_file", file,
                               "-output_dir", "sweep")
        self.assertEqual(run.status, 0, run)
        for point in summary_in(self.folder / "sweep")["points"]:
            self.assertEqual(len(point["states_after_leaving"][0]), 12)  # 6 and their velocities

    def test_a_march_settles_on_the_periodic_motion(self):
        bearings_at = self.damped_bearings(1e9)
        orbit = self.periodic(*bearings_at)
        march = self.summary("transient", "-model", "dry", "-dry_damping_ratio", 0.05, "-mesh_periods", 40,
                             "-start_place", "after_leaving", *bearings_at)
        self.assertAlmostEqual(march["settling"]["modulus"], orbit["floquet_modulus"], delta=2e-3)
        self.assertEqual(march["settles_on"], 1)

    def test_a_march_goes_on_to_the_bit(self):
        march = ["transient", self.write_case(RELIEF), "-model", "dry", "-keep_checkpoint", "yes", "-start_place",
                 "after_leaving", "-output_dir"]
        self.run_program(*march, "whole", "-mesh_periods", 6, *SHAFTS)
        self.run_program(*march, "parts", "-mesh_periods", 3, *SHAFTS)
        run = self.run_program(*march, "parts", "-mesh_periods", 6, "-restart", "yes", *SHAFTS)
        self.assertEqual(run.status, 0, run)
        whole, parts = (table_in(self.folder / name, "history/steps") for name in ("whole", "parts"))
        self.assertEqual(whole["H0"].tolist(), parts["H0"].tolist())

    def test_marches_of_a_sweep_go_on_where_they_were_stopped(self):
        """From all displacements and velocities, not from those of the flanks alone; basins start from these."""
        sweep = ["sweep", self.write_case(RELIEF), "-model", "dry", "-dry_damping_ratio", 0.05, "-sweep_kind",
                 "marches", "-sweep_values", "15000, 15100, 15200", "-sweep_direction", "up", "-sweep_march_periods", 3,
                 "-sweep_kept_periods", 2, *self.damped_bearings(1e9)]
        self.run_well(*sweep, "-output_dir", "whole")
        stopped = stopped_after(1, [*sweep, "-output_dir", "parts"], self.folder)
        self.assertEqual(stopped.status, 3, stopped)
        self.run_well(*sweep, "-output_dir", "parts")
        whole, parts = (summary_in(self.folder / name)["points"] for name in ("whole", "parts"))
        for ours, theirs in zip(parts, whole):
            self.assertEqual(len(theirs["state_after_leaving"]), 6)  # 3 and their velocities
            self.assertEqual(ours["state_after_leaving"], theirs["state_after_leaving"])
        basins = self.summary("sweep", "-model", "dry", "-dry_damping_ratio", 0.05, "-sweep_kind", "basins",
                              "-sweep_starts", 2, "-sweep_march_periods", 20, "-sweep_kept_periods", 16,
                              "-sweep_H0_from", -3, "-sweep_H0_to", -2, "-sweep_V0_from", -1, "-sweep_V0_to", 1,
                              *self.damped_bearings(1e9))
        self.assertEqual([point["H0"] for point in basins["points"]], [-3, -3, -2, -2])
        self.assertEqual(basins["points_failed"], 0)

    def test_a_branch_is_followed_through_a_resonance(self):
        branch = self.summary("continuation", "-model", "dry", "-dry_damping_ratio", 0.05, "-continuation_from", 12480,
                              "-continuation_to", 12520, *self.damped_bearings(1e9))
        self.assertEqual(branch["bifurcations"], [])
        self.assertEqual(branch["branches"][0]["last_value"], 12520)


class MotionOnFilms(TrainTest):
    """On the films of 97 x 33 nodes."""

    def steps(self, folder):
        return table_in(self.folder / folder, "history/steps")

    def damped_bearings(self):
        return [*bearings(1e9), "-train_damping_ratio", 0.01]

    def test_two_gears_that_only_turn_march_as_the_pair(self):
        march = ["transient", self.write_case(RELIEF), *GRID, "-mesh_periods", 1, "-friction_law", "eyring",
                 "-friction_in_motion", "yes", "-output_dir"]
        self.run_program(*march, "pair")
        self.run_program(*march, "train", "-train_damping_ratio", 0)
        pair, train = self.steps("pair"), self.steps("train")
        self.assertLess(abs(pair["H0"] - train["H0"]).max(), 1e-8)
        self.assertEqual(pair["newton"].sum(), train["newton"].sum())

    def test_an_imposed_speed_is_that_of_a_vast_inertia(self):
        for folder, options in (("held", ["-motor_fixed", "yes"]), ("vast", ["-motor_inertia", 1e6])):
            self.run_well("transient", self.write_case(RELIEF), *GRID, "-mesh_periods", 1, "-motor_shaft_stiffness", 2e4,
                          "-output_dir", folder, *options)
        held, vast = self.steps("held"), self.steps("vast")
        self.assertLess(abs(held["H0"] - vast["H0"]).max(), 1e-7)

    def test_bodies_in_balance_leave_their_train_at_rest(self):
        march = ["transient", self.write_case(RELIEF), *GRID, "-mesh_periods", 1, "-motion", "quasi_static",
                 "-output_dir"]
        self.run_well(*march, "pair")
        self.run_well(*march, "train", *SHAFTS, *bearings(1e9))
        self.assertEqual(self.steps("pair")["H0"].tolist(), self.steps("train")["H0"].tolist())
        summary = summary_in(self.folder / "train")
        self.assertAlmostEqual(summary["shaft_torques"][0]["torque_max"], 470, delta=1e-9)
        for load in summary["bearing_forces"]:
            self.assertAlmostEqual(load["force_mean"] / summary["static_force"], 1, delta=1e-9)

    def test_a_ring_down_on_bearings_has_the_modes_of_the_reference(self):
        """Of motions that are sums of damped oscillations, by the linear map from one span of the signal to the next."""
        rest = self.summary("eigen", *GRID)["H0"]
        self.summary("transient", *GRID, *bearings(1e9), "-geometry", "held", "-start_H0", rest, "-start_V0", -0.02,
                     "-mesh_periods", 20)
        rows = self.steps("transient")[100:]
        span = len(rows) // 3
        signal = rows["H0"]
        windows = numpy.array([signal[n:n + span] for n in range(len(signal) - span)])
        left, size, right = numpy.linalg.svd(windows[:-1], full_matrices=False)
        count = 7  # three oscillations and the mean
        pencil = left[:, :count].T @ windows[1:] @ right[:count].T / size[:count]
        rates = numpy.log(numpy.linalg.eigvals(pencil)) / rows["dT"][0] * (rows["T"] / rows["t"])[0]
        found = sorted((rate for rate in rates if rate.imag > 1), key=lambda rate: rate.imag)
        expected = REFERENCE["films_real"]["1e9"]
        self.assertEqual(len(found), 3)
        for rate, frequency, zeta in zip(found, expected["f"], expected["zeta"]):
            self.assertAlmostEqual(abs(rate) / (2 * numpy.pi) / frequency, 1, delta=2e-4)
            self.assertAlmostEqual(-rate.real / abs(rate) / zeta, 1, delta=0.03)

    def test_the_balance_of_energy_closes_with_the_square_of_the_step_or_faster(self):
        """Of free oscillations the fitted steps leave less still: what is left comes from motions that are forced."""
        left = []
        for step in (0.064, 0.032):
            march = self.summary("transient", *GRID, *bearings(1e9), "-mesh_periods", 2, "-time_dt", step)
            left.append(march["energy_balance_residual"])
        self.assertLess(left[0], 0.02)
        self.assertTrue(3 < left[0] / left[1] < 12, left)

    def test_a_march_goes_on_to_the_bit_and_is_the_same_on_two_processes(self):
        march = ["transient", self.write_case(RELIEF), *GRID, *self.damped_bearings(), "-keep_checkpoint", "yes",
                 "-start_place", "after_leaving", "-output_dir"]
        self.run_program(*march, "whole", "-mesh_periods", 2)
        self.run_program(*march, "parts", "-mesh_periods", 1)
        run = self.run_program(*march, "parts", "-mesh_periods", 2, "-restart", "yes")
        self.assertEqual(run.status, 0, run)
        self.run_program(*march, "shared", "-mesh_periods", 2, processes=2)
        whole, parts, shared = (self.steps(name) for name in ("whole", "parts", "shared"))
        for name in ("H0", "V0", "force_total"):
            self.assertEqual(whole[name].tolist(), parts[name].tolist())
        self.assertLess(abs(whole["H0"] - shared["H0"]).max(), SAME)

    def test_multipliers_of_the_periodic_state_are_by_the_damping_of_its_modes(self):
        orbit = self.summary("periodic", *GRID, *self.damped_bearings())
        self.assertLessEqual(orbit["periods_used"], 5)
        self.assertLess(orbit["floquet_modulus_error"], 6e-3)  # of the fit and the grid
        found = sorted((abs(complex(*mu)) for mu in orbit["floquet"]), reverse=True)
        films, dry = REFERENCE["films_real"]["1e9"], REFERENCE["table3"]["f"]["weber_bores"]["1e+09"]
        for n, (frequency, zeta, share) in enumerate(zip(films["f"], films["zeta"],
                                                         (share for share in dry["mesh_share"] if share > 1e-9))):
            damping = zeta + 0.01 * (1 - share)
            expected = numpy.exp(-2 * numpy.pi * damping * frequency * 60 / (15000 * 28))
            for modulus in found[2 * n:2 * n + 2]:
                self.assertAlmostEqual(modulus, expected, delta=5e-3)

    def test_a_small_fluctuation_of_torque_moves_springs_in_the_place_of_films(self):
        amplitude, order = 0.05, 4
        dampers = ["-motor_shaft_damping", 1.0, "-load_shaft_damping", 4.0]
        films = self.summary("eigen", *GRID)
        summary = self.summary("transient", *GRID, *SHAFTS, *dampers, "-geometry", "held", "-mesh_periods", 7,
                               "-motor_torque_harmonics", f"{order} {amplitude} 30", "-periodic_max_pattern", 7)
        rows = self.steps("transient")
        (pinion, wheel), (I_1, I_2) = CASE_STUDY["rb"], CASE_STUDY["I"]
        radii = numpy.array([pinion, pinion, wheel, wheel])  # motor, pinion, wheel, load: ways r phi
        masses = numpy.array([0.02, I_1, I_2, 0.15]) / radii ** 2
        rate = 2 * numpy.pi * films["film_frequency"] / numpy.sqrt(1 - films["film_damping_ratio"] ** 2)
        joints = numpy.array([[1, -1, 0, 0], [0, 1, -1, 0], [0, 0, 1, -1]])
        springs = numpy.array([2e4 / pinion ** 2, films["m_ge"] * rate ** 2, 8e4 / wheel ** 2])
        damping = numpy.array([1.0 / pinion ** 2, 2 * films["film_damping_ratio"] * rate * films["m_ge"],
                               4.0 / wheel ** 2])
        # x = (stretches of the joints, velocities) from rest: a particular oscillation, and free ones that cancel it.
        A = numpy.block([[numpy.zeros((3, 3)), joints],
                         [-(joints.T * springs / masses[:, None]), -(joints.T * damping) @ joints / masses[:, None]]])
        omega = order * 2 * numpy.pi * 15000 / 60
        push = numpy.zeros(7, complex)
        push[3] = amplitude * summary["static_force"] / masses[0] * numpy.exp(1j * numpy.pi / 6)
        forced = numpy.linalg.solve(1j * omega * numpy.eye(7) - A, push)
        values, vectors = numpy.linalg.eig(A)
        free = numpy.linalg.solve(vectors, -forced.real.astype(complex))
        ways = numpy.array([(forced * numpy.exp(1j * omega * t)).real + (vectors @ (free * numpy.exp(values * t))).real
                            for t in rows["t"]])
        expected = springs[1] * ways[:, 1] + damping[1] * (ways[:, 3:] @ joints[1])
        found = rows["force_total"] - summary["static_force"]
        self.assertLess(abs(found - expected).max(), 0.02 * abs(expected).max())
        self.assertGreater(abs(expected).max(), 2e-3 * summary["static_force"])


class Ripple(TrainTest):
    LINE = [*SHAFTS, "-motor_shaft_damping", 1.0, "-load_shaft_damping", 4.0]

    def periodic(self, harmonics):
        return self.summary("periodic", "-model", "dry", "-dry_damping_ratio", 0.02, *self.LINE,
                            "-motor_torque_harmonics", harmonics, "-periodic_max_pattern", 28, "-time_dt", 0.05)

    def first_order(self):
        """Amplitude of the tooth force at the order of the pinion, over the static force."""
        rows = table_in(self.folder / "periodic", "history/steps")
        time, force = rows["T"] / (rows["T"].max() - rows["T"].min()), rows["force_total"]
        turning = force * numpy.exp(-2j * numpy.pi * time)
        value = (numpy.diff(time) * (turning[1:] + turning[:-1])).sum()
        return abs(value) / summary_in(self.folder / "periodic")["static_force"]

    def test_a_tenth_of_torque_is_a_tooth_force_of_the_reference(self):
        expected = REFERENCE["torque_harmonic"]
        orbit = self.periodic("1 0.1 0")
        self.assertAlmostEqual(orbit["total_force_ratio_max"] / expected["total_max"], 1, delta=expected["tol"])
        self.assertAlmostEqual(orbit["total_force_ratio_min"] / expected["total_min"], 1, delta=expected["tol"])
        self.assertAlmostEqual(
            self.first_order() / expected["mesh_force_amplitude_order1_over_static"]["orbit"], 1, delta=expected["tol"])
        found = sorted(abs(complex(*mu)) for mu in orbit["floquet"])
        for modulus, one in zip(sorted(expected["multipliers_abs"]), found):
            self.assertAlmostEqual(modulus, one, delta=expected["tol"])
        motor, load = orbit["shaft_torques"]
        self.assertAlmostEqual(motor["torque_mean"] / 470, 1, delta=1e-6)
        self.assertAlmostEqual(load["torque_mean"] / (-470 * 43 / 28), 1, delta=1e-6)
        self.assertLess(orbit["energy_balance_residual"], 1e-4)
        orders = table_in(self.folder / "periodic", "orders")
        self.assertAlmostEqual(orders["order"][0], 1, delta=1e-9)
        for shaft, amplitude in zip(("shaft_motor_pinion", "shaft_load_wheel"), self.torques_by_receptance()):
            self.assertAlmostEqual(orders[shaft][0] / amplitude, 1, delta=0.01)

    def test_a_thousandth_of_torque_is_that_part_of_a_tenth(self):
        expected = REFERENCE["torque_harmonic"]["mesh_force_amplitude_order1_over_static"]
        self.periodic("1 0.001 0")
        amplitude = 100 * self.first_order()
        self.assertAlmostEqual(amplitude / expected["orbit"], 1, delta=REFERENCE["torque_harmonic"]["tol"])
        # Beside the receptance of the teeth as one spring, which their contacts are not.
        self.assertAlmostEqual(amplitude / expected["linear"], 1, delta=5e-3)

    @staticmethod
    def torques_by_receptance():
        """Amplitudes at 250 Hz of both shafts of four inertias, the teeth a spring with a damper."""
        inertias = numpy.diag([0.02, *CASE_STUDY["I"], 0.15])
        motor, load = numpy.array([1, -1, 0, 0]), numpy.array([0, 0, -1, 1])
        teeth = numpy.array([0, -CASE_STUDY["rb"][0], CASE_STUDY["rb"][1], 0])
        k, omega = CASE_STUDY["k_mesh_weber_bores"], 2 * numpy.pi * 250
        springs = [(2e4, 1.0, motor), (8e4, 4.0, load), (k, 0.04 * (k * CASE_STUDY["m_ge"]) ** 0.5, teeth)]
        dynamic = sum((spring + 1j * omega * damper) * numpy.outer(row, row) for spring, damper, row in springs)
        swing = numpy.linalg.solve(dynamic - omega**2 * inertias, [47, 0, 0, 0])
        return [abs((spring + 1j * omega * damper) * row @ swing) for spring, damper, row in springs[:2]]

    def test_torques_by_keys_in_a_file_and_by_their_frequency_are_the_same(self):
        file = self.folder / "torques.train"
        whole = 470 * 43 / 28
        for keys, line in ((["-motor_torque_harmonics", "1 0.1 0"], "torque motor 470 250Hz 0.1 0"),
                           (["-load_torque_harmonics", "2 0.1 30"], f"torque load {-whole!r} 2 0.1 30"),
                           ([], f"torque motor 300\ntorque motor 170\ntorque load {-whole!r}")):
            motions = []
            file.write_text(line + "\n", encoding="utf-8")
            for options in (keys, ["-train_file", file]):
                self.summary("transient", "-model", "dry", "-mesh_periods", 1, *self.LINE, *options)
                motions.append(table_in(self.folder / "transient", "history/train"))
                shutil.rmtree(self.folder / "transient")
            for name in ("rotation_pinion", "rotation_load", "shaft_load_wheel"):
                one, other = motions[0][name], motions[1][name]
                self.assertLess(abs(one - other).max(), 1e-9 * abs(one).max(), name)

    def test_wrong_harmonics(self):
        for harmonics, words in (("1 0.1", ["motor.torque_harmonics", "has the part '1 0.1'"]),
                                 ("0 0.1 0", ["no order > 0"]),
                                 ("3.14159 0.1 0", ["never repeats together with the mesh"]),
                                 ("1 0.1 0", ["repeat together after 28 mesh periods", "raise that to 28"]),
                                 ("0.5 0.1 0", ["repeat together after 56 mesh periods"]),
                                 ("1 1e5 0", ["swings the whole train by", "of the base pitch"]),
                                 ("0Hz 0.1 0", ["no order > 0 or frequency"]),
                                 ("300Hz 0.1 0", ["has 300 Hz; this and the mesh, 7000 Hz", "after 70 mesh periods",
                                                  "raise that to 70, give an order"])):
            for model in ("dry", "dynamic"):
                with self.subTest(harmonics=harmonics, model=model):
                    self.assert_wrong(words, "periodic", self.write_case(RELIEF), "-model", model, *SHAFTS,
                                      "-motor_torque_harmonics", harmonics)
        self.assert_wrong(["motor.torque_harmonics", "has 300 Hz, which is no order of a shaft"], "sweep",
                          self.write_case(RELIEF), "-model", "dry", *SHAFTS, "-motor_torque_harmonics", "300Hz 0.1 0",
                          "-sweep_values", 15000)
        self.assert_wrong(["the motor turns at an imposed speed"], "info", self.write_case(RELIEF), *SHAFTS,
                          "-motor_fixed", "yes", "-motor_torque_harmonics", "1 0.1 0")


if __name__ == "__main__":
    unittest.main()
