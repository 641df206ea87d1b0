#!/usr/bin/env python3
"""Figure of a march in time: motion, forces and films of the gear pair over the length travelled.

    scripts/plot_march.py FOLDER [--name march]   reads FOLDER/results.h5, writes FOLDER/march.png and FOLDER/march.pdf

Exit status 1, with one line, where the results are missing or not those of `gearfilm transient` or `periodic`.
"""
import argparse
import pathlib
import sys
from typing import NamedTuple

try:
    import h5py
    import matplotlib
    import numpy
    matplotlib.use("Agg")
    from matplotlib import pyplot
except ImportError as missing:
    sys.exit(f"plot_march: {missing}; needs h5py, matplotlib, numpy (as /usr/bin/python3 has after scripts/setup.sh)")

# Distinguishable with every kind of colour vision: colours of Okabe and Ito. Teeth take turns.
TOOTH_COLOURS = ["#0072B2", "#D55E00", "#009E73"]
DARK = "#333333"
WIDE_RANGE = 5  # of film thickness: beyond it, when contact is lost, the axis is logarithmic


class PlotError(Exception):
    """Something that keeps the figure from being made; the text is for the user."""


class March(NamedTuple):
    """The two tables of a history."""
    steps: numpy.ndarray
    contacts: numpy.ndarray


def read_march(path):
    if not path.exists():
        raise PlotError(f"{path} does not exist; run gearfilm transient first")
    try:
        with h5py.File(path) as results:
            march = March(results["history/steps"][:], results["history/contacts"][:])
    except OSError:
        raise PlotError(f"{path} is not an HDF5 file that can be read") from None
    except KeyError:
        raise PlotError(f"{path} is not a result of gearfilm transient: it has no history") from None
    if not {"distance", "H0", "force_total"} <= set(march.steps.dtype.names or ()):
        raise PlotError(f"{path} is not a result of gearfilm transient: columns of the history are missing")
    return march


def draw_teeth(axes, march, column, scale, **style):
    """One line a tooth pair over the length travelled."""
    distance = dict(zip(march.steps["step"], 1e3 * march.steps["distance"]))
    for tooth in numpy.unique(march.contacts["contact"]):
        rows = march.contacts[march.contacts["contact"] == tooth]
        axes.plot([distance[step] for step in rows["step"]], scale * rows[column],
                  color=TOOTH_COLOURS[tooth % len(TOOTH_COLOURS)], linewidth=1.2, **style)


def draw(march, paths):
    lubricated = "h_min" in march.contacts.dtype.names
    figure, rows = pyplot.subplots(4 if lubricated else 3, 1, sharex=True, figsize=(8, 8 if lubricated else 6.5),
                                   constrained_layout=True)
    travelled = 1e3 * march.steps["distance"]
    rows[0].plot(travelled, march.steps["H0"], color=DARK, linewidth=1.2)
    rows[0].set_ylabel("$H_0$ [-]")
    rows[1].plot(travelled, 1e-3 * march.steps["force_total"], color=DARK, linewidth=1.2)
    draw_teeth(rows[1], march, "force", 1e-3, linestyle="--")
    rows[1].set_ylabel("force [kN]\n(dashed: each contact)")
    draw_teeth(rows[2], march, "p_max", 1e-9)
    rows[2].set_ylabel("largest pressure [GPa]")
    if lubricated:
        draw_teeth(rows[3], march, "h_central", 1e6)
        draw_teeth(rows[3], march, "h_min", 1e6, linestyle="--")
        if march.contacts["h_central"].max() > WIDE_RANGE * march.contacts["h_min"].min():
            rows[3].set_yscale("log")
        rows[3].set_ylabel("film [µm]\n(dashed: smallest)")
    rows[-1].set_xlabel("length travelled along the line of action [mm]")
    for axes in rows:
        axes.grid(color="#DDDDDD", linewidth=0.6)
        axes.margins(x=0)
    for path in paths:
        figure.savefig(path, dpi=150)
        print(f"figure: {path}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="folder with results.h5 of gearfilm transient")
    parser.add_argument("--name", default="march", help="file name of the figure, without ending")
    arguments = parser.parse_args()
    try:
        march = read_march(arguments.folder / "results.h5")
    except PlotError as error:
        sys.exit(f"plot_march: {error}")
    draw(march, [arguments.folder / f"{arguments.name}.{ending}" for ending in ("png", "pdf")])


if __name__ == "__main__":
    main()
