#!/usr/bin/env python3
"""Errors of the central and the smallest film over the lines of the grid, by both discretisations of Reynolds' equation.

    scripts/studies/film_errors.py FOLDER

Three stationary films: that of input/barbieri2013.yaml at the pitch point, on the paper's domain, and those of two
slender contacts on domains of the program's choice. Lines are refined alone; rows are as many as keep both films from
tearing at their sides. Errors are those from the fitted film on the finest grid. Draws FOLDER/film_errors.png and .pdf,
prints the numbers as Markdown tables and writes them to FOLDER/film_errors.md. Runs stay in FOLDER/runs; one that was
made is not repeated, so take a new folder when the program has changed. A cell is empty where a film was not solved,
and says none where the pressure has no spike. About a minute.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it. Exit status 1, with one line, where a run cannot
be made or a file not be written.
"""
import argparse
import json
import pathlib
import sys
from typing import NamedTuple

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
# pylint: disable=wrong-import-position
from contacts import case_text  # noqa: E402
from plotting import BLUE, VERMILLION, add_grid, pyplot, save  # noqa: E402
from runs import SOURCE, gearfilm, one_line_errors  # noqa: E402
from tables import heading, percent, row  # noqa: E402

SCHEMES = (("central", VERMILLION, "s"), ("fitted", BLUE, "o"))
FILMS = (("h_central", "central", "-", "full"), ("h_min", "smallest", "--", "none"))
CONTACT_LINES = (65, 97, 129, 193, 257, 385, 513, 769)
CLOSE = 1e-5          # errors below are no errors of the lines


class Film(NamedTuple):
    """A film, and the lines of its grids."""
    title: str
    name: str
    case: str           # text of a case file
    options: tuple
    lines: tuple


def contact(M, L, D, rows):
    return Film(f"contact, M = {M:g}, L = {L:g}, D = {D:g}, {rows} rows", f"contact_{M:g}_{L:g}_{D:g}",
                case_text(M, L, D, own_domain=True), ("-grid_ny", rows), CONTACT_LINES)


def studied():
    pitch = (SOURCE / "input/barbieri2013.yaml").read_text(encoding="utf-8")
    return (Film("case study at the pitch point, M = 2401, L = 27.4, D = 0.06, 65 rows", "pitch", pitch,
                 ("-grid_domain", "paper", "-grid_ny", 65), (33, 65, 129, 257, 513)),
            contact(1e5, 6, 0.001, 129), contact(15000, 8, 0.003, 65))


def solve(film, scheme, lines, folder):
    """Summary, None where not solved."""
    name = f"{film.name}_{scheme}_{lines}"
    kept = folder / f"{name}.json"
    if kept.exists():
        return json.loads(kept.read_text(encoding="utf-8"))
    case = folder / f"{film.name}.yaml"
    case.write_text(film.case, encoding="utf-8")
    summary = gearfilm("steady", case, folder / name, *film.options, "-film_discretisation", scheme, "-grid_nx", lines)
    kept.write_text(json.dumps(summary), encoding="utf-8")
    return summary


def solve_all(film, folder):
    """Summaries by scheme and lines."""
    return {(scheme, lines): solve(film, scheme, lines, folder) for scheme, _, _ in SCHEMES for lines in film.lines}


def error(solved, key, name, finest):
    """Relative, from the fitted film on the finest grid; None where there is no film, or it is that one."""
    summary, reference = solved[key], solved[("fitted", finest)]
    return None if summary is None or reference is None or key == ("fitted", finest) else \
        summary[name] / reference[name] - 1


def draw(axes, film, solved):
    for scheme, colour, marker in SCHEMES:
        for name, label, line, fill in FILMS:
            errors = [(lines, error(solved, (scheme, lines), name, film.lines[-1])) for lines in film.lines]
            points = [(lines, abs(e)) for lines, e in errors if e is not None and abs(e) > CLOSE]
            axes.plot(*zip(*points), color=colour, marker=marker, markersize=5, linestyle=line, linewidth=1.2,
                      fillstyle=fill, label=f"{scheme} discretisation, {label} film")
    axes.set(xscale="log", yscale="log", xlabel="lines along x", ylim=(CLOSE, 1))
    axes.set_title(film.title.replace(", M", "\nM"), fontsize=9)
    ticks = film.lines if len(film.lines) < 6 else film.lines[::2] + film.lines[-1:]
    axes.set_xticks(ticks, [str(lines) for lines in ticks])
    axes.minorticks_off()
    add_grid(axes)


def table(film, solved):
    columns = [f"{what}, {scheme}" for scheme, _, _ in SCHEMES
               for what in ("central film", "smallest film", "spike [GPa]")]
    text = [f"{film.title}\n", heading("lines", *columns)]
    for lines in film.lines:
        cells = [str(lines)]
        for scheme, _, _ in SCHEMES:
            summary = solved[(scheme, lines)]
            errors = [error(solved, (scheme, lines), name, film.lines[-1]) for name, *_ in FILMS]
            cells += ["" if e is None else percent(e, 2) for e in errors]
            spike = summary and summary["p_spike"]
            cells.append(f"{1e-9 * spike:.2f}" if spike else "none")
        text.append(row(*cells))
    reference = solved[("fitted", film.lines[-1])]
    text.append(f"\nErrors are those from h_central = {1e6 * reference['h_central']:.5g} µm, "
                f"h_min = {1e6 * reference['h_min']:.5g} µm.\n")
    return "\n".join(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="folder of the runs, the figure and the tables")
    folder = parser.parse_args().folder
    with one_line_errors("film_errors", folder):
        (folder / "runs").mkdir(parents=True, exist_ok=True)
        films = studied()
        solved = [solve_all(film, folder / "runs") for film in films]
        figure, axes = pyplot.subplots(1, len(films), figsize=(11.5, 4.2), sharey=True, constrained_layout=True)
        for panel, film, summaries in zip(axes, films, solved):
            draw(panel, film, summaries)
        axes[0].set_ylabel("|relative error of the film thickness|")
        axes[1].legend(fontsize=7, loc="lower left")
        save(figure, [folder / f"film_errors.{ending}" for ending in ("png", "pdf")])
        text = "\n".join(table(film, summaries) for film, summaries in zip(films, solved))
        print(text)
        (folder / "film_errors.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
