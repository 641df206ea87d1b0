"""Runs that are stopped or killed on their way, and what they leave in their folder."""
import fcntl
import json
import os
import pathlib
import select
import signal
import subprocess
import tempfile
import time

import h5py
import numpy

from films import BARBIERI, SAME
from program import SECONDS, Outcome, ProgramTest, command_of, environment_of

# Small and quick, but with positive films at every entering and leaving.
SMALL = ["-grid_nx", 65, "-grid_ny", 33, "-grid_y_half", 1.6, "-time_dt", 0.1]
# With snapshots in every segment between two enterings or leavings.
MARCH = ["transient", BARBIERI, *SMALL, "-output_snapshot_interval", 0.3]  # of two mesh periods
SEARCH = ["periodic", BARBIERI, *SMALL]
SWEEP = ["sweep", BARBIERI, *SMALL, "-sweep_values", "15000, 15500, 16000", "-sweep_direction", "up"]
EIGEN = ["eigen", BARBIERI, *SMALL, "-eigen_orbit", "yes", "-eigen_periods", 3]
# How a run was conducted is echoed with its results, and is no part of them.
CONDUCT = {"restart", "keep_checkpoint", "time_limit", "output.dir"}
# Not even two runs without a stop have these alike: the times; and on another number of processes the iterations.
TIMES = {"wall_time"}
EFFORT = TIMES | {"newton", "krylov"}
LONGEST_LINE = 4096  # and the size of the pipe
MARK = b"gearfilm restart"  # the first bytes of every binary file that a run goes on from
HEAD = 32  # bytes of a state before its description: the mark, length and checksum of the description


def processes_of_session(session):
    """Those that live: a process that has ended waits in state Z for its parent to notice."""
    found = []
    for folder in pathlib.Path("/proc").iterdir():
        if not folder.name.isdigit():
            continue
        try:
            fields = (folder / "stat").read_text(encoding="utf-8").rpartition(")")[2].split()
        except OSError:
            continue
        if int(fields[3]) == session and fields[0] not in "ZX":
            found.append(int(folder.name))
    return found


class LiveRun:
    """A run under way in a session of its own.

    The pipe from its stdout holds one line: alone, the program waits to write the second one after those that were
    read, so that it is known to be under way, and between which lines, however fast or slow the machine is.
    """

    def __init__(self, arguments, processes, folder):
        self.arguments, self.number = arguments, processes
        self.scratch = tempfile.TemporaryDirectory()
        self.read_end, write_end = os.pipe2(os.O_DIRECT | os.O_CLOEXEC)
        fcntl.fcntl(write_end, fcntl.F_SETPIPE_SZ, LONGEST_LINE)
        # Open MPI leaves memory that killed processes have shared where that lies.
        settings = {f"OMPI_MCA_btl_{name}_backing_directory": self.scratch.name for name in ("vader", "sm")}
        self.process = subprocess.Popen(command_of(arguments, processes), cwd=folder, start_new_session=True, text=True,
                                        env=environment_of(processes, self.scratch.name) | settings, stdout=write_end,
                                        stderr=subprocess.PIPE)
        os.close(write_end)
        self.text = b""

    def read_lines(self, count):
        for _ in range(count):
            self.text += os.read(self.read_end, LONGEST_LINE)

    def read_until(self, words):
        """Up to the line with these words, or the end of the run."""
        while words not in self.text and (line := os.read(self.read_end, LONGEST_LINE)):
            self.text += line

    def read_for(self, seconds):
        """As a reader that is always there."""
        end = time.monotonic() + seconds
        while select.select([self.read_end], [], [], max(0, end - time.monotonic()))[0]:
            line = os.read(self.read_end, LONGEST_LINE)
            if not line:
                return
            self.text += line

    def has_ended(self, options=os.WNOHANG):
        """Leaves the process to end(): until then its number is no other's."""
        return os.waitid(os.P_PID, self.process.pid, os.WEXITED | os.WNOWAIT | options) is not None

    def wait_until(self, reached):
        """Until something is reached, or the run is at its end."""
        while not reached() and not self.has_ended():
            time.sleep(0.002)

    def send(self, number):
        os.kill(self.process.pid, number)

    def kill(self):
        """kill -9 to all processes, which Open MPI gives groups of their own; back when they are gone."""
        if self.process.returncode is not None:
            return  # the number of the session may be another's by now
        while processes := processes_of_session(self.process.pid):
            for process in processes:
                try:
                    os.kill(process, signal.SIGKILL)
                except ProcessLookupError:
                    pass
            time.sleep(0.001)

    def end(self):
        """Waits for it; whatever mpiexec leaves behind is killed."""
        while line := os.read(self.read_end, LONGEST_LINE):
            self.text += line
        os.close(self.read_end)
        self.has_ended(options=0)
        self.kill()
        stderr = self.process.stderr.read()
        self.process.stderr.close()
        status = self.process.wait(SECONDS)
        self.scratch.cleanup()
        return Outcome(self.arguments, self.number, status, self.text.decode(), stderr)


def stopped_after(lines, arguments, folder, number=signal.SIGUSR1):
    """A run that is told to stop, or killed, while it cannot go beyond the second line after these."""
    run = LiveRun(arguments, 1, folder)
    try:
        run.read_lines(lines)
        run.send(number)
        return run.end()
    finally:
        run.kill()


