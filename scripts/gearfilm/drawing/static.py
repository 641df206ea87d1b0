"""Figure of the dry pair turned slowly: transmission error, load shares and mesh stiffness under several loads."""
from typing import NamedTuple

import numpy
from matplotlib import pyplot

from .canvas import BLUE, COLOUR_MAP, PlotError, add_grid, add_legend, open_results, read_table

FORCES = ["force_0", "force_1", "force_2"]  # of the contacts, the leading one first
GAPS = ["gap_0", "gap_1", "gap_2"]          # not a number where there is no contact
USED = {"load_ratio", "mesh_period", "xi", "te", "stiffness", *FORCES, *GAPS}
LIGHTEST = 0.9  # of the colour map, that is still seen on white


class Load(NamedTuple):
    """The positions in one mesh period under one load; two at an entering, before and after."""
    ratio: float
    rows: numpy.ndarray


def read_static(path):
    """All loads, the smallest first."""
    with open_results(path, "static", "it has no table of positions") as results:
        table = read_table(results, "static", USED)
    if not table.size:
        raise PlotError(f"{path} has no rows in its table of positions")
    return [Load(ratio, table[table["load_ratio"] == ratio]) for ratio in numpy.unique(table["load_ratio"])]


def shares_of_contact(rows):
    """Positions [m] of one contact from its entry to its exit, and its shares of the load."""
    base_pitch = rows["xi"][-1] - rows["xi"][0]  # what the leading contact travels in a mesh period
    load = sum(rows[force] for force in FORCES)
    places, shares = [], []
    # A contact is the last one first; a mesh period later it is the one before.
    for k in reversed(range(len(FORCES))):
        there = numpy.isfinite(rows[GAPS[k]])
        places.append(rows["xi"][there] - k * base_pitch)
        shares.append((rows[FORCES[k]] / load)[there])
    return numpy.concatenate(places), numpy.concatenate(shares)


def draw_period(axes, loads, column, scale):
    """One line a load over the mesh period; a jump at an entering is a vertical part of it."""
    colours = pyplot.get_cmap(COLOUR_MAP)(numpy.linspace(LIGHTEST, 0, len(loads)))
    for load, colour in zip(loads, colours):
        axes.plot(load.rows["mesh_period"], scale * load.rows[column], color=colour, linewidth=1.4,
                  label=f"{load.ratio:g}")
    add_legend(axes, *axes.get_legend_handles_labels())
    axes.get_legend().set_title("load ratio", {"size": 8})
    axes.set_xlabel("part of the mesh period [-]")
    axes.margins(x=0)


def draw_swing(axes, loads):
    """Draws the swing of the transmission error over the load."""
    axes.plot([load.ratio for load in loads], [1e6 * numpy.ptp(load.rows["te"]) for load in loads], color=BLUE,
              marker="o", markersize=5, linewidth=1.2)
    axes.set_xlabel("load ratio [-]")
    axes.set_ylabel("transmission error,\npeak to peak [µm]")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)


def draw_shares(axes, loads):
    nominal = min(loads, key=lambda load: abs(load.ratio - 1))
    places, shares = shares_of_contact(nominal.rows)
    axes.plot(1e3 * places, shares, color=BLUE, linewidth=1.4, label=f"load ratio {nominal.ratio:g}")
    add_legend(axes, *axes.get_legend_handles_labels())
    axes.set_xlabel(r"position $\xi$ of the contact [mm]")
    axes.set_ylabel("share of the load [-]")
    axes.set_ylim(0, 1.05)


def draw(loads):
    figure, axes = pyplot.subplots(2, 2, figsize=(8, 7), constrained_layout=True)
    (error, swing), (shares, stiffness) = axes
    draw_period(error, loads, "te", 1e6)
    error.set_ylabel("transmission error [µm]")
    draw_swing(swing, loads)
    draw_shares(shares, loads)
    draw_period(stiffness, loads, "stiffness", 1e-6)
    stiffness.set_ylabel("mesh stiffness [N/µm]")
    add_grid(*axes.flat)
    return figure


def draw_folder(folder):
    """Draws `gearfilm static`."""
    return draw(read_static(folder / "results.h5"))
