"""Runs that go on from the states that others have left; environment as for cli_test.py."""
import json
import shutil
import unittest

import numpy

from films import SAME, summary_in
from restarts import EIGEN, HEAD, MARCH, MARK, SEARCH, SWEEP, RestartTest, checksum, results_in, states_in
from vibration import SAME_ORBIT, table_in

PRESENT = 13  # the format version of what a run goes on from


def flip(file, place):
    """Changes a bit, and nothing of the size."""
    data = bytearray(file.read_bytes())
    data[place] ^= 1
    file.write_bytes(data)


def damage(checkpoint, kind):
    """Spoils the newest state of a folder, or the steps that belong to it."""
    newest, steps = checkpoint / states_in(checkpoint)[-1], checkpoint / "steps"
    size = newest.stat().st_size
    if kind == "more steps":
        with open(steps, "ab") as file:
            file.write(b"a step that was half writt")
    elif kind == "bit in its steps":
        description = newest.read_bytes()[HEAD:]
        flip(steps, json.JSONDecoder().raw_decode(description.decode("latin1"))[0]["steps_end"] - 100)
    elif kind == "bit in its fields":
        flip(newest, size // 2)
    elif kind == "bit in its description":
        flip(newest, HEAD + 8)
    else:
        newest.write_bytes(newest.read_bytes()[:-8] if kind == "short" else b"")


class Cut(RestartTest):
    """Runs that were complete but for their last segments, as a program that was killed leaves them."""

    def keep(self, *arguments, name="run", processes=1):
        """A complete run that can go on; its results."""
        self.run_well(*arguments, "-keep_checkpoint", "-output_dir", name, processes=processes)
        return results_in(self.folder / name)

    def cut(self, states, name="run"):
        """Leaves so many states."""
        checkpoint = self.folder / name / "checkpoint"
        for state in states_in(checkpoint)[states:]:
            (checkpoint / state).unlink()
        self.assertEqual(len(states_in(checkpoint)), states)
        (self.folder / name / "summary.json").unlink()

    def assert_continued_from_everywhere(self, *arguments, processes=1, every=1):
        expected = self.keep(*arguments, name="kept", processes=processes)
        for states in range(0, len(states_in(self.folder / "kept/checkpoint")), every):
            with self.subTest(states=states, processes=processes):
                shutil.copytree(self.folder / "kept", self.folder / "run")
                self.cut(states)
                self.assert_same(self.complete(*arguments, processes=processes), expected)
                shutil.rmtree(self.folder / "run")

    def test_march_from_each_entering_and_leaving(self):
        # All have snapshots, for which their states are kept.
        for processes in (1, 2):
            self.assert_continued_from_everywhere(*MARCH, processes=processes, every=processes)
            shutil.rmtree(self.folder / "kept")

    def test_periodic_state_on_two_processes(self):
        self.assert_continued_from_everywhere(*SEARCH, processes=2, every=5)

    def test_eigen_with_the_orbit(self):
        for processes in (1, 2):
            self.assert_continued_from_everywhere(*EIGEN, processes=processes, every=3 * processes)
            shutil.rmtree(self.folder / "kept")

    def test_march_on_another_number_of_processes(self):
        self.uninterrupted(*MARCH)
        for before, after in ((1, 2), (2, 1)):
            with self.subTest(before=before, after=after):
                self.keep(*MARCH, processes=before)
                self.cut(2)
                self.complete(*MARCH, processes=after)
                # Measured: 4e-9.
                self.assert_alike("run", "uninterrupted", SAME)
                shutil.rmtree(self.folder / "run")

    def test_periodic_state_on_another_number_of_processes(self):
        expected = self.uninterrupted(*SEARCH)
        for before, after in ((1, 2), (2, 1)):
            with self.subTest(before=before, after=after):
                self.keep(*SEARCH, processes=before)
                self.cut(5)
                found = self.complete(*SEARCH, processes=after)
                for name in ("H0_after_leaving", "V0_after_leaving", "force_ratio_max", "floquet_modulus"):
                    self.assertAlmostEqual(found["summary.json"][name], expected["summary.json"][name],
                                           delta=SAME_ORBIT, msg=name)
                shutil.rmtree(self.folder / "run")

    def test_damaged_state_or_more_steps_than_it_says(self):
        expected = self.keep(*MARCH, name="kept")
        for kind in ("short", "empty", "more steps", "bit in its steps", "bit in its fields", "bit in its description"):
            with self.subTest(damage=kind):
                shutil.copytree(self.folder / "kept", self.folder / "run")
                self.cut(4)
                damage(self.folder / "run/checkpoint", kind)
                self.assert_same(self.complete(*MARCH), expected)
                shutil.rmtree(self.folder / "run")

    def test_march_beyond_its_end(self):
        # Begun just after a leaving, it ends with another one: it goes on as if it had not ended.
        march = [*MARCH, "-start_place", "after_leaving"]
        expected = self.uninterrupted(*march)
        self.keep(*march, "-mesh_periods", 1)
        self.assertLess(len(table_in(self.folder / "run", "history/steps")), 100)
        self.run_well(*march, "-restart", "-keep_checkpoint", "-output_dir", "run")
        self.assert_same(results_in(self.folder / "run"), expected)
        self.assert_wrong(["'mesh_periods' is 1", "has come to 2"], *march, "-mesh_periods", 1, "-restart",
                          "-output_dir", "run")
        # Where nothing is left to march, the results are made again.
        (self.folder / "run/results.h5").unlink()
        self.assert_same(self.complete(*march), expected)


class OtherVersions(RestartTest):
    """Files of another format version are refused, with that version."""

    VERSIONS = ((PRESENT + 1, f"format version {PRESENT + 1}"), (None, "no format version"))

    def set_version(self, content, version):
        self.assertEqual(content.pop("format"), PRESENT)
        return content if version is None else content | {"format": version}

    def test_identity_of_a_march(self):
        self.stop_at_once(MARCH)
        identity = self.folder / "run/checkpoint/run.json"
        content = json.loads(identity.read_text(encoding="utf-8"))
        for version, words in self.VERSIONS:
            identity.write_text(json.dumps(self.set_version(dict(content), version)), encoding="utf-8")
            for processes in (1, 2):
                self.assert_wrong(["run.json", words, f"version {PRESENT}"], *MARCH, "-restart", "-output_dir", "run",
                                  processes=processes)

    def test_identity_of_a_sweep(self):
        self.stop_at_once(SWEEP)
        identity = self.folder / "run/sweep.json"
        content = json.loads(identity.read_text(encoding="utf-8"))
        for version, words in self.VERSIONS:
            identity.write_text(json.dumps(self.set_version(dict(content), version)), encoding="utf-8")
            self.assert_wrong(["sweep.json", words, f"version {PRESENT}"], *SWEEP, "-output_dir", "run")

    def test_state(self):
        self.run_well(*MARCH, "-mesh_periods", 0.5, "-keep_checkpoint", "-output_dir", "run")
        state = self.folder / "run/checkpoint" / states_in(self.folder / "run/checkpoint")[-1]
        data = state.read_bytes()
        end = HEAD + int.from_bytes(data[len(MARK):len(MARK) + 8], "little")
        for version, words in self.VERSIONS:
            text = json.dumps(self.set_version(json.loads(data[HEAD:end]), version)).encode()
            head = len(text).to_bytes(8, "little") + checksum(text).to_bytes(8, "little")
            state.write_bytes(MARK + head + text + data[end:])
            for processes in (1, 2):
                self.assert_wrong([state.name, words, f"version {PRESENT}"], *MARCH, "-restart", "-output_dir", "run",
                                  processes=processes)

    def stop_at_once(self, arguments):
        stopped = self.run_program(*arguments, "-time_limit", 1e-9, "-output_dir", "run")
        self.assertEqual(stopped.status, 3, stopped)


class Failed(RestartTest):
    def test_march_goes_on_with_other_steps(self):
        """With so few Newton steps allowed it fails at the first leaving."""
        brief = ["-time_newton_max_iterations", 2, "-time_newton_tolerance", 1e-5]
        failures = [self.run_program(*MARCH, *brief, *restart, "-output_dir", "run")
                    for restart in ([], ["-restart"])]
        for failed in failures:
            self.assertEqual(failed.status, 2, failed)
            self.assertEqual(failed.stderr, failures[0].stderr)
        before = table_in(self.folder / "run", "history/steps")
        finer = [0.05 if word == 0.1 else word for word in MARCH]
        self.complete(*finer)
        after = table_in(self.folder / "run", "history/steps")
        for name in before.dtype.names:
            numpy.testing.assert_array_equal(after[name][:len(before)], before[name], err_msg=name)
        self.assertGreater(before["dT"].max(), 0.09)
        self.assertLess(after["dT"][len(before):].max(), 0.0501)
        self.assertIs(summary_in(self.folder / "run")["completed"], True)


if __name__ == "__main__":
    unittest.main()
