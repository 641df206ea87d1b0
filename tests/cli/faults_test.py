"""What goes wrong while a run is at work: its disk, its folder, its solver, one of its processes.

Environment as for cli_test.py; GEARFILM_FULL_DISK is the library of full_disk.c.
"""
import json
import os
import shutil
import signal
import subprocess
import time
import unittest

import h5py

from films import BARBIERI
from program import MPIEXEC, PROGRAM, ProgramTest, before_notice_of_mpiexec

# On the narrower domain of the case itself the march from rest is thrown beyond its sides in the second mesh period.
COARSE = ["transient", BARBIERI, "-grid_nx", 65, "-grid_ny", 33, "-time_dt", 0.1, "-output_snapshot_interval", 0.1]
MARCH = [*COARSE, "-grid_y_half", 1.6]
ENDLESS = [*MARCH, "-mesh_periods", 100000]
SECONDS = 120


def readable(folder):
    """Rows of the history."""
    with h5py.File(folder / "results.h5") as results:
        return len(results["history/steps"])


class FaultTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.output = self.folder / "out"

    def start(self, *arguments, processes=1):
        command = [*(MPIEXEC + [str(processes)] if processes > 1 else []), PROGRAM, *map(str, arguments)]
        run = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.addCleanup(run.kill)
        return run

    def wait_until(self, condition, run):
        for _ in range(100 * SECONDS):
            if condition() or run.poll() is not None:
                break
            time.sleep(0.01)
        self.assertTrue(condition())

    def end_of(self, run):
        """Exit status, and what the program itself wrote to stderr."""
        stderr = run.communicate(timeout=SECONDS)[1]
        return run.returncode, before_notice_of_mpiexec(stderr)

    def states(self):
        return sorted((self.output / "checkpoint").glob("*.state"))


class Disk(FaultTest):
    """A run that cannot write says so in one line and ends with status 2; what it had kept serves to go on."""

    def run_on_disk(self, size, *arguments, processes=1):
        environment = {"LD_PRELOAD": os.environ["GEARFILM_FULL_DISK"], "GEARFILM_DISK": str(self.output),
                       "GEARFILM_DISK_BYTES": str(size)}
        command = [PROGRAM, *map(str, arguments)]
        if processes > 1:
            exported = [word for name in environment for word in ("-x", name)]
            command = [*MPIEXEC, str(processes), *exported, *command]
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=SECONDS, check=False,
                              env={**os.environ, **environment})

    @unittest.skipUnless("GEARFILM_FULL_DISK" in os.environ, "needs the library of full_disk.c")
    def test_full_disk_ends_a_march_that_can_go_on(self):
        self.run_well(*MARCH, "-output_dir", "whole")
        for processes, at_work, size in [(1, "all", 263000), (1, "all", 300000), (1, "all", 500000), (1, "all", 900000),
                                         (2, "all", 300000), (2, "useful", 600000)]:
            with self.subTest(processes=processes, size=size):
                shutil.rmtree(self.output, ignore_errors=True)
                failed = self.run_on_disk(size, *MARCH, "-output_dir", self.output, "-solver_processes", at_work,
                                          processes=processes)
                stderr = before_notice_of_mpiexec(failed.stderr)
                self.assertEqual(failed.returncode, 2, failed)
                self.assertRegex(stderr, r"\Agearfilm: not written: cannot write '[^']*/out/[^']*': the disk is full; "
                                         r".* -restart\)\n")
                self.assertEqual(stderr.count("gearfilm:"), 1, stderr)
                if (self.output / "checkpoint/run.json").exists():
                    self.run_well(*MARCH, "-output_dir", self.output, "-restart", processes=processes)
                    self.assertEqual(readable(self.output), readable(self.folder / "whole"))

    @unittest.skipUnless("GEARFILM_FULL_DISK" in os.environ, "needs the library of full_disk.c")
    def test_full_disk_leaves_earlier_results(self):
        steady = ["steady", BARBIERI, "-grid_nx", 65, "-grid_ny", 33, "-output_dir", self.output]
        self.run_well(*steady)
        before = {path.name: path.read_bytes() for path in self.output.iterdir()}
        for command in (steady, [*MARCH, "-output_dir", self.output]):
            failed = self.run_on_disk(1000, *command)
            self.assertEqual(failed.returncode, 1, failed)
            self.assertRegex(failed.stderr,
                             r"\Agearfilm: wrong input: cannot write results into .*: No space left .*\n\Z")
            self.assertEqual({path.name: path.read_bytes() for path in self.output.iterdir()}, before)

    def test_folder_that_vanishes(self):
        for processes in (1, 2):
            with self.subTest(processes=processes):
                run = self.start(*ENDLESS, "-output_dir", self.output, processes=processes)
                self.wait_until(self.states, run)
                os.rename(self.output, self.folder / f"moved_{processes}")
                status, stderr = self.end_of(run)
                self.assertEqual(status, 2, stderr)
                self.assertRegex(stderr, r"gearfilm: not written: cannot write '[^']*': its folder is gone; .*\n")

    def test_folder_that_takes_no_files(self):
        self.assert_wrong(["/proc/films", "-output_dir"], *MARCH, "-output_dir", "/proc/films")

    def test_second_run_in_the_same_folder(self):
        run = self.start(*ENDLESS, "-output_dir", self.output)
        self.wait_until(self.states, run)
        for command in ("transient", "info"):
            for processes in (1, 2):
                second = self.run_program(command, *MARCH[1:], "-output_dir", self.output, processes=processes)
                self.assert_message(second, 1, "gearfilm: wrong input: ", ["another run", str(self.output)])
        run.send_signal(signal.SIGUSR1)
        status, stderr = self.end_of(run)
        self.assertEqual(status, 3, stderr)
        self.assertGreater(readable(self.output), 0)


