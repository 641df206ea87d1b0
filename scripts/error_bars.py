#!/usr/bin/env python3
"""How often error bars hold: figures of films against those on a grid twice as fine along and across, same domain.

    scripts/error_bars.py FOLDER [CASE.yaml ...] [--command steady|periodic] [--pairs 40] [--first 0] [--seed 1]
                          [--option NAME=VALUE ...] [--time-limit 300]

The cases are those that are named, else pairs of scripts/catalogue.py. Every figure of a summary that has an error is
one test: does the figure of the finer grid (with half the time step for periodic states) lie within 1.1 errors? A table
has for each figure how many there are, the share that do, the largest distance in errors and where, and the median of
the errors over the figures; below it stands every miss. --option is given to all runs, such as grid_accuracy=0.05. It is
printed and written to FOLDER/error_bars.md; results stay in FOLDER.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it. Exit status 1, with one line, where a run cannot
be made or a file not be written.
"""
import argparse
import collections
import dataclasses
import pathlib
import statistics

from catalogue import add_arguments, write_pair
from catalogue_runs import domain_options
from runs import attempt, one_line_errors
from tables import heading, row

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


def summary_lines(tests):
    """The table, then the misses."""
    by_figure = collections.defaultdict(list)
    for test in tests:
        by_figure[test.figure].append(test)
    yield heading("figure", "cases", "within 1.1 errors", "farthest [errors]", "there", "median error", "not known")
    for figure, all_of in by_figure.items():
        known = [test for test in all_of if test.error is not None]
        if not known:
            yield row(figure, 0, "", "", "", "", len(all_of))
            continue
        worst = max(known, key=lambda test: test.distance)
        share = sum(test.holds for test in known) / len(known)
        median = statistics.median(abs(test.error / test.value) for test in known)
        yield row(figure, len(known), f"{100 * share:.0f} %", f"{worst.distance:.2f}", worst.case,
                  f"{100 * median:.2g} %", len(all_of) - len(known))
    known = [test for test in tests if test.error is not None]
    if known:
        yield f"\nall: {100 * sum(test.holds for test in known) / len(known):.1f} % of {len(known)}"
    for test in known:
        if not test.holds:
            yield (f"{test.case}: {test.figure} {test.value:.6g} +- {test.error:.2g}, finer {test.finer:.6g}, "
                   f"{test.distance:.2f} errors away")


def options_of(assignments):
    return [word for text in assignments for word in (f"-{text.partition('=')[0]}", text.partition("=")[2])]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    add_arguments(parser)
    parser.add_argument("cases", nargs="*", type=pathlib.Path, metavar="CASE.yaml", help="in place of the catalogue")
    parser.add_argument("--command", choices=("steady", "periodic"), default="steady", help="(%(default)s)")
    parser.add_argument("--option", action="append", default=[], metavar="NAME=VALUE", help="for all runs")
    parser.add_argument("--time-limit", type=float, default=300.0, help="of a run [s] (%(default)s)")
    arguments = parser.parse_args()
    with one_line_errors("error_bars", arguments.folder):
        cases = arguments.cases or [write_pair(arguments.folder, arguments.seed, number)[0] for number
                                    in range(arguments.first, arguments.first + arguments.pairs)]
        tests, failures = [], []
        for case in cases:
            place = arguments.folder / arguments.command / case.stem
            place.mkdir(parents=True, exist_ok=True)
            of_case, failure = compare(arguments.command, case, place, options_of(arguments.option),
                                       arguments.time_limit)
            tests += of_case
            if failure:
                failures.append(f"{case.stem}: {failure}")
            misses = [test.figure for test in of_case if test.error is not None and not test.holds]
            print(f"{case.stem}: {failure or len(of_case)} {' '.join(misses)}", flush=True)
        text = "\n".join([*summary_lines(tests), *failures]) + "\n"
        (arguments.folder / "error_bars.md").write_text(text, encoding="utf-8")
        print("\n" + text, end="")


if __name__ == "__main__":
    main()
