#!/usr/bin/env python3
"""Converged films of 42 bare contacts, from those of gears to circular ones of moderate load, as a table (CSV).

    scripts/converged_contacts.py FOLDER [--table FILE]

Films are of the fitted discretisation (docs/discretisation.md). Every contact is solved on the domain and the grid of
film_laws.py (columns x_min, y_half, nx, ny, h_central, h_min), on a grid coarser by half along (coarse_x), along and
across (coarse), finer across (fine_y) and in both directions (fine), and with three times the inlet (long_inlet), a
longer outlet (long_outlet) and more room at the sides (wide); of the last three the table has the relative change of
the films. limit_... is extrapolated with order 3 from the finest two grids, error_... the deviation of h_... from it,
law_... the bound that film_laws.py has for it, steps along and across together, bar_... the program's bound from the
film and that on the grid coarse_x: a third of their difference over the film, and at least 0.35 % (central) or
1.25 % (smallest).

The table is written to FOLDER/converged_contacts.csv. The runs stay in FOLDER/runs: one that was made is not repeated,
so take a new folder when the program has changed. A cell is empty where a film was not solved, or would have taken a
grid of more than 1250000 nodes. About three minutes.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it. Exit status 1, with one line, where a run cannot
be made or a file not be written.
"""
import argparse
import csv
import json
import math
import pathlib
import random
import sys

import film_laws
from contacts import case_text
from film_laws import Domain
from oils import pressure_viscosity
from pairs import logarithmic
from runs import RunError, attempt, one_line_errors

AIM = 0.02                     # error of both films on the grid of the laws
SLENDER, MODERATE = 30, 12     # contacts
SEED = 7
VISCOSITIES = (0.009, 0.075)   # Pa s
TRIAL_LOAD = 1e4               # M
MOST_NODES = 1250000           # of the finest grid
TIME_LIMIT = 120               # s
LEAST_BARS = (0.0035, 0.0125)  # of the central and the smallest film, relative


class Solver:
    """Runs in a folder, each made once."""

    def __init__(self, folder):
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        self.path = folder / "runs.json"
        self.known = json.loads(self.path.read_text(encoding="utf-8")) if self.path.exists() else {}

    def run(self, command, contact, *options):
        """Summary, None where not solved."""
        text = case_text(**contact)
        key = " ".join([command, *map(str, options), text])
        if key not in self.known:
            case = self.folder / "case.yaml"
            case.write_text(text, encoding="utf-8")
            run = attempt(command, case, self.folder, *options, time_limit=TIME_LIMIT)
            if run.status == 1:
                raise RunError(run.message)
            if run.status != 0:
                print(f"converged_contacts: {' '.join(map(str, options))}: {run.message}", file=sys.stderr)
            self.known[key] = run.summary if run.status == 0 else None
            self.path.write_text(json.dumps(self.known), encoding="utf-8")
        return self.known[key]


def oil(draw):
    viscosity = logarithmic(draw, *VISCOSITIES)
    return {"viscosity": viscosity, "pressure_viscosity": pressure_viscosity(viscosity)}


def slender_contact(draw, part, solver):
    """As in gears: D in one of SLENDER parts of its range, 0.4 to 2.6 GPa, films above 5 nm."""
    D = 5e-4 * (0.06 / 5e-4) ** ((part + draw.random()) / SLENDER)
    while True:
        contact = {"M": TRIAL_LOAD, "L": logarithmic(draw, 4, 15), "D": D} | oil(draw)
        # Pressures of Hertz grow as the cube root of the load.
        growth = draw.uniform(0.4e9, 2.6e9) / solver.run("info", contact)["p_hertz"]
        contact["M"] *= growth ** 3
        if (1e3 < contact["M"] < 3e5
                and solver.run("info", contact)["nijenbanning_venner_moes_h_central"] > 5e-9):
            return contact


def moderate_contact(draw, part, solver):
    """M in one of MODERATE parts of 20..200; every third contact is circular."""
    while True:
        contact = {"M": 20 * 10 ** ((part + draw.random()) / MODERATE), "L": logarithmic(draw, 3, 30),
                   "D": 1.0 if part % 3 == 0 else logarithmic(draw, 0.1, 1)} | oil(draw)
        if 0.3e9 < solver.run("info", contact)["p_hertz"] < 3e9:
            return contact


def contacts(solver):
    draw = random.Random(SEED)
    return ([slender_contact(draw, part, solver) for part in range(SLENDER)]
            + [moderate_contact(draw, part, solver) for part in range(MODERATE)])


