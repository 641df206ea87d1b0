#!/usr/bin/env python3
"""Stationary films over a range of Moes groups, and their convergence with the grid, as Markdown tables.

    scripts/verify_range.py range [--domain paper|long]     M = 20..2400, L = 5..27, D = 1..0.06
    scripts/verify_range.py grids [--domain paper|long]     pitch film of input/barbieri2013.yaml on four grids

The contacts of `range` are bare ones of steel, R_x = 12.5 mm, in one oil: load and velocity follow from M and L,
R_y from D. Domain `paper` is the program's choice, X from -2.083 and |y| <= 1.1 b for M >= 200; `long` is X from -4.5 and
|y| <= 3 b for all. Environment: GEARFILM, the binary. The runs work in a temporary folder.
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


def finer(grid):
    return 2 * grid[0] - 1, 2 * grid[1] - 1


def percent(value, reference):
    return f"{100 * (value / reference - 1):+.1f} %"


def range_row(M, L, D, folder, long_domain):
    grid = (129, 129) if D == 1 else (129, 65)
    case = folder / "case.yaml"
    case.write_text(case_text(M, L, D, LONG_DOMAIN if long_domain or M < 200 else SHORT_DOMAIN), encoding="utf-8")
    pressure = gearfilm("info", case, folder)["p_hertz"]
    film = steady(case, folder, grid)
    head = f"| {M} | {L} | {D} | {1e-9 * pressure:.2f} | {grid[0]} x {grid[1]} |"
    if film is None:
        return head + " not solved | | | | | |"
    fine = steady(case, folder, finer(grid))

    def error(name):
        # Second order: a halved step leaves a quarter of the error.
        return "not solved" if fine is None else f"{100 * 4 / 3 * (film[name] / fine[name] - 1):+.1f} %"

    predictions = film["predictions"]
    return (f"{head} {film['H_central']:.5f} ({error('H_central')}) | {film['H_min']:.5f} ({error('H_min')}) |"
            f" {film['newton_iterations']} / {film['krylov_iterations']} |"
            f" {percent(predictions['hamrock_dowson_h_central'], film['h_central'])} |"
            f" {percent(predictions['hamrock_dowson_h_min'], film['h_min'])} |"
            f" {percent(predictions['nijenbanning_venner_moes_h_central'], film['h_central'])} |")


def print_range(folder, long_domain):
    print("| M | L | D | p_h [GPa] | grid | H_central (error) | H_min (error) | Newton / Krylov | H-D central | H-D smallest | N-V-M central |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for D in RATIOS:
        for M in LOADS:
            for L in OILS:
                print(range_row(M, L, D, folder, long_domain), flush=True)


def order_text(values):
    """Observed order and converged value from the last three of a sequence of halved steps."""
    if len(values) < 3:
        return "", ""
    coarse, middle, fine = values[-3:]
    ratio = (middle - coarse) / (fine - middle)
    if ratio <= 1:
        return "none", ""
    return f"{math.log2(ratio):.2f}", f"{fine + (fine - middle) / (ratio - 1):.4f}"


def print_grids(folder, long_domain):
    options = []
    if long_domain:
        for name, value in zip(("x_min", "x_max", "y_half"), LONG_DOMAIN):
            options += [f"-grid_{name}", value]
    print("| grid | h_central [um] | order | limit | h_min [um] | order | limit | Newton / Krylov |")
    print("|---|---|---|---|---|---|---|---|")
    central, smallest = [], []
    for grid in PITCH_GRIDS:
        film = steady(SOURCE / "input/barbieri2013.yaml", folder, grid, *options)
        if film is None:
            raise VerifyError(f"the pitch film on {grid[0]} x {grid[1]} nodes was not solved")
        central.append(1e6 * film["h_central"])
        smallest.append(1e6 * film["h_min"])
        print(f"| {grid[0]} x {grid[1]} | {central[-1]:.4f} | {' | '.join(order_text(central))} | {smallest[-1]:.4f} |"
              f" {' | '.join(order_text(smallest))} | {film['newton_iterations']} / {film['krylov_iterations']} |",
              flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("table", choices=("range", "grids"))
    parser.add_argument("--domain", choices=("paper", "long"), default="paper")
    arguments = parser.parse_args()
    try:
        with tempfile.TemporaryDirectory() as folder:
            table = print_range if arguments.table == "range" else print_grids
            table(pathlib.Path(folder), arguments.domain == "long")
    except VerifyError as error:
        sys.exit(f"verify_range: {error}")


if __name__ == "__main__":
    main()
