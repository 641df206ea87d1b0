#!/usr/bin/env python3
"""Stationary films over a range of Moes groups, and their convergence, as Markdown tables.

    scripts/verify_range.py range     M = 20..2400, L = 5..27, D = 1..0.06: film, error of the grid, film formulas
    scripts/verify_range.py domain    the same step on a longer and a wider domain, for the short one of M >= 200
    scripts/verify_range.py grids     pitch film of input/barbieri2013.yaml on four grids, with the observed order

The contacts are bare ones of steel, R_x = 12.5 mm, in one oil: load and velocity follow from M and L, R_y from D.
Environment: GEARFILM, the binary. All runs work in a temporary folder.
"""
import argparse
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[1]
PROGRAM = os.environ.get("GEARFILM", str(SOURCE / "build/release/bin/gearfilm"))

LOADS = (20, 200, 800, 2400)   # M
OILS = (5, 10, 27)             # L
RATIOS = (1, 0.3, 0.06)        # D = R_x/R_y
RADIUS_X = 12.5e-3             # m
REDUCED_MODULUS = 226e9        # Pa
VISCOSITY = 0.04               # Pa s
PRESSURE_VISCOSITY = 2.2e-8    # 1/Pa
LONG_DOMAIN = (-4.5, 1.5, 3.0)
SHORT_DOMAIN = (-2.083, 1.25, 1.1)
DOMAIN_GROUPS = ((200, 5), (200, 10), (200, 27), (800, 10), (2400, 10), (2400, 27))
PITCH_CASE = SOURCE / "input/barbieri2013.yaml"
PITCH_GRIDS = ((65, 33), (129, 65), (257, 129), (513, 257))


class VerifyError(Exception):
    """Something that keeps the tables from being made; the text is for the user."""


def case_text(M, L, D, domain):
    """A bare contact with these groups: U = 2 eta_0 u_m/(E' R_x) = (L/(alpha E'))^4, w = M E' R_x^2 U^(3/4)."""
    U = (L / (PRESSURE_VISCOSITY * REDUCED_MODULUS)) ** 4
    return f"""
case: {{kind: contact}}
contact:
  radius_x: {RADIUS_X!r}
  radius_y: {RADIUS_X / D!r}
  reduced_modulus: {REDUCED_MODULUS!r}
  load: {M * REDUCED_MODULUS * RADIUS_X ** 2 * U ** 0.75!r}
  entrainment_velocity: {U * REDUCED_MODULUS * RADIUS_X / (2 * VISCOSITY)!r}
lubricant: {{viscosity: {VISCOSITY!r}, pressure_viscosity: {PRESSURE_VISCOSITY!r}}}
grid: {{x_min: {domain[0]!r}, x_max: {domain[1]!r}, y_half: {domain[2]!r}}}
"""


def gearfilm(command, case, folder, *options):
    """Summary of one run; None, with the message on stderr, where it was not solved (exit status 2)."""
    words = [PROGRAM, command, str(case), "-output_dir", str(folder), *map(str, options)]
    try:
        run = subprocess.run(words, capture_output=True, text=True, check=False)
    except OSError as error:
        raise VerifyError(f"cannot run {PROGRAM}: {error.strerror}; set GEARFILM or run scripts/setup.sh") from None
    if run.returncode == 2:
        print(run.stderr.strip(), file=sys.stderr)
        return None
    if run.returncode != 0:
        raise VerifyError(f"'{' '.join(words)}' failed: {run.stderr.strip()}")
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))


def steady(case, folder, grid, *options):
    return gearfilm("steady", case, folder, "-grid_nx", grid[0], "-grid_ny", grid[1], *options)


def grid_of(D):
    return (129, 129) if D == 1 else (129, 65)


def finer(grid):
    return 2 * grid[0] - 1, 2 * grid[1] - 1


def percent(value, reference):
    return f"{100 * (value / reference - 1):+.1f} %"


