"""Runs that are killed at random times, again and again, end as one that was not; environment as for cli_test.py.

GEARFILM_KILLS: how many times.
"""
import json
import os
import random
import shutil
import time
import unittest

import h5py

from restarts import HEAD, MARCH, MARK, SEARCH, RestartTest, results_in, tables_in

KILLS = int(os.environ.get("GEARFILM_KILLS", 200))
SEED = 2013
# Part of the kills that aim at the end of a run: its last line is written, the results are completed, and what it
# could go on from is removed.
AT_THE_END = 0.25
END_SECONDS = 0.05


def is_whole(state):
    """The size of a state file is what its description says."""
    data = state.read_bytes()
    length = int.from_bytes(data[len(MARK):len(MARK) + 8], "little")
    description = json.loads(data[HEAD:HEAD + length])
    nx, rows = description["nodes"]
    return len(data) == HEAD + length + 8 * description["fields"] * nx * rows


def is_readable(results):
    try:
        with h5py.File(results) as file:
            tables_in(file)
    except (OSError, KeyError, RuntimeError):
        return False
    return True


class Killed(RestartTest):
    def setUp(self):
        super().setUp()
        self.random = random.Random(f"{SEED} {self.id()}")
        self.output = self.folder / "run"

    def begin(self, arguments, processes):
        """Anew, or from where the last one was killed."""
        known = (self.output / "checkpoint/run.json").exists()
        return self.start(*arguments, *(["-restart"] if known else []), processes=processes)

    def kill_somewhere(self, run, duration):
        if self.random.random() < AT_THE_END:
            run.read_until(b"100 %")
            time.sleep(self.random.uniform(0, END_SECONDS))
        else:
            run.read_for(self.random.uniform(0, duration))
        run.kill()
        return run.end()

    def assert_can_go_on(self, arguments, processes):
        checkpoint = self.output / "checkpoint"
        for state in checkpoint.glob("*.state"):
            self.assertTrue(is_whole(state), state)
        if (self.output / "summary.json").exists():
            json.loads((self.output / "summary.json").read_text(encoding="utf-8"))
        results = self.output / "results.h5"
        if results.exists() and not is_readable(results):
            self.assert_restored(arguments, processes)

    def assert_restored(self, arguments, processes):
        """A run that goes on makes readable results from what is kept, even if it is stopped at once."""
        shutil.copytree(self.output, self.folder / "restored")
        self.run_program(*arguments, "-restart", "-time_limit", 1e-9, "-output_dir", "restored", processes=processes)
        self.assertTrue(is_readable(self.folder / "restored/results.h5"))
        shutil.rmtree(self.folder / "restored")

    def kill_again_and_again(self, arguments, kills, processes=1):
        begin = time.monotonic()
        expected = self.uninterrupted(*arguments, processes=processes)
        duration = time.monotonic() - begin
        done = 0
        while done < kills:
            outcome = self.kill_somewhere(self.begin(arguments, processes), duration)
            if outcome.status == 0:
                self.assert_same(results_in(self.output), expected)
                self.assert_nothing_left_over()
                shutil.rmtree(self.output)
            else:
                self.assertEqual(outcome.stderr.count("gearfilm:"), 0, outcome)
                self.assert_can_go_on(arguments, processes)
                done += 1
        if (self.output / "checkpoint/run.json").exists():
            self.assert_same(self.complete(*arguments, processes=processes), expected)

    def test_march_with_snapshots(self):
        self.kill_again_and_again(MARCH, round(0.7 * KILLS))

    def test_periodic_state(self):
        self.kill_again_and_again(SEARCH, round(0.2 * KILLS))

    def test_march_on_two_processes(self):
        self.kill_again_and_again(MARCH, round(0.1 * KILLS), processes=2)


if __name__ == "__main__":
    unittest.main()
