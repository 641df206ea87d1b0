#!/usr/bin/env python3
"""The pairs of scripts/catalogue.py on nothing but the program's defaults: one line a pair, as a Markdown table.

    scripts/catalogue_runs.py FOLDER steady|periodic ... [--pairs 40] [--first 0] [--seed 1] [--time-limit 600]

steady: exit status, central and smallest film, the extrapolated central film and the error that the summary gives of it
(h_central_extrapolated, h_central_error [m], if it has them), the central film on a grid twice as fine along and across
on the same domain, how far that is away, and whether that is within the error. periodic: exit status, seconds, mesh
periods, Newton iterations a time step, the message of one that failed. Runs are made one after the other; one that is
longer than the time limit [s] is ended. The tables are printed, and written to FOLDER/steady.md and FOLDER/periodic.md;
under each stands what became of all pairs. Case files and results stay in FOLDER.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it. Exit status 1, with one line, where a run cannot
be made or a file not be written.
"""
import argparse
import collections

from gearfilm import packages

packages.go_on_with(packages.TABLES, "catalogue_runs")
# pylint: disable=wrong-import-position
import h5py  # noqa: E402

from catalogue import add_arguments, write_pair
from runs import attempt, one_line_errors
from tables import heading, percent, row

PAIR = ("pair", "M", "L", "D", "p_h [GPa]")
STEADY = ("status", "s", "grid", "h_central [um]", "h_min [um]", "extrapolated", "error", "twice as fine", "s",
          "deviation", "inside", "message")
PERIODIC = ("status", "s", "mesh periods", "Newton iterations a step", "message")
GRID_TOTALS = ("steps", "newton_iterations")


def micrometres(length):
    return "" if length is None else f"{1e6 * length:.5g}"


def pair_cells(number, derived):
    return (number, f"{derived['M']:.0f}", f"{derived['L']:.1f}", f"{derived['D']:.2g}",
            f"{1e-9 * derived['p_hertz']:.2f}")


def domain_options(folder):
    """The domain that the program has chosen, to be kept on another grid."""
    with h5py.File(folder / "results.h5") as results:
        return [word for name in ("x_min", "x_max", "y_half")
                for word in (f"-grid_{name}", repr(float(results.attrs[name])))]


def steady_cells(case, folder, time_limit):
    """Cells of a table line, and what became of the run in a word."""
    run = attempt("steady", case, folder, time_limit=time_limit)
    if run.status != 0:
        return (run.status, f"{run.seconds:.1f}", *9 * [""], run.message), f"status {run.status}"
    film = run.summary
    nodes = 2 * film["nx"] - 1, 2 * film["ny"] - 1
    finer = attempt("steady", case, folder / "finer", "-grid_nx", nodes[0], "-grid_ny", nodes[1],
                    *domain_options(folder), time_limit=time_limit)
    error, deviation, inside, fine = film.get("h_central_error"), "", "", None
    if finer.status == 0:
        fine = finer.summary["h_central"]
        deviation = percent(fine / film["h_central"] - 1, 2)
        if error is not None:
            inside = "yes" if abs(fine - film["h_central"]) <= error else "no"
    word = {"yes": "inside", "no": "outside"}.get(inside, "no error given" if fine else "finer grid not solved")
    return (run.status, f"{run.seconds:.1f}", f"{film['nx']} x {film['ny']}", micrometres(film["h_central"]),
            micrometres(film["h_min"]), micrometres(film.get("h_central_extrapolated")), micrometres(error),
            micrometres(fine), f"{finer.seconds:.1f}", deviation, inside, finer.message), word


def periodic_cells(case, folder, time_limit):
    """Cells of a table line, and what became of the run in a word."""
    run = attempt("periodic", case, folder, time_limit=time_limit)
    summary = run.summary if run.status in (0, 2, 3) and run.summary else {}
    # Where no periodic state was found, the summary is that of the periods marched.
    periods = summary.get("periods", [summary] if summary else [])
    steps, iterations = (sum(period.get(name, 0) for period in periods) for name in GRID_TOTALS)
    cells = (run.status, f"{run.seconds:.1f}", summary.get("periods_used", len(periods) or ""),
             f"{iterations / steps:.1f}" if steps else "", "" if run.status == 0 else run.message)
    return cells, f"status {run.status}"


COMMANDS = {"steady": (STEADY, steady_cells), "periodic": (PERIODIC, periodic_cells)}


def make_table(command, pairs, folder, time_limit):
    """Runs pairs, given by number, case file and derived quantities; prints and writes each line at once."""
    columns, cells_of = COMMANDS[command]
    became = collections.Counter()
    with (folder / f"{command}.md").open("w", encoding="utf-8") as table:
        def say(line):
            print(line, flush=True)
            print(line, file=table, flush=True)

        say(heading(*PAIR, *columns))
        for number, case, derived in pairs:
            place = folder / command / case.stem
            place.mkdir(parents=True, exist_ok=True)
            cells, word = cells_of(case, place, time_limit)
            became[word] += 1
            say(row(*pair_cells(number, derived), *cells))
        say("\n" + ", ".join(f"{word}: {count}" for word, count in sorted(became.items())))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    add_arguments(parser)
    parser.add_argument("commands", nargs="+", choices=COMMANDS, metavar="COMMAND", help=" or ".join(COMMANDS))
    parser.add_argument("--time-limit", type=float, default=600.0, help="of a run [s] (%(default)s)")
    arguments = parser.parse_args()
    with one_line_errors("catalogue_runs", arguments.folder):
        pairs = [(number, *write_pair(arguments.folder, arguments.seed, number))
                 for number in range(arguments.first, arguments.first + arguments.pairs)]
        for command in arguments.commands:
            make_table(command, pairs, arguments.folder, arguments.time_limit)


if __name__ == "__main__":
    main()
