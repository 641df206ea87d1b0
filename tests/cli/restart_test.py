"""Runs that are stopped on their way, and go on to the end of one that was not; environment as for cli_test.py.

restart_together_test.py has those of two processes, continuation_test.py those that go on from states that were kept.
"""
import shutil
import signal
import time
import unittest

from films import BARBIERI
from restarts import EIGEN, MARCH, SEARCH, SMALL, SWEEP, RestartTest, states_in, stopped_after
from vibration import table_in


class Continued(RestartTest):
    """One process: stopped where it has written so many lines, which it does without waiting to be read but for one."""

    def interrupt(self, arguments, lines, number):
        """Stops or kills a run after so many lines."""
        outcome = stopped_after(lines, [*arguments, "-output_dir", "run"], self.folder, number)
        if number == signal.SIGKILL:
            self.assertEqual(outcome.status, -signal.SIGKILL, outcome)
        else:
            self.assertEqual(outcome.status, 3, outcome)

    def assert_continued(self, arguments, *stops):
        """The results of a run that was stopped again and again are those of one that was not."""
        for n, (lines, number) in enumerate(stops):
            self.interrupt([*arguments, "-restart"] if n else arguments, lines, number)
        self.assert_same(self.complete(*arguments), self.uninterrupted(*arguments))

    def test_march_with_snapshots(self):
        # 20 lines; contacts enter and leave behind the 4th, 6th, 15th and 17th.
        self.assert_continued(MARCH, (1, signal.SIGUSR1), (5, signal.SIGUSR1), (4, signal.SIGKILL),
                              (10, signal.SIGUSR1), (3, signal.SIGKILL))

    def test_march_on_bending_teeth(self):
        # Contacts enter unloaded and leave under load, when the others' teeth spring back.
        teeth = ["-gear_tooth_compliance", "weber", "-pinion_bore_radius", 0.02, "-wheel_bore_radius", 0.02,
                 "-wheel_tip_relief", 70e-6, "-wheel_tip_relief_length", 2.9e-3]
        self.assert_continued([*MARCH, *teeth], (5, signal.SIGUSR1), (9, signal.SIGKILL))

    def test_march_with_heat_and_friction_in_the_motion(self):
        heat = ["-friction_law", "eyring", "-friction_in_motion", "yes", "-thermal_model", "film",
                "-lubricant_temperature_viscosity", 0.04]
        self.assert_continued([*MARCH, *heat], (5, signal.SIGUSR1), (9, signal.SIGKILL))

    def test_march_with_a_spectrum(self):
        self.assert_continued([*MARCH, "-output_spectrum_periods", 1], (8, signal.SIGUSR1))

    def test_march_with_steps_by_their_errors(self):
        self.assert_continued([*MARCH, "-time_tolerance", 1e-4], (8, signal.SIGKILL))

    def test_dry_pair_and_one_contact(self):
        for model in ("dry", "simplified", "quasistatic"):
            with self.subTest(model=model):
                arguments = ["transient", BARBIERI, *SMALL, "-model", model]
                self.assert_continued(arguments, (7, signal.SIGUSR1), (10, signal.SIGKILL))
                shutil.rmtree(self.folder / "run")
                shutil.rmtree(self.folder / "uninterrupted")

    def test_periodic_state(self):
        # 5 lines and a note a mesh period.
        self.assert_continued(SEARCH, (2, signal.SIGUSR1), (8, signal.SIGKILL), (9, signal.SIGUSR1))

    def test_multipliers_of_a_periodic_state(self):
        # All lines have been written before: the program stops within the mesh periods that follow them.
        run = self.start(*SEARCH)
        run.read_lines(17)
        run.send(signal.SIGUSR1)
        outcome = run.end()
        self.assertEqual(outcome.status, 3, outcome)
        expected = self.uninterrupted(*SEARCH)
        self.assert_same(self.complete(*SEARCH), expected)

    def test_sweep_between_and_within_its_points(self):
        points = self.folder / "run/points"
        expected = self.uninterrupted(*SWEEP)
        # Its second line waits until the first is read: the program cannot get beyond the second point.
        for number, checkpoint, states in ((signal.SIGUSR1, "up_0000", 3), (signal.SIGKILL, "up_0001", 2),
                                           (signal.SIGKILL, "up_0002", 3)):
            run = self.start(*SWEEP, "-restart")
            run.read_lines(int(checkpoint[-1]) - 1)
            run.wait_until(lambda: len(states_in(points / f"{checkpoint}.checkpoint")) >= states or
                           (points / f"{checkpoint}.json").exists())
            run.send(number)
            self.assertIn(run.end().status, (3, -signal.SIGKILL))
        self.assert_same(self.complete(*SWEEP), expected)