class Limits(FaultTest):
    """Limits of the system that batch systems set: one line each, and no internal error."""

    def limited(self, limit, *arguments):
        command = " ".join(["ulimit", *limit, "&&", "exec", PROGRAM, *map(str, arguments)])
        return subprocess.run(["bash", "-c", command], cwd=self.folder, capture_output=True, text=True, timeout=SECONDS,
                              check=False)

    def test_memory(self):
        for kilobytes in (250_000, 350_000):
            done = self.limited(["-v", str(kilobytes)], "steady", BARBIERI, "-grid_nx", 1025, "-grid_ny", 513)
            self.assertEqual(done.returncode, 2, done)
            self.assertRegex(done.stderr, r"\Agearfilm: not solved: there is no more memory .* -v.*\n\Z")

    def test_size_of_files(self):
        done = self.limited(["-f", "600"], *ENDLESS, "-output_dir", self.output)
        self.assertEqual(done.returncode, 2, done)
        self.assertRegex(done.stderr, r"gearfilm: not written: cannot write '.*\n\Z")

    def test_standard_output_that_is_full(self):
        for processes in (1, 2):
            with open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run([*(MPIEXEC + [str(processes)] if processes > 1 else []), PROGRAM, "info", BARBIERI,
                                       "-thermal_model", "none", "-output_dir", self.output], cwd=self.folder,
                                      stdout=full, stderr=subprocess.PIPE, text=True, timeout=SECONDS, check=False)
            if processes == 1:  # mpiexec passes on what its processes print, and says itself what becomes of it
                self.assertEqual(done.returncode, 2, done)
                self.assertRegex(done.stderr, r"\Agearfilm: not written: cannot write to standard output.*\n\Z")
            self.assertTrue((self.output / "summary.json").exists())

    def test_working_directory_that_is_gone(self):
        done = subprocess.run(["bash", "-c", f"mkdir gone && cd gone && rmdir ../gone && {PROGRAM} info {BARBIERI}"],
                              cwd=self.folder, capture_output=True, text=True, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, 1, done)
        self.assertEqual(done.stderr.count("\n"), 1, done)
        self.assertIn("gearfilm: wrong input: the working directory is gone", done.stderr)


class Solver(FaultTest):
    """Each fault is caught where it happens, and its place is said."""

    def test_steps_that_cannot_converge(self):
        trials = {"an exhausted iteration limit": (["-step_snes_max_it", 1, "-time_newton_tolerance", 1e-12],
                                                   "DIVERGED_MAX_IT"),
                  "a failed linear solve": (["-step_ksp_max_it", 1, "-step_ksp_rtol", 1e-30,
                                             "-step_snes_max_linear_solve_fail", 1], "DIVERGED_LINEAR_SOLVE")}
        for fault, (options, reason) in trials.items():
            with self.subTest(fault=fault):
                run = self.run_program(*MARCH, *options, "-output_dir", self.output)
                self.assertEqual(run.status, 2, run)
                self.assertRegex(run.stderr, r"\Agearfilm: not solved: no time step converged from T = 0 on, .* "
                                             r"contact 0 at xi = 0 mm \(largest residual \S+ at X = \S+, Y = \S+\).*\n\Z")
                self.assertIn(reason, run.stderr)
                self.assertGreater(readable(self.output), 0)

    def test_a_march_that_fails_keeps_its_checkpoint(self):
        self.run_well(*MARCH, "-mesh_periods", 0.3, "-keep_checkpoint", "-output_dir", self.output)
        messages = []
        for _ in range(2):
            run = self.run_program(*MARCH, "-step_snes_max_it", 1, "-output_dir", self.output, "-restart")
            self.assertEqual(run.status, 2, run)
            self.assertRegex(run.stderr, r"\Agearfilm: not solved: no time step converged from T = 2\.")
            messages.append(run.stderr)
            summary = json.loads((self.output / "summary.json").read_text(encoding="utf-8"))
            self.assertFalse(summary["completed"])
            self.assertTrue(self.states())
        self.assertEqual(*messages)


class OneProcess(FaultTest):
    """What goes wrong on one process alone ends all of them."""

    def of_two(self, first, second):
        """A run of two processes with command lines of their own."""
        return subprocess.run([*MPIEXEC, "1", *first, ":", "-n", "1", *second], cwd=self.folder, capture_output=True,
                              text=True, timeout=SECONDS, check=False)

    def test_error_on_one_process_ends_all(self):
        if self.of_two(["true"], ["true"]).returncode != 0:
            self.skipTest("mpiexec cannot start two programs here (Open MPI 5.0.7 crashes)")
        steady = [PROGRAM, "steady", str(BARBIERI), "-output_dir", "out"]
        for wrong_one in (0, 1):
            with self.subTest(process=wrong_one):
                processes = [[*steady, "-grid_nx", "15"] if n == wrong_one else steady for n in range(2)]
                done = self.of_two(*processes)
                self.assertEqual(done.returncode, 1, done)
                self.assertIn("gearfilm: wrong input: option -grid_nx", done.stderr)


if __name__ == "__main__":
    unittest.main()
