#!/usr/bin/env python3
"""What the solvers need on anybody's gears, and what they leave: 42 bare contacts and 12 marches, as Markdown tables.

    scripts/solver_survey.py FOLDER [--refinements N] [--mesh-periods 0.4] [--tight]

Contacts: those of docs/data/converged_contacts.csv (M 20 to 3e5, L 3 to 30, D 5e-4 to 1), each from nothing on the
table's domain and the program's grid, then with nodes twice as close along X, N times (1): Newton iterations on the
finest grid, Krylov iterations a linear solve there. Marches: twelve pairs of scripts/catalogue.py on defaults, from
rest at the pitch point: Newton and Krylov iterations a step, the shortest step that Newton's method forced over the
nominal one. With --tight each march a second time with tight tolerances: the largest differences over all steps, of
H_0 and V_0, and relative of the films. Tables are printed, and written to FOLDER/contacts.md, FOLDER/marches.md and
FOLDER/accuracy.md, with what is worst under each. Case files and results stay in FOLDER. Three to eight minutes, and
one to four for the tight marches.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it. Exit status 1, with one line, where a run cannot
be made or a file not be written.
"""
import argparse
import csv
import itertools
import pathlib

from gearfilm import packages

packages.go_on_with(packages.TABLES, "solver_survey")
# pylint: disable=wrong-import-position
import h5py  # noqa: E402
import numpy  # noqa: E402

from catalogue import SEED, write_pair
from contacts import case_text
from runs import SOURCE, attempt, one_line_errors
from tables import heading, row

CONTACTS = SOURCE / "docs/data/converged_contacts.csv"
MARCHES = (0, 1, 2, 3, 5, 6, 7, 13, 15, 16, 33, 34)    # of the catalogue's first seed
TIME_LIMIT = 300               # s
MOST_NODES = 1000000           # of a finer grid; cells of larger ones stay empty
SHORTEST = 1e-6                # of the nominal step: shorter ones are the time scheme's own beginnings
TIGHT = ("-time_newton_tolerance", 1e-8, "-time_krylov_tolerance", 0.01, "-time_late_krylov_tolerance", 0.001,
         "-solver_precision", "double")


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


def differences(folder, tight):
    """Largest of two marches at the times of both: of H_0 and V_0, relative of the central and the smallest film."""
    with h5py.File(folder / "results.h5") as first, h5py.File(tight / "results.h5") as second:
        for table, columns in (("steps", ("H0", "V0")), ("contacts", ("h_central", "h_min"))):
            rows, others = (file[f"history/{table}"][:] for file in (first, second))
            keys = [[(round(line["T"], 9), line["contact"] if table == "contacts" else 0) for line in lines]
                    for lines in (rows, others)]
            places = {key: place for place, key in enumerate(keys[1])}
            common = [(place, places[key]) for place, key in enumerate(keys[0]) if key in places]
            rows, others = rows[[pair[0] for pair in common]], others[[pair[1] for pair in common]]
            for column in columns:
                change = numpy.abs(rows[column].astype(float) - others[column])
                yield (change / others[column] if table == "contacts" else change).max()


def accuracy_lines(folder, mesh_periods):
    """Of marches that are there already."""
    worst = numpy.zeros(4)
    for number in MARCHES:
        case = folder / f"{SEED}-{number}.yaml"
        place, tight = folder / case.stem, folder / f"{case.stem}_tight"
        run = attempt("transient", case, tight, "-mesh_periods", mesh_periods, *TIGHT, time_limit=TIME_LIMIT)
        if run.status != 0 or not (place / "results.h5").exists():
            message = run.message or run.status if run.status != 0 else "no march to compare with"
            yield row(number, "", "", "", "", message)
            continue
        found = numpy.array(list(differences(place, tight)))
        worst = numpy.maximum(worst, found)
        yield row(number, *(f"{value:.1e}" for value in found), "")
    yield "\nlargest: " + ", ".join(f"{value:.1e}" for value in worst)


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
    parser.add_argument("--tight", action="store_true", help="each march with tight tolerances too")
    arguments = parser.parse_args()
    with one_line_errors("solver_survey", arguments.folder):
        arguments.folder.mkdir(parents=True, exist_ok=True)
        grids = [name for _ in range(arguments.refinements + 1) for name in ("grid", "Newton", "Krylov a solve")]
        write_table(arguments.folder / "contacts.md", ("M", "L", "D", *grids),
                    contact_lines(arguments.folder, arguments.refinements))
        write_table(arguments.folder / "marches.md",
                    ("pair", "M", "L", "swings", "steps", "Newton a step", "Krylov a step", "shortest step", "message"),
                    march_lines(arguments.folder, arguments.mesh_periods))
        if arguments.tight:
            write_table(arguments.folder / "accuracy.md",
                        ("pair", "H_0", "V_0", "central film", "smallest film", "message"),
                        accuracy_lines(arguments.folder, arguments.mesh_periods))


if __name__ == "__main__":
    main()
