"""Grids that are worth fewer processes than were started; environment as for cli_test.py."""
import os
import unittest
import unittest.mock

import h5py
import numpy as np

from program import INPUT, ProgramTest



def march(*options, periods=0.05, folder="run"):
    return ("transient", INPUT / "first_gear.yaml", "-mesh_periods", periods, "-output_dir", folder, *options)


class UsefulProcesses(ProgramTest):
    def setUp(self):
        super().setUp()
        # Other tests force all processes by this.
        options = unittest.mock.patch.dict(os.environ, PETSC_OPTIONS="")
        options.start()
        self.addCleanup(options.stop)

    def result(self):
        """Processes at work, and the total forces."""
        with h5py.File(self.folder / "run/results.h5") as results:
            return int(results.attrs["processes"]), np.array(results["history/steps"]["force_total"])

    def test_small_grids_take_one_of_three_and_give_its_bits(self):
        self.run_well(*march())
        alone = self.result()[1]
        run = self.run_well(*march(), processes=3)
        self.assertIn("on 1 of 3 processes", run.stdout)
        processes, forces = self.result()
        self.assertEqual(processes, 1)
        np.testing.assert_array_equal(forces, alone)
        run = self.run_well(*march("-solver_processes", "all"), processes=3)
        self.assertNotIn("processes:", run.stdout)
        processes, forces = self.result()
        self.assertEqual(processes, 3)
        np.testing.assert_allclose(forces, alone, rtol=1e-5)

    def test_those_that_sleep_end_as_the_others_do(self):
        endless = {"periods": 100}
        endings = ((1, "wrong input", march(folder="/dev/null/run")),
                   (2, "not solved", march("-solver_newton_max_iterations", 1)),
                   (3, "stopped", march("-time_limit", 0.2, **endless)),
                   (3, "stopped", march("-time_limit", 0.2, "-restart", **endless)))
        for status, kind, arguments in endings:
            with self.subTest(arguments):
                run = self.run_program(*arguments, processes=2)
                self.assertEqual(run.status, status, run)
                self.assertEqual(run.stderr.count("gearfilm: " + kind), 1, run)


if __name__ == "__main__":
    unittest.main()