class Requests(RestartTest):
    def test_signals_to_a_single_process(self):
        expected = self.uninterrupted(*MARCH)
        for name in ("SIGTERM", "SIGUSR1", "SIGINT"):
            with self.subTest(signal=name):
                run = self.start(*MARCH)
                run.read_lines(9)
                run.send(signal.Signals[name])
                steps = self.assert_stopped(run.end(), f"by {'Ctrl-C' if name == 'SIGINT' else name}")
                # The step that was under way is finished, and written.
                self.assertGreater(len(steps), 65)
                self.assert_same(self.complete(*MARCH), expected)

    def test_stopped_search_has_all_its_steps(self):
        run = self.start(*SEARCH)
        run.read_lines(14)
        run.send(signal.SIGTERM)
        outcome = run.end()
        steps = self.assert_stopped(outcome, "by SIGTERM")
        period = float(outcome.stderr.split("mesh period ")[1].split(",")[0])
        last = table_in(self.folder / "run", "history/steps")["t"][-1]
        self.assertAlmostEqual(last / (1 / 7000), period, delta=1e-5)
        self.assertGreater(len(steps), 150)

    def test_time_limit(self):
        expected = self.uninterrupted(*MARCH)
        at_once = self.run_program(*MARCH, "-time_limit", 1e-9, "-output_dir", "run")
        self.assertEqual(len(self.assert_stopped(at_once, "after the time limit of 1e-09 s")), 1)
        limit = 1.0
        run = self.start(*MARCH, "-restart", "-time_limit", limit)
        run.read_lines(6)
        time.sleep(limit)
        self.assert_stopped(run.end(), "after the time limit of 1 s")
        # A run that has no time for anything new goes one step beyond the last entering.
        kept = len(states_in(self.folder / "run/checkpoint"))
        self.assertGreater(kept, 0)
        again = self.run_program(*MARCH, "-restart", "-time_limit", 1e-9, "-output_dir", "run")
        self.assertGreater(len(self.assert_stopped(again, "after the time limit of 1e-09 s")), 20)
        self.assert_same(self.complete(*MARCH), expected)


class Refused(RestartTest):
    def assert_refused(self, words, *arguments):
        self.assert_wrong(words, *arguments, "-output_dir", "run")

    def test_nothing_to_go_on_from(self):
        (self.folder / "run").mkdir()
        for arguments in (MARCH, SEARCH, EIGEN):
            self.assert_refused(["nothing to go on from", "-restart"], *arguments, "-restart")

    def test_a_complete_run_is_left_alone(self):
        self.run_well(*MARCH, "-output_dir", "run")
        before = {path.name: path.read_bytes() for path in (self.folder / "run").iterdir()}
        run = self.run_well(*MARCH, "-output_dir", "run", "-restart")
        self.assertEqual(run.stdout, "'run' holds this run, which is complete: nothing is left to do (without "
                         "-restart it is computed again)\n")
        self.assertEqual({path.name: path.read_bytes() for path in (self.folder / "run").iterdir()}, before)
        self.assert_refused(["grid.nx", "another run"], *[81 if word == 65 else word for word in MARCH], "-restart")

    def test_command_that_cannot_go_on(self):
        self.assert_refused(["steady", "-restart"], "steady", BARBIERI, "-restart")

    def test_time_limit_of_nothing(self):
        self.assert_refused(["time_limit"], *MARCH, "-time_limit", 0)

    def test_another_run(self):
        self.run_well(*MARCH, "-keep_checkpoint", "-output_dir", "run")
        finer = [81 if word == 65 else word for word in MARCH]
        more_often = [0.2 if word == 0.3 else word for word in MARCH]
        for words, options in ((["grid.nx", "65", "81"], finer),
                               (["pinion.torque", "470", "400"], [*MARCH, "-pinion_torque", 400]),
                               (["output.snapshot_interval", "0.3", "0.2"], more_often),
                               (["command", "transient", "periodic"], SEARCH)):
            with self.subTest(words=words):
                self.assert_refused(words, *options, "-restart")


if __name__ == "__main__":
    unittest.main()
