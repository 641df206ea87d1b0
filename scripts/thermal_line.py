#!/usr/bin/env python3
"""The film of a gear pair with and without its heat over the line of action: table and figure.

    scripts/thermal_line.py CASE FOLDER [--places 23] [--name thermal_film] [-option value ...]

`steady` at places from entry to exit, under the static force where one pair of teeth meshes and half of it where two
do, with thermal.model film and Eyring's friction. The case, or options of gearfilm behind all others, give what heat
needs (lubricant.temperature_viscosity). Prints a Markdown table; writes FOLDER/thermal_film.png and .pdf. Results of
the last place stay in FOLDER.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it. Exit status 1, with one line, where a run cannot
be made or a file not be written.
"""
import argparse
import pathlib

from plotting import BLUE, DARK, GREEN, VERMILLION, add_grid, add_legend, numpy, pyplot, write_figure
from runs import RunError, attempt, one_line_errors
from tables import heading, row

HEAT = ("-friction_law", "eyring", "-thermal_model", "film")
LINES = (("h_central_isothermal", "central, without heat", BLUE, "--"),
         ("h_min_isothermal", "smallest, without heat", VERMILLION, "--"),
         ("h_central", "central", BLUE, "-"), ("h_min", "smallest", VERMILLION, "-"))


def solved(command, case, folder, *options):
    run = attempt(command, case, folder, *options)
    if run.status != 0:
        raise RunError(run.message)
    return run.summary


def places_of(case, folder, count, options):
    """Positions [m] and their share of the static force."""
    info = solved("info", case, folder, *options)
    entry, end, pitch = (info[name] for name in ("xi_entry", "xi_exit", "base_pitch"))
    for place in numpy.linspace(entry, end, count + 2)[1:-1]:
        yield float(place), 1.0 if end - pitch < place < entry + pitch else 0.5


def line_of_action(case, folder, count, options):
    """A summary a place, as it is found."""
    for place, share in places_of(case, folder, count, options):
        yield solved("steady", case, folder, *HEAT, "-steady_position", place, "-steady_load_ratio", share, *options)


def cells(film):
    bar = f" +- {1e6 * film['h_central_error']:.3f}" if film["h_central_error"] else ""
    return (f"{1e3 * film['position']:.2f}", f"{film['force']:.0f}", f"{1e6 * film['h_central_isothermal']:.3f}",
            f"{1e6 * film['h_central']:.3f}{bar}", f"{film['thermal_factor']:.3f}", f"{1e6 * film['h_min']:.3f}",
            f"{film['thermal_factor_min']:.3f}", f"{film['friction_coefficient']:.4f}",
            f"{film['film_temperature_max']:.0f}", film["thermal_turns"])


def draw(films):
    figure, (upper, lower) = pyplot.subplots(2, 1, figsize=(7, 6.5), sharex=True, constrained_layout=True)
    places = [1e3 * film["position"] for film in films]
    for key, label, colour, style in LINES:
        upper.plot(places, [1e6 * film[key] for film in films], style, color=colour, linewidth=1.4, label=label)
    upper.set_ylabel(r"film [$\mu$m]")
    upper.set_ylim(bottom=0)
    add_legend(upper, *upper.get_legend_handles_labels())
    lower.plot(places, [abs(film["friction_coefficient"]) for film in films], color=DARK, linewidth=1.4)
    lower.set_ylabel("friction coefficient [-]")
    lower.set_ylim(bottom=0)
    lower.set_xlabel(r"position $\xi$ of the contact [mm]")
    heat = lower.twinx()
    heat.plot(places, [film["film_temperature_max"] for film in films], color=GREEN, linewidth=1.4)
    heat.set_ylabel("largest temperature of the film [K]", color=GREEN)
    add_grid(upper, lower)
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("case", type=pathlib.Path, help="case file of a gear pair")
    parser.add_argument("folder", type=pathlib.Path, help="folder of the figure and the last results")
    parser.add_argument("--places", type=int, default=23, help="on the line of action (%(default)s)")
    parser.add_argument("--name", default="thermal_film", help="file name of the figure, without ending")
    arguments, options = parser.parse_known_args()
    with one_line_errors("thermal_line", arguments.folder):
        arguments.folder.mkdir(parents=True, exist_ok=True)
        print(heading("xi [mm]", "force [N]", "h_c cold [um]", "h_c [um]", "factor", "h_min [um]", "factor", "mu",
                      "film [K]", "turns"))
        films = []
        for film in line_of_action(arguments.case, arguments.folder / "run", arguments.places, options):
            films.append(film)
            print(row(*cells(film)), flush=True)
    write_figure(arguments.folder, arguments.name, lambda: draw(films))


if __name__ == "__main__":
    main()
