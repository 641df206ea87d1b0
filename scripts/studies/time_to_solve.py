#!/usr/bin/env python3
"""How many nodes, steps and seconds periodic states take on the program's defaults, as Markdown tables.

    scripts/studies/time_to_solve.py FOLDER [--pairs 40] [--seeds 1 2] [--twice 12] [--time-limit 600]

Single pairs: the case study on the paper's domain, with the grid of the program's choice and with 65 x 33 nodes, with
multipliers; input/first_gear.yaml without; a slow pair (31/47 teeth at 50 rpm), without inertia by the program's choice.
Catalogues: the pairs of scripts/catalogue.py of each seed, `periodic` and `steady`: medians and 95th percentiles of the
seconds of the processor, those that were not solved with the message, medians of Newton and Krylov iterations of a
stationary film on its finest grid. The first --twice of the pairs that were solved are computed again on twice as many
nodes along and across with half the step: largest total force, transmission error, central film at the pitch point and
smallest film against the error bars. Tables are printed, and written to FOLDER/time_to_solve.md; runs stay in FOLDER.
Half an hour for both seeds.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it. Exit status 1, with one line, where a run cannot
be made or a file not be written.
"""
import argparse
import os
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
# pylint: disable=wrong-import-position
from catalogue import write_pair  # noqa: E402
from runs import SOURCE, attempt, one_line_errors  # noqa: E402
from tables import heading, percent, row  # noqa: E402

SLOW_PAIR = """\
case: {name: slow}
pinion: {teeth: 31, outer_radius: 41.25e-3, crowning: 8e-6, youngs_modulus: 206e9, poisson_ratio: 0.3, speed_rpm: 50,
         torque: 150, inertia: 8e-4, bore_radius: 15e-3}
wheel: {teeth: 47, outer_radius: 61.25e-3, crowning: 8e-6, youngs_modulus: 206e9, poisson_ratio: 0.3, inertia: 4e-3,
        bore_radius: 20e-3}
gear: {module: 2.5e-3, pressure_angle_deg: 20, centre_distance: 97.5e-3, face_width: 20e-3}
lubricant: {viscosity: 0.02, pressure_viscosity: 2.0e-8}
"""
FITTED = ("-film_discretisation", "fitted")
CASE_STUDY, FIRST_GEAR = ((SOURCE / "input" / name).read_text(encoding="utf-8")
                          for name in ("barbieri2013.yaml", "first_gear.yaml"))
WITHOUT_GRID = "".join(line for line in CASE_STUDY.splitlines(True) if not line.startswith(("  nx:", "  ny:")))
SINGLE = (("case study", CASE_STUDY, (*FITTED, "-grid_nx", 65, "-grid_ny", 33)),
          ("case study, grid for 2 %", WITHOUT_GRID, FITTED),
          ("`first_gear`, no multipliers", FIRST_GEAR, ("-periodic_multipliers", "no")),
          ("slow pair", SLOW_PAIR, ()))
COLUMNS = ("pair", "nodes", "steps", "mesh periods", "Newton", "Krylov", "s", "h_c at the pitch point [um]", "its error")
COMPARED = ("total_force_ratio_max", "transmission_error_peak_to_peak", "pitch_h_central", "h_min")


def timed(command, case, folder, *options, time_limit=None):
    """A run, and the seconds of the processor that it took."""
    before = os.times()
    run = attempt(command, case, folder, *options, time_limit=time_limit)
    after = os.times()
    return run, after.children_user + after.children_system - before.children_user - before.children_system


def cells(summary):
    film, error = summary.get("pitch_h_central"), summary.get("pitch_h_central_error")
    return (f"{summary['nx']} x {summary['ny']}", summary["steps"], summary["periods_used"],
            summary["newton_iterations"], summary["krylov_iterations"]), \
        (f"{1e6 * film:.4g}" if film else "", percent(error / film, 1) if film and error else "")