def without(names, values):
    """Nested values of a summary but those of these names."""
    if isinstance(values, dict):
        return {name: without(names, value) for name, value in values.items() if name not in names}
    return [without(names, value) for value in values] if isinstance(values, list) else values


def tables_in(file):
    """Columns of tables, and fields, by name."""
    arrays = {}

    def add(name, item):
        if not isinstance(item, h5py.Dataset):
            return
        values = item[()]
        if values.dtype.names is None:
            arrays[name] = values
        else:
            arrays.update({f"{name}/{column}": values[column] for column in values.dtype.names})

    file.visititems(add)
    return arrays


def attributes_in(file):
    def named(value):
        """Whatever an axis or a field refers to, by its name: references depend on the places in the file."""
        if isinstance(value, numpy.ndarray) and value.dtype.names:
            return str([[file[row[0]].name, *row.tolist()[1:]] for row in value])
        if isinstance(value, numpy.ndarray) and value.dtype == object:
            return str([[file[reference].name for reference in axis] for axis in value])
        return value

    attributes = {f"@{name}": value for name, value in file.attrs.items()}
    file.visititems(lambda path, item: attributes.update(
        {f"{path}@{name}": named(value) for name, value in item.attrs.items() if name not in CONDUCT}))
    return attributes


def bits(array):
    array = numpy.asarray(array)
    return str(array.dtype), array.shape, array.tobytes()


def results_in(folder):
    """All results in a folder to the bit, by name, but for the times they took."""
    results = {}
    if (folder / "results.h5").exists():
        with h5py.File(folder / "results.h5") as file:
            for name, values in (tables_in(file) | attributes_in(file)).items():
                if name.rpartition("/")[2] not in TIMES:
                    results[name] = bits(values)
    for file in sorted(folder.rglob("*.json")):
        if "checkpoint" not in str(file.relative_to(folder)):
            results[file.name] = without(TIMES | CONDUCT, json.loads(file.read_text(encoding="utf-8")))
    for file in folder.glob("*.xmf"):
        results[file.name] = file.read_text(encoding="utf-8")
    return results


def checksum(text):
    """Of the bytes of a description, as in src/output/checksum.hpp."""
    total = 0
    for place, byte in enumerate(text, start=1):
        z = byte ^ place * 0x9e3779b97f4a7c15 % 2**64
        for shift, factor in ((30, 0xbf58476d1ce4e5b9), (27, 0x94d049bb133111eb)):
            z = (z ^ z >> shift) * factor % 2**64
        total += z ^ z >> 31
    return total % 2**64


def states_in(checkpoint):
    """Names of the states that are kept in a folder, by age."""
    return sorted(path.name for path in checkpoint.glob("*.state"))


class RestartTest(ProgramTest):
    def start(self, *arguments, name="run", processes=1):
        run = LiveRun([*arguments, "-output_dir", name], processes, self.folder)
        self.addCleanup(run.kill)
        return run

    def uninterrupted(self, *arguments, name="uninterrupted", processes=1):
        """Results of a run without a stop."""
        self.run_well(*arguments, "-output_dir", name, processes=processes)
        return results_in(self.folder / name)

    def complete(self, *arguments, name="run", processes=1):
        """Results of a run that goes on from where it stopped to its end."""
        self.run_well(*arguments, "-restart", "-output_dir", name, processes=processes)
        self.assert_nothing_left_over(name)
        return results_in(self.folder / name)

    def assert_nothing_left_over(self, name="run"):
        self.assertEqual([path for path in self.content() if path.endswith((".part", ".checkpoint", ".films"))], [])
        self.assertFalse((self.folder / name / "checkpoint").exists())

    def assert_same(self, found, expected):
        self.assertEqual(set(found), set(expected))
        different = [name for name in expected if found[name] != expected[name]]
        self.assertEqual(different, [])

    def assert_alike(self, found, expected, tolerance=SAME):
        """Histories and fields of two folders agree within a part of their largest values."""
        with h5py.File(self.folder / found / "results.h5") as first, \
                h5py.File(self.folder / expected / "results.h5") as second:
            first, second = tables_in(first), tables_in(second)
        self.assertEqual(set(first), set(second))
        for name in second:
            if name.rpartition("/")[2] not in EFFORT:
                size = abs(second[name]).max(initial=0)
                numpy.testing.assert_allclose(first[name], second[name], rtol=0, atol=tolerance * size, err_msg=name)

    def assert_stopped(self, outcome, reason, name="run"):
        """Exit status 3, one line that says how to go on, and results that can be read."""
        self.assertEqual(outcome.status, 3, outcome)
        self.assertRegex(outcome.stderr, r"\Agearfilm: stopped: at mesh period [-+.e\d]+, " + reason +
                         "; .* go on with the same command and -restart\n\\Z")
        self.assertEqual([path for path in self.content() if path.endswith(".part")], [])
        summary = json.loads((self.folder / name / "summary.json").read_text(encoding="utf-8"))
        self.assertIs(summary["completed"], False)
        with h5py.File(self.folder / name / "results.h5") as results:
            steps = results["history/steps"]["T"]
            self.assertEqual(set(results["history/contacts"]["step"]), set(range(len(steps))))
        return steps
