"""Runs of two processes that are stopped on their way, and go on; environment as for cli_test.py."""
import shutil
import signal
import unittest

from restarts import MARCH, SWEEP, RestartTest, states_in

# A run that is complete before it is stopped is done again. None was when this was written.
ATTEMPTS = 5


class Together(RestartTest):
    def test_sweep_on_two_processes(self):
        expected = self.uninterrupted(*SWEEP, processes=2)
        second = self.folder / "run/points/up_0001.checkpoint"
        for _ in range(ATTEMPTS):
            run = self.start(*SWEEP, processes=2)
            run.wait_until(lambda: len(states_in(second)) >= 2)
            run.kill()
            if run.end().status != 0:
                break
            shutil.rmtree(self.folder / "run")
        self.assertTrue((self.folder / "run/points/up_0000.json").exists())
        self.assert_same(self.complete(*SWEEP, processes=2), expected)

    def test_signals_to_mpiexec(self):
        """SIGUSR1 is handed on. With SIGTERM Open MPI gives processes a second to end, and returns a status of its
        own."""
        # The march that is stopped would take minutes; within a second it is not beyond what is compared.
        endless, compared = [[*MARCH, "-mesh_periods", periods] for periods in (10000, 30)]
        expected = self.uninterrupted(*compared, processes=2)
        for number in (signal.SIGUSR1, signal.SIGTERM):
            with self.subTest(signal=number):
                run = self.start(*endless, processes=2)
                run.wait_until(lambda: states_in(self.folder / "run/checkpoint"))
                run.send(number)
                outcome = run.end()
                if number == signal.SIGUSR1:
                    self.assert_stopped(outcome, "by SIGUSR1")
                self.assert_same(self.complete(*compared, processes=2), expected)


if __name__ == "__main__":
    unittest.main()
