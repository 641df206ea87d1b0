#!/usr/bin/env python3
"""Convergence of films and of the periodic state with the grid, the time step and the domain: tables, figures, limits.

    scripts/convergence.py FOLDER [STUDY ...] [--reduced] [--finest]

Studies, all without a name: steady (stationary films), grid (periodic state, grid and time step), time (time step
alone), domain (what the paper's short domain costs). --reduced: the coarsest runs of steady, time and domain, within a
minute. --finest: the periodic state on one grid more. Each study is printed as Markdown tables, written to
FOLDER/convergence_<study>.md, and drawn as .png and .pdf; all numbers are in FOLDER/convergence.json. The runs stay in
FOLDER/runs: one that was solved with the same case and options is not repeated, so take a new folder when the program
has changed.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it. A run that is not solved is a remark in the
tables. Exit status 1, with one line, where a run cannot be made, or the folder cannot be written to or is another's.
"""
import argparse
import json
import pathlib
import sys

from plotting import pyplot, save
from refinement.figure import draw
from refinement.studies import REDUCED_STUDIES, STUDIES, Size
from refinement.tables import Solved, markdown, numbers
from runs import RunError, gearfilm


class ConvergenceError(Exception):
    """Something that keeps a study from being made; the text is for the user."""


def read_json(path):
    """What an earlier call has written; None where it is missing or broken."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (FileNotFoundError, ValueError):
        return None


def write_json(path, content):
    path.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def open_folder(folder):
    """Makes the folder; returns the numbers of earlier studies in it."""
    folder.mkdir(parents=True, exist_ok=True)
    if any(folder.iterdir()) and not (folder / "runs").is_dir():
        raise ConvergenceError(f"{folder} is not empty and not a folder of this script")
    path = folder / "convergence.json"
    earlier = read_json(path)
    if path.exists() and not isinstance(earlier, dict):
        raise ConvergenceError(f"{path} is not one of this script; delete it or take another folder")
    return earlier or {}


def solve(series, run, folder):
    """Summary of a run, None where not solved; that of an earlier call where it was the same run."""
    wanted = {"command": series.command, "options": [str(word) for word in run.options], "case": series.case}
    place = folder / "runs" / run.name
    summary = read_json(place / "summary.json")
    if read_json(place / "options.json") == wanted and summary and summary.get("completed", True):
        return summary
    place.mkdir(parents=True, exist_ok=True)
    (place / "options.json").unlink(missing_ok=True)
    case = place / "case.yaml"
    case.write_text(series.case, encoding="utf-8")
    print(f"convergence: gearfilm {series.command}, {run.name}", flush=True)
    summary = gearfilm(series.command, case, place, *run.options)
    if summary is not None:
        write_json(place / "options.json", wanted)
    return summary


def make(name, study, folder, earlier):
    """Solves one study, prints and writes its tables, its figure, and its numbers beside the earlier ones."""
    solved = [Solved(series, [solve(series, run, folder) for run in series.runs]) for series in study.series]
    text = markdown(study, solved)
    print(f"\n{text}", flush=True)
    (folder / f"convergence_{name}.md").write_text(text, encoding="utf-8")
    earlier[name] = numbers(study, solved)
    write_json(folder / "convergence.json", earlier)
    figure = draw(study, solved)
    save(figure, [folder / f"convergence_{name}.{ending}" for ending in ("png", "pdf")])
    pyplot.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="folder of the runs, tables and figures")
    parser.add_argument("studies", nargs="*", metavar="STUDY", help=f"of {', '.join(STUDIES)}; all without a name")
    parser.add_argument("--reduced", action="store_true", help=f"the coarsest runs of {', '.join(REDUCED_STUDIES)}")
    parser.add_argument("--finest", action="store_true", help="one grid more for the study grid")
    arguments = parser.parse_args()
    known = REDUCED_STUDIES if arguments.reduced else tuple(STUDIES)
    for name in arguments.studies:
        if name not in known:
            parser.error(f"no study '{name}'; choose of {', '.join(known)}")
    size = Size(arguments.reduced, arguments.finest)
    try:
        earlier = open_folder(arguments.folder)
        for name in arguments.studies or known:
            make(name, STUDIES[name](size), arguments.folder, earlier)
    except (ConvergenceError, RunError) as error:
        sys.exit(f"convergence: {error}")
    except OSError as error:
        sys.exit(f"convergence: cannot write to {arguments.folder}: {error}")


if __name__ == "__main__":
    main()