def longer(edges, step_x, step_y):
    """The domain with a longer inlet, a longer outlet, and wider, by whole steps."""
    def whole(length, step):
        return 2 * math.ceil(length / step / 2) * step

    return {"long_inlet": Domain(edges.x_min - whole(2 * (-1 - edges.x_min), step_x), edges.x_max, edges.y_half),
            "long_outlet": Domain(edges.x_min, edges.x_max + whole(0.75, step_x), edges.y_half),
            "wide": Domain(edges.x_min, edges.x_max, edges.y_half + whole(0.3 + edges.y_half - 1, step_y))}


def options(edges, grid):
    return ("-grid_nx", grid[0], "-grid_ny", grid[1], "-grid_x_min", edges.x_min, "-grid_x_max", edges.x_max,
            "-grid_y_half", edges.y_half)


def films(solver, contact, edges, grid):
    """Central and smallest film, None where not solved or where the grid is too large."""
    if grid[0] * grid[1] > MOST_NODES:
        return None
    summary = solver.run("steady", contact, "-film_discretisation", "fitted", *options(edges, grid))
    return summary and (summary["h_central"], summary["h_min"])


def changes(film, reference):
    """Relative deviations of both films."""
    return [new / old - 1 for new, old in zip(film, reference)] if film and reference else [None, None]


def limit(fine, coarse):
    """Extrapolated with order 3."""
    return [new + (new - old) / 7 for new, old in zip(fine, coarse)] if fine and coarse else None


def refinements(nx, ny):
    return {"coarse": ((nx + 1) // 2, (ny + 1) // 2), "coarse_x": ((nx + 1) // 2, ny), "": (nx, ny),
            "fine_y": (nx, 2 * ny - 1), "fine": (2 * nx - 1, 2 * ny - 1)}


def row(contact, solver):
    """One line of the table, as name and value."""
    derived = solver.run("info", contact)
    known = film_laws.groups(derived)
    edges, nx, ny = film_laws.grid(known, AIM)
    step_x, step_y = (edges.x_max - edges.x_min) / (nx - 1), 2 * edges.y_half / (ny - 1)
    line = contact | {"alpha_p_hertz": contact["pressure_viscosity"] * derived["p_hertz"], "kappa": known.kappa,
                      "H": known.H, "x_min": edges.x_min, "x_max": edges.x_max, "y_half": edges.y_half,
                      "nx": nx, "ny": ny}

    def add(name, values):
        line.update(zip((name.format("central"), name.format("min")), values or [None, None]))

    grids = refinements(nx, ny)
    solved = {name: films(solver, contact, edges, grid) for name, grid in grids.items()}
    for name, film in solved.items():
        add(f"{name}_h_{{}}".lstrip("_"), film)
    finest = solved["fine"]
    converged = limit(finest, solved[""]) if finest else limit(solved[""], solved["coarse_x"])
    add("limit_h_{}", converged)
    add("error_{}", changes(solved[""], converged))
    add("law_{}", [law(known, step_x, step_y) for law in (film_laws.central_error, film_laws.smallest_error)])
    add("bar_{}", [change if change is None else max(abs(change) / 3, least)
                   for change, least in zip(changes(solved["coarse_x"], solved[""]), LEAST_BARS)])
    for name, other in longer(edges, step_x, step_y).items():
        grid = (round((other.x_max - other.x_min) / step_x) + 1, round(2 * other.y_half / step_y) + 1)
        add(f"{name}_change_{{}}", changes(films(solver, contact, other, grid), solved[""]))
    return line


def cell(value):
    return "" if value is None else value if isinstance(value, int) else f"{value:.6g}"


def write_table(path, rows):
    with path.open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(rows[0])
        table.writerows([cell(value) for value in line.values()] for line in rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="folder of the runs and the table")
    parser.add_argument("--table", type=pathlib.Path, help="the table, in the folder if not given")
    arguments = parser.parse_args()
    with one_line_errors("converged_contacts", arguments.folder):
        solver = Solver(arguments.folder / "runs")
        rows = []
        for contact in contacts(solver):
            rows.append(row(contact, solver))
            print(", ".join(f"{name} {cell(rows[-1][name])}" for name in (
                "M", "L", "D", "H", "nx", "ny", "h_central", "error_central", "error_min")), flush=True)
            write_table(arguments.table or arguments.folder / "converged_contacts.csv", rows)


if __name__ == "__main__":
    main()
