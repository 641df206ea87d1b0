#!/usr/bin/env python3
"""Stationary films over a range of Moes groups, M = 20..2400, L = 5..27, D = 1..0.06, as a Markdown table.

    scripts/verify_range.py      film, error of the grid, film formulas

The contacts are the bare ones of contacts.py, the discretisation is `central`, whose errors are of second order. Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it.
All runs work in a temporary folder. Exit status 1, with one line, where a run cannot be made.
"""
import argparse
import pathlib
import sys
import tempfile

from contacts import FORMULA_HEADING, RATIOS, case_text, finer, formula_cells, grid_of, grid_options
from runs import RunError, gearfilm
from tables import heading, percent, row

LOADS = (20, 200, 800, 2400)   # M
OILS = (5, 10, 27)             # L
NODES = 129                    # in x


def steady(case, folder, grid):
    return gearfilm("steady", case, folder, "-film_discretisation", "central", *grid_options(grid))


def range_row(M, L, D, folder):
    grid = grid_of(D, NODES)
    case = folder / "case.yaml"
    case.write_text(case_text(M, L, D), encoding="utf-8")
    pressure = gearfilm("info", case, folder)["p_hertz"]
    film = steady(case, folder, grid)
    head = (M, L, D, f"{1e-9 * pressure:.2f}", f"{grid[0]} x {grid[1]}")
    if film is None:
        return row(*head, "not solved", *5 * [""])
    fine = steady(case, folder, finer(grid))

    def with_error(name):
        # Second order: a halved step leaves a quarter of the error.
        error = "not solved" if fine is None else percent(4 / 3 * (film[name] / fine[name] - 1))
        return f"{film[name]:.5f} ({error})"

    return row(*head, with_error("H_central"), with_error("H_min"),
               f"{film['newton_iterations']} / {film['krylov_iterations']}", *formula_cells(film))


def print_range(folder):
    print(heading("M", "L", "D", "p_h [GPa]", "grid", "H_central (error)", "H_min (error)", "Newton / Krylov",
                  *FORMULA_HEADING))
    for D in RATIOS:
        for M in LOADS:
            for L in OILS:
                print(range_row(M, L, D, folder), flush=True)


def main():
    argparse.ArgumentParser(description=__doc__.split("\n", 1)[0]).parse_args()
    try:
        with tempfile.TemporaryDirectory() as folder:
            print_range(pathlib.Path(folder))
    except RunError as error:
        sys.exit(f"verify_range: {error}")


if __name__ == "__main__":
    main()
