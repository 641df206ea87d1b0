#!/usr/bin/env python3
"""What the solvers need on anybody's gears: iterations over 42 bare contacts and 12 marches, as two Markdown tables.

    scripts/solver_survey.py FOLDER [--refinements N] [--mesh-periods 0.4]

Contacts: those of docs/data/converged_contacts.csv (M 20 to 3e5, L 3 to 30, D 5e-4 to 1), each from nothing on the
table's domain and the program's grid, then with nodes twice as close along X, N times (1): Newton iterations on the
finest grid, Krylov iterations a linear solve there. Marches: twelve pairs of scripts/catalogue.py on defaults, from
rest at the pitch point: Newton and Krylov iterations a step, the shortest step that Newton's method forced over the
nominal one. Tables are printed, and written to FOLDER/contacts.md and FOLDER/marches.md, with what is worst under each. Case files
and results stay in FOLDER. About eight minutes.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it. Exit status 1, with one line, where a run cannot
be made or a file not be written.
"""
import argparse
import csv
import itertools
import pathlib

import h5py

from catalogue import SEED, write_pair
from contacts import case_text
from runs import SOURCE, attempt, one_line_errors
from tables import heading, row

CONTACTS = SOURCE / "docs/data/converged_contacts.csv"
MARCHES = (0, 1, 2, 3, 5, 6, 7, 13, 15, 16, 33, 34)    # of the catalogue's first seed
TIME_LIMIT = 300               # s
MOST_NODES = 1000000           # of a finer grid; cells of larger ones stay empty
SHORTEST = 1e-6                # of the nominal step: shorter ones are the time scheme's own beginnings


def contact_lines(folder, refinements):
    """Lines of the table, and the worst of each column."""
    worst = [[0, 0.0] for _ in range(refinements + 1)]
    with CONTACTS.open(encoding="utf-8", newline="") as table:
        contacts = list(csv.DictReader(table))
    for number, contact in enumerate(contacts):
        groups = {name: float(contact[name]) for name in ("M", "L", "D", "viscosity", "pressure_viscosity")}
        case = folder / f"contact{number}.yaml"
        case.write_text(case_text(**groups), encoding="utf-8")
        edges = [word for name in ("x_min", "x_max", "y_half") for word in (f"-grid_{name}", contact[name])]
        cells, grid = [], ()
        for level in range(refinements + 1):
            if grid and grid[1] * grid[3] > MOST_NODES:
                cells += [f"{grid[1]} x {grid[3]}", "", ""]
                continue
            run = attempt("steady", case, folder / f"contact{number}", *edges, *grid, time_limit=TIME_LIMIT)
            if run.status != 0:
                cells += [" x ".join(str(nodes) for nodes in grid[1::2]), run.message or run.status, ""]
                break
            nodes = run.summary["nx"], run.summary["ny"]
            grid = "-grid_nx", 2 * nodes[0] - 1, "-grid_ny", nodes[1]
            newton, krylov = run.summary["newton_iterations"], run.summary["krylov_iterations"]
            a_solve = krylov / max(newton, 1)
            worst[level] = [max(worst[level][0], newton), max(worst[level][1], a_solve)]
            cells += [f"{nodes[0]} x {nodes[1]}", newton, f"{a_solve:.1f}"]
        yield row(f"{groups['M']:.3g}", f"{groups['L']:.3g}", f"{groups['D']:.2g}", *cells)
    yield "\nlargest: " + "; ".join(f"{newton} Newton iterations, {krylov:.1f} Krylov iterations a solve"
                                    for newton, krylov in worst)


def march_lines(folder, mesh_periods):
    worst = 0.0
    for number in MARCHES:
        case, derived = write_pair(folder, SEED, number)
        place = folder / case.stem
        run = attempt("transient", case, place, "-mesh_periods", mesh_periods, time_limit=TIME_LIMIT)
        results = place / "results.h5"
        cells = ("", "", "", "", run.message or run.status)
        if run.status == 0:
            with h5py.File(results) as file:
                steps = file["history/steps"][:]
            steps = steps[steps["dT"] > SHORTEST * steps["dT"].max()]
            newton = steps["newton"].mean()
            worst = max(worst, newton)
            cut = steps["dT"].min() / steps["dT"].max()
            cells = (len(steps), f"{newton:.2f}", f"{steps['krylov'].mean():.1f}", f"{cut:.3f}", "")
        swings = derived["f_n"] / derived["f_m"]
        yield row(number, f"{derived['M']:.0f}", f"{derived['L']:.1f}", f"{swings:.1f}", *cells)
    yield f"\nlargest: {worst:.1f} Newton iterations a step"


def write_table(path, columns, lines):
    with path.open("w", encoding="utf-8") as table:
        for line in itertools.chain([heading(*columns)], lines):
            print(line, flush=True)
            print(line, file=table, flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="folder of the case files, results and tables")
    parser.add_argument("--refinements", type=int, default=1, help="of each contact's grid along X (%(default)s)")
    parser.add_argument("--mesh-periods", type=float, default=0.4, help="of each march (%(default)s)")
    arguments = parser.parse_args()
    with one_line_errors("solver_survey", arguments.folder):
        arguments.folder.mkdir(parents=True, exist_ok=True)
        grids = [name for _ in range(arguments.refinements + 1) for name in ("grid", "Newton", "Krylov a solve")]
        write_table(arguments.folder / "contacts.md", ("M", "L", "D", *grids),
                    contact_lines(arguments.folder, arguments.refinements))
        write_table(arguments.folder / "marches.md",
                    ("pair", "M", "L", "swings", "steps", "Newton a step", "Krylov a step", "shortest step", "message"),
                    march_lines(arguments.folder, arguments.mesh_periods))


if __name__ == "__main__":
    main()
