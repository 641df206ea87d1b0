"""Figures of a case and of the same on a finer grid: do they lie within the errors that the program gives?"""
import collections
import dataclasses
import statistics

from studies.common.runs import attempt, domain_options
from studies.common.tables import heading, row

BARS = 1.1
ENDING = "_error"
# What multipliers have is the scatter of a fit.
NOT_OF_GRIDS = {"floquet_modulus"}


@dataclasses.dataclass
class Test:
    """One figure of one case: its value and error, and its value on the finer grid."""
    case: str
    figure: str
    value: float
    error: object              # None where it is not known
    finer: float

    @property
    def distance(self):
        """In errors."""
        gap = abs(self.finer - self.value)
        return gap / self.error if self.error else (0.0 if gap == 0 else float("inf"))

    @property
    def holds(self):
        return self.distance <= BARS


def tests_of(case, coarse, fine):
    """Of two summaries."""
    names = [name[:-len(ENDING)] for name in coarse if name.endswith(ENDING)]
    return [Test(case, name, coarse[name], coarse[name + ENDING], fine[name]) for name in names
            if name not in NOT_OF_GRIDS and isinstance(coarse.get(name), float) and isinstance(fine.get(name), float)
            and coarse[name] != 0]


def finer_options(command, summary, folder):
    """Twice the nodes of a run on its domain, and half its step."""
    grid = summary.get("final_grid", summary)
    nodes = ["-grid_nx", 2 * grid["nx"] - 1, "-grid_ny", 2 * grid["ny"] - 1]
    if command == "steady":
        return [*nodes, *domain_options(folder)]
    edges = [word for name in ("x_min", "x_max", "y_half") for word in (f"-grid_{name}", repr(grid[name]))]
    return [*nodes, *edges, "-time_dt", repr(0.5 * summary["dT"])]


def compare(command, case, folder, options, time_limit):
    """The tests of a case, or the message of the run that failed."""
    run = attempt(command, case, folder, *options, time_limit=time_limit)
    if run.status != 0:
        return [], run.message
    finer = attempt(command, case, folder / "finer", *options, *finer_options(command, run.summary, folder),
                    time_limit=time_limit)
    if finer.status != 0:
        return [], f"finer grid: {finer.message}"
    return tests_of(case.stem, run.summary, finer.summary), ""


def by_quantity(tests):
    """The tests of each quantity whose errors are known."""
    found = collections.defaultdict(list)
    for test in tests:
        if test.error is not None:
            found[test.figure].append(test)
    return found


def farthest(tests):
    return max(tests, key=lambda test: test.distance)


def summary_lines(tests):
    """The table, then the misses."""
    unknown = collections.Counter(test.figure for test in tests if test.error is None)
    found = by_quantity(tests)
    yield heading("quantity", "cases", "within 1.1 errors", "farthest [errors]", "there", "median error", "not known")
    for name in dict.fromkeys(test.figure for test in tests):
        if not found[name]:
            yield row(name, 0, "", "", "", "", unknown[name])
            continue
        known, worst = found[name], farthest(found[name])
        yield row(name, len(known), f"{100 * sum(test.holds for test in known) / len(known):.0f} %",
                  f"{worst.distance:.2f}", worst.case, median_error(known), unknown[name])
    known = [test for tests_of_one in found.values() for test in tests_of_one]
    if known:
        yield f"\nall: {100 * sum(test.holds for test in known) / len(known):.1f} % of {len(known)}"
    for test in known:
        if not test.holds:
            yield (f"{test.case}: {test.figure} {test.value:.6g} ± {test.error:.2g}, finer {test.finer:.6g}, "
                   f"{test.distance:.2f} errors away")


def median_error(tests):
    return f"{100 * statistics.median(abs(test.error / test.value) for test in tests):.2g} %"


def shares(sets):
    """The table of the documents: a row a quantity, how many of each set of cases hold, and the farthest one."""
    found = {title: by_quantity(tests) for title, tests in sets.items()}
    first = next(iter(sets))
    yield heading("number", *(column for title in sets
                              for column in (f"{title}: within 1.1 bars", "farthest [bars]")), f"median bar, {first}")
    for name, tests in found[first].items():
        cells = []
        for title in sets:
            known = found[title][name]
            cells += [f"{sum(test.holds for test in known)} of {len(known)}",
                      f"{farthest(known).distance:.2f}" if known else ""]
        yield row(f"`{name}`", *cells, median_error(tests))


def options_of(assignments):
    return [word for text in assignments for word in (f"-{text.partition('=')[0]}", text.partition("=")[2])]
