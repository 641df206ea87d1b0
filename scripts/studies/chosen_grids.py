#!/usr/bin/env python3
"""Whether films on the grids of the program's choice have the accuracy that they were chosen for.

    scripts/studies/chosen_grids.py FOLDER [--contacts 200] [--seed 1] [--accuracy 0.02] [--finer 3]

Bare contacts of steel are drawn at random: M in 20..3e5, L in 3..30, D in 5e-4..1, each uniform in its logarithm, oils
of 0.009 to 0.075 Pa s; those of Hertz pressures outside 0.3..3 GPa or of films below 5 nm (by the formula of
Nijenbanning, Venner and Moes) are drawn again. `steady` solves each on the domain and grid of its choice, and on the
same domain with --finer times as many intervals along and across, twice as many where that would be more than three
million nodes. A deviation of the central or the smallest film from the finer one by more than the accuracy is a miss.
The deviations are printed. A table of the misses, with their number and those of contacts whose deviations exceed 1.1
error bars and of those not solved, is written to FOLDER/chosen_grids.md. Runs stay in FOLDER/runs, and one that was
made is not repeated, so take a new folder when the program has changed. About twenty minutes.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it. Exit status 1, with one line, where a run cannot
be made or a file not be written.
"""
import argparse
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
# pylint: disable=wrong-import-position
from converged_contacts import Solver, oil  # noqa: E402
from pairs import logarithmic  # noqa: E402
from runs import RunError, one_line_errors  # noqa: E402
from tables import heading, percent, row  # noqa: E402

FILMS = ("h_central", "h_min")
COLUMNS = ("M", "L", "D", "kappa", "nodes", "central film (its bar)", "smallest film (its bar)")
MOST_NODES = 3000000           # of the finer grid


def random_contact(draw, solver):
    while True:
        contact = {"M": logarithmic(draw, 20, 3e5), "L": logarithmic(draw, 3, 30),
                   "D": logarithmic(draw, 5e-4, 1), "own_domain": True} | oil(draw)
        try:
            derived = solver.run("info", contact)
        except RunError:  # no elastic contact carries it
            continue
        if (0.3e9 < derived["p_hertz"] < 3e9 and derived["nijenbanning_venner_moes_h_central"] > 5e-9):
            return contact, derived


def finer_grid(chosen, factor):
    """Options for factor times the intervals; twice as many where the grid would be too large."""
    nx, ny = (factor * (chosen[name] - 1) + 1 for name in ("nx", "ny"))
    return ("-grid_nx", nx, "-grid_ny", ny) if factor == 2 or nx * ny <= MOST_NODES else finer_grid(chosen, 2)


class Outcome:
    """What became of the contacts so far."""

    def __init__(self, accuracy):
        self.accuracy = accuracy
        self.compared = self.beyond_bars = 0
        self.misses, self.unsolved = [], []

    def add(self, contact, kappa, summary, finer):
        """A line for the screen."""
        name = [f"{contact[group]:.4g}" for group in ("M", "L", "D")] + [f"{kappa:.3g}"]
        if summary is None or finer is None:
            self.unsolved.append(", ".join(name) + (": on its own grid" if summary is None else ": on the finer grid"))
            return row(*name, "not solved")
        self.compared += 1
        errors = {film: summary[film] / finer[film] - 1 for film in FILMS}
        bars = {film: summary[f"{film}_error"] / summary[film] for film in FILMS}
        line = row(*name, f"{summary['nx']} x {summary['ny']}",
                   *[f"{percent(errors[film], 2)} ({percent(bars[film], 2)})" for film in FILMS])
        self.beyond_bars += any(abs(errors[film]) > 1.1 * bars[film] for film in FILMS)
        if any(abs(error) > self.accuracy for error in errors.values()):
            self.misses.append(line)
        return line

    def text(self):
        return "\n".join([heading(*COLUMNS), *self.misses, "",
                          f"{len(self.misses)} of {self.compared} contacts miss {100 * self.accuracy:g} %, "
                          f"{self.beyond_bars} exceed 1.1 error bars; {len(self.unsolved)} were not solved.", "",
                          *[f"- {line}" for line in self.unsolved]]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="folder of the runs and the table")
    parser.add_argument("--contacts", type=int, default=200, help="number of contacts (%(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the random draw (%(default)s)")
    parser.add_argument("--accuracy", type=float, default=0.02, help="of the program's choice (%(default)s)")
    parser.add_argument("--finer", type=int, default=3, help="intervals of the reference in one (%(default)s)")
    arguments = parser.parse_args()
    with one_line_errors("chosen_grids", arguments.folder):
        solver = Solver(arguments.folder / "runs")
        draw, outcome = random.Random(arguments.seed), Outcome(arguments.accuracy)
        print(heading(*COLUMNS), flush=True)
        for _ in range(arguments.contacts):
            contact, derived = random_contact(draw, solver)
            summary = solver.run("steady", contact, "-grid_accuracy", arguments.accuracy)
            finer = summary and solver.run("steady", contact, *finer_grid(summary, arguments.finer))
            print(outcome.add(contact, derived["kappa"], summary, finer), flush=True)
            (arguments.folder / "chosen_grids.md").write_text(outcome.text(), encoding="utf-8")
        print("\n" + outcome.text())


if __name__ == "__main__":
    main()