def range_row(M, L, D, folder):
    grid = grid_of(D)
    case = folder / "case.yaml"
    # Not left to the program: at M = 200 round-off would choose.
    case.write_text(case_text(M, L, D, LONG_DOMAIN if M < 200 else SHORT_DOMAIN), encoding="utf-8")
    pressure = gearfilm("info", case, folder)["p_hertz"]
    film = steady(case, folder, grid)
    head = f"| {M} | {L} | {D} | {1e-9 * pressure:.2f} | {grid[0]} x {grid[1]} |"
    if film is None:
        return head + " not solved | | | | | |"
    fine = steady(case, folder, finer(grid))

    def error(name):
        # Second order: a halved step leaves a quarter of the error.
        return "not solved" if fine is None else f"{100 * 4 / 3 * (film[name] / fine[name] - 1):+.1f} %"

    return (f"{head} {film['H_central']:.5f} ({error('H_central')}) | {film['H_min']:.5f} ({error('H_min')}) |"
            f" {film['newton_iterations']} / {film['krylov_iterations']} | {formula_cells(film)} |")


def formula_cells(film):
    predictions = film["predictions"]
    return " | ".join((percent(predictions["hamrock_dowson_h_central"], film["h_central"]),
                       percent(predictions["hamrock_dowson_h_min"], film["h_min"]),
                       percent(predictions["nijenbanning_venner_moes_h_central"], film["h_central"])))


def print_heading(*columns):
    print(f"| {' | '.join(columns)} |\n|{'---|' * len(columns)}")


def print_range(folder):
    print_heading("M", "L", "D", "p_h [GPa]", "grid", "H_central (error)", "H_min (error)", "Newton / Krylov",
                  "H-D central", "H-D smallest", "N-V-M central")
    for D in RATIOS:
        for M in LOADS:
            for L in OILS:
                print(range_row(M, L, D, folder), flush=True)


def domain_row(name, case, grid, folder):
    """Films on the short domain, with the inlet 0.75 of its length longer, and also twice as wide: steps unchanged."""
    x_min, x_max, y_half = SHORT_DOMAIN
    inlet = ("-grid_x_min", x_min - 0.75 * (x_max - x_min))
    nx = grid[0] + 3 * (grid[0] - 1) // 4
    short = steady(case, folder, grid)
    long = steady(case, folder, (nx, grid[1]), *inlet)
    wide = steady(case, folder, (nx, 2 * grid[1] - 1), *inlet, "-grid_y_half", 2 * y_half)
    if short is None or long is None or wide is None:
        return f"| {name} | not solved | | | | | | |"
    changes = [percent(film[height], short[height]) for height in ("H_central", "H_min") for film in (long, wide)]
    return f"| {name} | {' | '.join(changes)} | {formula_cells(wide)} |"


def print_domain(folder):
    print_heading("case", "H_central: long inlet", "and wide", "H_min: long inlet", "and wide", "H-D central",
                  "H-D smallest", "N-V-M central")
    print(domain_row("Table 3 pitch", PITCH_CASE, (129, 65), folder), flush=True)
    case = folder / "case.yaml"
    for D in RATIOS:
        for M, L in DOMAIN_GROUPS:
            case.write_text(case_text(M, L, D, SHORT_DOMAIN), encoding="utf-8")
            print(domain_row(f"M = {M}, L = {L}, D = {D}", case, grid_of(D), folder), flush=True)


def order_text(values):
    """Observed order and converged value from the last three of a sequence of halved steps."""
    if len(values) < 3:
        return "", ""
    coarse, middle, fine = values[-3:]
    ratio = (middle - coarse) / (fine - middle)
    if ratio <= 1:
        return "none", ""
    return f"{math.log2(ratio):.2f}", f"{fine + (fine - middle) / (ratio - 1):.4f}"


def print_grids(folder):
    print_heading("grid", "h_central [um]", "order", "limit", "h_min [um]", "order", "limit", "Newton / Krylov")
    central, smallest = [], []
    for grid in PITCH_GRIDS:
        film = steady(PITCH_CASE, folder, grid)
        if film is None:
            raise VerifyError(f"the pitch film on {grid[0]} x {grid[1]} nodes was not solved")
        central.append(1e6 * film["h_central"])
        smallest.append(1e6 * film["h_min"])
        print(f"| {grid[0]} x {grid[1]} | {central[-1]:.4f} | {' | '.join(order_text(central))} | {smallest[-1]:.4f} |"
              f" {' | '.join(order_text(smallest))} | {film['newton_iterations']} / {film['krylov_iterations']} |",
              flush=True)


TABLES = {"range": print_range, "domain": print_domain, "grids": print_grids}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("table", choices=TABLES)
    table = TABLES[parser.parse_args().table]
    try:
        with tempfile.TemporaryDirectory() as folder:
            table(pathlib.Path(folder))
    except VerifyError as error:
        sys.exit(f"verify_range: {error}")


if __name__ == "__main__":
    main()
