"""Nothing is deleted or replaced that the program did not write; environment as for cli_test.py."""
import json
import unittest

import h5py

from films import BARBIERI, CIRCULAR
from program import ProgramTest
from restarts import SMALL, SWEEP

MARCH = ["transient", BARBIERI, *SMALL, "-mesh_periods", 0.3]
DRY = ["-model", "dry"]


class Ownership(ProgramTest):
    def put(self, name, content=b"mine"):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
        return path

    def assert_refused(self, path, *arguments, processes=1):
        before = path.read_bytes()
        self.assert_wrong([path.name, "not written by this program", "-output_dir"], *arguments, "-output_dir", ".",
                          processes=processes)
        self.assertEqual(path.read_bytes(), before)

    def test_checkpoint_folder_of_a_user(self):
        for name in ("checkpoint/notes.txt", "checkpoint/coarse/deep/table.csv", "checkpoint/run.json",
                     "checkpoint/run000_00001.state", "checkpoint/steps"):
            path = self.put(name, b'{"command": "make", "format": 1}' if name.endswith("json") else b"a measurement of mine")
            for arguments, processes in (([*MARCH], 2), (["periodic", BARBIERI, *SMALL], 1),
                                         (["continuation", BARBIERI, *DRY, "-continuation_from", 15000,
                                           "-continuation_to", 15100], 1)):
                with self.subTest(name, command=arguments[0]):
                    self.assert_refused(path, *arguments, processes=processes)
            path.unlink()

    def test_results_of_a_user(self):
        with h5py.File(self.folder / "results.h5", "w") as file:
            file["measured"] = [1.0, 2.0]
        for name, content in (("results.h5", None), ("summary.json", b'{"summary": "of a measurement"}'),
                              ("run.json", b"[1, 2]"), ("shares.txt", b"of the company"), ("results.xmf", b"<?xml version=\"1.0\"?>\n<mine/>\n")):
            path = self.folder / name if content is None else self.put(name, content)
            for arguments in (["steady", CIRCULAR], ["info", BARBIERI], ["static", BARBIERI], MARCH):
                with self.subTest(name, command=arguments[0]):
                    self.assert_refused(path, *arguments)
            path.unlink()

    def test_points_of_a_user(self):
        notes = self.put("points/up_0000.json", b'{"points": "measured"}')
        self.assert_refused(notes, *SWEEP, *DRY)
        notes.unlink()
        self.put("points/up_0009.films")  # of a file that stands there when the sweep ends
        self.assert_wrong(["up_0009.films"], *SWEEP, *DRY, "-output_dir", ".")
        (self.folder / "points/up_0009.films").unlink()
        self.run_well(*SWEEP, *DRY, "-output_dir", ".")
        kept = [self.put(f"points/{name}") for name in ("up_0009.films", "old.checkpoint/data", "notes.txt")]
        self.run_well(*SWEEP, *DRY, "-output_dir", ".")
        for path in kept:
            self.assertEqual(path.read_bytes(), b"mine", path)

    def test_a_file_beside_a_checkpoint_survives_the_run_that_goes_on(self):
        stopped = self.run_program(*MARCH, "-time_limit", 1e-9, "-output_dir", ".")
        self.assertEqual(stopped.status, 3, stopped)
        notes = self.put("checkpoint/notes.txt")
        self.run_well(*MARCH, "-restart", "-output_dir", ".")
        self.assertEqual([path.name for path in (self.folder / "checkpoint").iterdir()], ["notes.txt"])
        self.assert_refused(notes, *MARCH)

    def test_own_files_are_replaced(self):
        scratch = self.folder / "scratch"
        scratch.mkdir()
        (self.folder / "checkpoint").symlink_to(scratch)
        for _ in range(2):
            self.run_program(*MARCH, "-time_limit", 1e-9, "-output_dir", ".")
            self.assertIn("run.json", [path.name for path in scratch.iterdir()])
        (self.folder / "results.h5").write_bytes((self.folder / "results.h5").read_bytes()[:3000])  # as a killed run's
        self.put("checkpoint/run000_00003.state.part", b"gearfilm rest")
        self.put("checkpoint/run000_00004.state", b"")
        self.run_well(*MARCH, "-output_dir", ".")
        self.assertEqual(list(scratch.iterdir()), [])
        self.assertTrue((self.folder / "checkpoint").is_symlink())
        for command in (["info", BARBIERI], ["steady", CIRCULAR], MARCH):
            self.run_well(*command, "-output_dir", ".")
        self.assertTrue(json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))["completed"])


if __name__ == "__main__":
    unittest.main()