def single_pairs(folder, say):
    say(heading(*COLUMNS))
    for number, (name, text, options) in enumerate(SINGLE):
        case = folder / f"single{number}.yaml"
        case.write_text(text, encoding="utf-8")
        run, seconds = timed("periodic", case, folder / f"single{number}", *options)
        if run.status != 0:
            say(row(name, *[""] * (len(COLUMNS) - 2), run.message))
            continue
        counts, film = cells(run.summary)
        say(row(name, *counts, f"{seconds:.1f}", *film))


def percentile(values, part):
    return sorted(values)[min(len(values) - 1, int(part * len(values)))]


def median(values):
    return f"{statistics.median(values):g}" if values else "no"


def catalogue(folder, seed, pairs, time_limit, say):
    """Case files of the pairs that were solved, with their summaries."""
    seconds, newton, krylov, solved, failed = [], [], [], [], []
    for number in range(pairs):
        case, _ = write_pair(folder, seed, number)
        film = attempt("steady", case, folder / "steady" / case.stem)
        if film.status == 0:
            newton.append(film.summary["newton_iterations"])
            krylov.append(film.summary["krylov_iterations"])
        run, took = timed("periodic", case, folder / "periodic" / case.stem, time_limit=time_limit)
        seconds.append(took)
        if run.status == 0:
            solved.append((case, run.summary))
        else:
            failed.append((case.stem, run.message))
    say(f"\nSeed {seed}, {pairs} pairs: median {statistics.median(seconds):.1f} s, 95th percentile "
        f"{percentile(seconds, 0.95):.1f} s; {len(solved)} solved; a stationary film: median "
        f"{median(newton)} Newton and {median(krylov)} Krylov iterations on the finest grid.\n")
    for name, message in failed:
        say(f"- {name}: {message}")
    return solved


def against_twice_as_fine(folder, solved, say):
    """Differences from runs with half the steps in space and time, and how many lie within the bars."""
    say("\n" + heading("pair", *COMPARED, "within 1.1 bars"))
    for case, summary in solved:
        grid = summary["final_grid"]
        finer = attempt("periodic", case, folder / "finer" / case.stem, "-motion", summary["motion"],
                        "-grid_nx", 2 * summary["nx"] - 1, "-grid_ny", 2 * summary["ny"] - 1, "-grid_x_min",
                        grid["x_min"], "-grid_x_max", grid["x_max"], "-grid_y_half", grid["y_half"], "-time_dt",
                        0.5 * summary["dT"], *(() if summary["motion"] == "quasi_static" else
                                               ("-periodic_multipliers", "no")))
        if finer.status != 0:
            say(row(case.stem, *[""] * len(COMPARED), finer.message))
            continue
        known = [name for name in COMPARED if summary.get(name) is not None and finer.summary.get(name) is not None]
        changes = {name: finer.summary[name] - summary[name] for name in known}
        bars = {name: summary.get(f"{name}_error") or 0.0 for name in known}
        inside = sum(abs(changes[name]) <= 1.1 * bars[name] for name in known)
        say(row(case.stem, *[f"{percent(changes[name] / summary[name], 2)} ({percent(bars[name] / summary[name], 2)})"
                             if name in known else "" for name in COMPARED], f"{inside} of {len(known)}"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="folder of cases, runs and table")
    parser.add_argument("--pairs", type=int, default=40, help="of each seed (%(default)s)")
    parser.add_argument("--seeds", type=int, nargs="*", default=[1, 2], help="of the catalogues (1 2)")
    parser.add_argument("--twice", type=int, default=12, help="pairs against twice as fine (%(default)s)")
    parser.add_argument("--time-limit", type=float, default=600.0, help="of a catalogue pair [s] (%(default)s)")
    arguments = parser.parse_args()
    with one_line_errors("time_to_solve", arguments.folder):
        arguments.folder.mkdir(parents=True, exist_ok=True)
        with (arguments.folder / "time_to_solve.md").open("w", encoding="utf-8") as table:
            def say(line):
                print(line, flush=True)
                print(line, file=table, flush=True)

            single_pairs(arguments.folder, say)
            solved = []
            for seed in arguments.seeds:
                solved += catalogue(arguments.folder, seed, arguments.pairs, arguments.time_limit, say)
            against_twice_as_fine(arguments.folder, solved[:arguments.twice], say)


if __name__ == "__main__":
    main()
