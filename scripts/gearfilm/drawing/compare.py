"""Figure of several runs side by side: sweeps over what they vary, periodic states over the line of action.

The runs are all of `gearfilm sweep`, or all of `gearfilm periodic`. Of a sweep the largest force, the transmission
error and the smallest film are drawn, all directions alike, without marks where contact is lost.
"""
import argparse
import pathlib
from typing import NamedTuple

import numpy
from matplotlib import pyplot

from .canvas import (BLUE, DARK, GREEN, VERMILLION, PlotError, add_grid, add_legend, add_output, open_results,
                     read_table, read_text, write_figure)
from .orbit import read_orbit
from .sweep import RESPONSES, read_sweep

LOOKS = [(BLUE, "-"), (VERMILLION, "--"), (GREEN, "-."), (DARK, ":")]
DRAWN = ["force_ratio_max", "transmission_error_peak_to_peak", "h_min"]  # of sweeps
FIGURES = ["contact", "step", "xi", "force", "p_max", "h_min"]


class Run(NamedTuple):
    label: str
    folder: pathlib.Path


def run_named(text):
    label, equals, folder = text.partition("=")
    if not (label and equals and folder):
        raise argparse.ArgumentTypeError(f"'{text}' is not LABEL=FOLDER")
    return Run(label, pathlib.Path(folder))


def command_of(run):
    with open_results(run.folder / "results.h5", "sweep or periodic", "it names no command") as results:
        return read_text(results.attrs["command"])


def draw_sweeps(runs):
    sweeps = [read_sweep(run.folder / "results.h5") for run in runs]
    if len({sweep.varied for sweep in sweeps}) > 1:
        raise PlotError("the sweeps do not vary the same quantity")
    responses = [response for response in RESPONSES if response.column in DRAWN]
    figure, axes = pyplot.subplots(len(responses), 1, sharex=True, figsize=(8, 7), constrained_layout=True)
    for run, sweep, (colour, line) in zip(runs, sweeps, LOOKS):
        rows = numpy.sort(sweep.table[sweep.table["found"] == 1], order=sweep.varied.column)
        for panel, response in zip(axes, responses):
            panel.plot(rows[sweep.varied.column], response.scale * rows[response.column], color=colour, linestyle=line,
                       marker="o", markersize=3, linewidth=1.2, label=run.label)
    for panel, response in zip(axes, responses):
        panel.set_ylabel(response.label)
        panel.set_ylim(bottom=0)
    axes[-1].set_xlabel(sweeps[0].varied.label)
    return figure, axes


def contact_of(run):
    """A contact of the periodic state from where it enters to where it leaves, in pieces of several mesh periods."""
    orbit = read_orbit(run.folder, 1)
    with open_results(run.folder / "results.h5", "periodic", "it has no history") as results:
        rows = read_table(results, "history/contacts", FIGURES)
    steps = orbit.steps["step"]
    rows = rows[(rows["step"] >= steps[0]) & (rows["step"] <= steps[-1])]
    return orbit, [rows[rows["contact"] == number] for number in numpy.unique(rows["contact"])]


def draw_orbits(runs):
    panels = [("force", "force [static force]", None), ("p_max", "largest pressure [GPa]", 1e-9),
              ("h_min", "smallest film [µm]", 1e6)]
    figure, axes = pyplot.subplots(len(panels), 1, sharex=True, figsize=(8, 7), constrained_layout=True)
    for run, (colour, line) in zip(runs, LOOKS):
        orbit, pieces = contact_of(run)
        for panel, (column, _, scale) in zip(axes, panels):
            for rows in pieces:
                factor = scale or 1 / orbit.static_force
                panel.plot(1e3 * rows["xi"], factor * rows[column], color=colour, linestyle=line, linewidth=1.3,
                           label=run.label)
    for panel, (_, label, _) in zip(axes, panels):
        panel.set_ylabel(label)
        panel.set_ylim(bottom=0)
    axes[-1].set_xlabel(r"position $\xi$ of the contact [mm]")
    return figure, axes


def draw(runs):
    commands = {command_of(run) for run in runs}
    if len(commands) > 1 or not commands <= {"sweep", "periodic"}:
        raise PlotError("the runs are not all of gearfilm sweep, or all of gearfilm periodic")
    if len(runs) > len(LOOKS):
        raise PlotError(f"{len(runs)} runs are too many to tell apart; give at most {len(LOOKS)}")
    figure, axes = (draw_sweeps if commands == {"sweep"} else draw_orbits)(runs)
    add_legend(axes[0], *axes[0].get_legend_handles_labels())
    add_grid(*axes)
    return figure


def command(parser, words):
    """Writes compare.png and .pdf into the folder of the first run, or as the words say."""
    parser.add_argument("runs", type=run_named, nargs="+", metavar="LABEL=FOLDER", help="name and folder of a run")
    add_output(parser, "compare")
    parser.add_argument("--into", type=pathlib.Path, metavar="FOLDER", help="of the figure; that of the first run")
    arguments = parser.parse_args(words)
    write_figure(arguments.into or arguments.runs[0].folder, arguments.name, lambda: draw(arguments.runs),
                 arguments.format)
