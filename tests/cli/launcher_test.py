"""scripts/support/mpiexec.sh: which cores processes get, alone, beside another run, and where there are too few."""
import fcntl
import os
import subprocess
import unittest

from program import SECONDS, SOURCE

SCRIPT = str(SOURCE / "scripts/support/mpiexec.sh")
CORE = "/sys/devices/system/cpu/cpu{}/topology/core_id"
SHOW = ["bash", "-c", 'sed -n "s/^Cpus_allowed_list:[[:space:]]*//p" /proc/self/status']
OPEN_MPI = any(name in subprocess.run([os.environ.get("MPIEXEC", "mpiexec"), "--version"], capture_output=True, text=True,
                                      check=True).stdout for name in ("Open MPI", "OpenRTE"))


def cores():
    """Numbers of the cores that this process may use, by one processor of each."""
    listed = subprocess.run(["lscpu", "-p=CPU,CORE,SOCKET"], capture_output=True, text=True, check=True).stdout
    rows = [line.split(",") for line in listed.splitlines() if not line.startswith("#")]
    return len({(core, socket) for cpu, core, socket in rows if int(cpu) in os.sched_getaffinity(0)})


def others_compute():
    """Whether another run of the script has a core."""
    for core in os.sched_getaffinity(0):
        with open(CORE.format(core), encoding="ascii") as described:
            try:
                fcntl.flock(described, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                return True
    return False


def numbers(listed):
    """The processors of "0-2,5"."""
    ranges = [part.partition("-") for part in listed.split(",")]
    return {number for first, _, last in ranges for number in range(int(first), int(last or first) + 1)}


@unittest.skipUnless(OPEN_MPI, "processes are bound with Open MPI alone")
@unittest.skipUnless(cores() > 1, "one core for all")
class Launcher(unittest.TestCase):
    def start(self, processes, *words, before=()):
        return subprocess.run([*before, SCRIPT, str(processes), *words], capture_output=True, text=True, timeout=SECONDS,
                              check=True).stdout.splitlines()

    def test_every_process_has_a_core(self):
        for processes in range(2, min(cores(), 4) + 1):
            got = [numbers(line) for line in self.start(processes, *SHOW)]
            self.assertEqual([len(own) for own in got], processes * [1])
            self.assertEqual(len(set.union(*got)), processes)

    def test_one_process_or_more_than_cores_have_all(self):
        for processes in (1, cores() + 1):
            got = [numbers(line) for line in self.start(processes, *SHOW)]
            self.assertEqual(got, processes * [os.sched_getaffinity(0)])

    def test_within_the_cores_that_taskset_leaves(self):
        one = max(os.sched_getaffinity(0))
        got = self.start(2, *SHOW, before=["taskset", "-c", str(one)])
        self.assertEqual(got, 2 * [str(one)])

    @unittest.skipIf(others_compute(), "others compute here")
    def test_two_runs_take_different_cores_as_far_as_there_are(self):
        holding = SHOW[2] + "; ((OMPI_COMM_WORLD_RANK)) || read -r"
        with subprocess.Popen([SCRIPT, "2", "bash", "-c", holding], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              text=True) as first:
            taken = [numbers(first.stdout.readline()) for _ in range(2)]
            second = [numbers(line) for line in self.start(2, *SHOW)]
            first.communicate("\n", timeout=SECONDS)
        self.assertEqual([len(own) for own in second], [1, 1])
        self.assertEqual(len(set.union(*second)), 2)
        shared = set.union(*taken) & set.union(*second)
        self.assertEqual(len(shared), max(0, 4 - cores()))

    @unittest.skipIf(others_compute(), "others compute here")
    def test_a_core_that_another_has_comes_last(self):
        held = min(os.sched_getaffinity(0))
        with open(CORE.format(held), encoding="ascii") as core:
            fcntl.flock(core, fcntl.LOCK_EX | fcntl.LOCK_NB)
            got = self.start(2, "bash", "-c", "echo $OMPI_COMM_WORLD_RANK $(" + SHOW[2] + ")")
        own = dict(line.split() for line in got)
        self.assertNotEqual(own["0"], str(held))
        self.assertEqual(own["1"] == str(held), cores() == 2)

    def test_words_and_variables_reach_the_program(self):
        got = self.start(2, "-x", "OF_THE_TEST=a b", "bash", "-c", 'echo "$OF_THE_TEST|$1|$2"', "x", "two words", "*")
        self.assertEqual(got, 2 * ["a b|two words|*"])

    def test_exit_status_is_that_of_the_program(self):
        done = subprocess.run([SCRIPT, "2", "bash", "-c", "exit 3"], capture_output=True, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, 3)


if __name__ == "__main__":
    unittest.main()
