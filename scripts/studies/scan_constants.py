#!/usr/bin/env python3
"""Do results hang on the tuned constants? Runs a few cases with half and twice of each, and compares.

    scripts/studies/scan_constants.py [--program GEARFILM] [--folder FOLDER] [CONSTANT ...]

Prints a Markdown table: for each constant that changes anything the largest change of a main figure, over its error bar
where it has one and else relative, how Newton's and Krylov's iterations change, and which runs failed.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]
GRID = ["-grid_nx", "97", "-grid_ny", "33", "-film_discretisation", "fitted"]
# Name: arguments, and the main figures that are compared.
CASES = {
    "film": (["steady", "input/barbieri2013.yaml", *GRID], ("h_central", "h_min", "p_max")),
    "thin film": (["steady", "input/first_gear.yaml"], ("h_central", "h_min", "p_max")),
    "warm film": (["steady", "input/barbieri2013.yaml", *GRID, "-friction_law", "newtonian", "-thermal_model", "film",
                   "-lubricant_temperature_viscosity", "0.04"], ("h_central", "h_min", "friction_coefficient", "film_temperature_max")),
    "periodic": (["periodic", "input/barbieri2013.yaml", *GRID], ("h_min", "p_max", "force_ratio_max", "floquet_modulus")),
    "controlled": (["transient", "input/barbieri2013.yaml", *GRID, "-mesh_periods", "0.5", "-time_tolerance", "1e-4"], ("h_min", "p_max", "force_ratio_max")),
    "modes": (["eigen", "input/barbieri2013.yaml", *GRID, "-eigen_orbit", "yes"], ("film_frequency", "film_damping_ratio")),
    "dry sweep": (["sweep", "input/barbieri2013.yaml", "-model", "dry", "-sweep_from", "6000", "-sweep_to", "9000",
                   "-sweep_points", "4"], ()),
    "sweep": (["sweep", "input/barbieri2013.yaml", *GRID, "-sweep_from", "7000", "-sweep_to", "8000", "-sweep_points", "2"], ()),
    "branch": (["continuation", "input/barbieri2013.yaml", "-model", "dry", "-continuation_from", "8000", "-continuation_to", "9000"], ()),
}

# Which cases a constant has to do with, by the beginning of its name.
CONCERNED = {
    ("newton_", "stationary_"): ("film", "thin film", "periodic"),
    ("coupled_", "energy_"): ("warm film",),
    ("step_", "march_", "guess_", "entering_"): ("periodic", "controlled"),
    ("search_", "orbit_", "decay_", "chain_"): ("periodic", "sweep"),
    ("modes_", "floquet_"): ("modes",),
    ("branch_",): ("branch",),
    ("dry_",): ("dry sweep", "branch"),
    ("recurrence_",): ("controlled",),
}


def concerned(constant):
    return next((cases for prefixes, cases in CONCERNED.items() if constant.startswith(prefixes)), tuple(CASES))


def summary_of(program, folder, name, constant=None, value=None):
    """The summary of a case, None where it failed."""
    target = folder / name.replace(" ", "_")
    shutil.rmtree(target, ignore_errors=True)
    options = [] if constant is None else [f"-{constant}", repr(value)]
    try:
        run = subprocess.run([program, *CASES[name][0], *options, "-output_dir", str(target)], cwd=SOURCE, capture_output=True,
                             text=True, check=False, timeout=300)
    except subprocess.TimeoutExpired:
        return None
    return json.loads((target / "summary.json").read_text(encoding="utf-8")) if run.returncode == 0 else None


def figures_of(summary, names):
    """Values and error bars: the main figures, or the largest force and smallest film of every point."""
    if names:
        return {name: (summary[name], summary.get(f"{name}_error")) for name in names if summary.get(name) is not None}
    points = summary.get("points", [])
    if isinstance(points, int):
        return {f"bifurcation {n}": (found["force_ratio_max"], None) for n, found in enumerate(summary["bifurcations"])} | {"points": (len(summary["branches"]), None)}
    return {f"{n} {name}": (point[name], None) for n, point in enumerate(points) for name in ("force_ratio_max", "h_min") if name in point}


def iterations_of(summary, kind):
    names = (f"{kind}_iterations_all_grids", f"{kind}_iterations")
    return next((summary[name] for name in names if name in summary), None)


def change(before, after):
    """Largest change over the error bar where there is one, and relative."""
    over_bar = relative = 0.0
    for name, (value, bar) in before.items():
        if name not in after:
            return float("inf"), float("inf")
        moved = abs(after[name][0] - value)
        relative = max(relative, moved / abs(value) if value else 0.0)
        if bar:
            over_bar = max(over_bar, moved / bar)
    return over_bar, relative


def constants_of(program):
    text = subprocess.run([program, "constants"], capture_output=True, text=True, check=True, timeout=60).stdout
    return {name: (float(value), kind == "count") for name, value, kind in
            re.findall(r"^\| `(\w+)` \| (\S+) \| (\w+) \|", text, re.MULTILINE)}


def scanned(program, folder, constant, value, whole, base):
    """Lines of the table for one constant."""
    lines = []
    for factor in (0.5, 2.0):
        tried = max(1, round(factor * value)) if whole else factor * value
        if tried == value:
            continue
        cells = []
        for name in concerned(constant):
            before = base[name]
            after = summary_of(program, folder, name, constant, int(tried) if whole else tried)
            if after is None:
                cells.append(f"{name}: fails")
                continue
            over_bar, relative = change(figures_of(before, CASES[name][1]), figures_of(after, CASES[name][1]))
            work = [f"{kind} {after_count / count:.2f}" for kind in ("newton", "krylov")
                    if (count := iterations_of(before, kind)) and (after_count := iterations_of(after, kind)) != count]
            if relative > 0.0 or work:
                cells.append(f"{name}: {relative:.1e}" + (f" ({over_bar:.2f} bars)" if over_bar else "") + "".join(f", {text}" for text in work))
        if cells:
            lines.append(f"| `{constant}` | {value:g} to {tried:g} | {'; '.join(cells)} |")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(SOURCE / "build/release/bin/gearfilm"))
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("output/scan_constants"))
    parser.add_argument("constants", nargs="*")
    given = parser.parse_args()
    known = constants_of(given.program)
    unknown = set(given.constants) - set(known)
    if unknown:
        sys.exit(f"scan_constants: there is no constant {', '.join(sorted(unknown))}; gearfilm constants lists them")
    folder = given.folder.resolve()
    base = {name: summary_of(given.program, folder, name) for name in CASES}
    if failed := [name for name, summary in base.items() if summary is None]:
        sys.exit(f"scan_constants: {', '.join(failed)} cannot be computed with the constants by default; run them by hand")
    print("| Constant | Tried | Largest relative change of a main figure, and iterations over those by default |\n|---|---|---|")
    for constant in given.constants or known:
        for line in scanned(given.program, folder, constant, *known[constant], base):
            print(line, flush=True)


if __name__ == "__main__":
    main()
