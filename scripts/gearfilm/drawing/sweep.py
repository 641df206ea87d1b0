"""Figure of a sweep: its periodic states on the way up and down, its marches as dots, or its basins."""
from typing import NamedTuple

import numpy
from matplotlib import pyplot
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

from .canvas import (BLUE, DARK, GREEN, GREY, PALE, PURPLE, VERMILLION, PlotError, add_grid, add_legend, open_results,
                     read_table)
from .diagrams import (MARCHED, MASS, SPEED, TORQUE, Quantity, add_frequency_ratio, draw_marches, read_marches,
                       varied_quantity)


VARIED = {"speed": SPEED, "torque": TORQUE,
          "equivalent_mass": Quantity("I_n", "dimensionless inertia $I_n$ [-]")}
RESPONSES = [Quantity("force_ratio_max", "largest force on a\ncontact [static force]"),
             Quantity("transmission_error_peak_to_peak", "transmission error,\npeak to peak [µm]", 1e6),
             Quantity("h_min", "smallest film [µm]", 1e6),
             Quantity("floquet_modulus", "modulus of the Floquet\nmultipliers [-]")]
USED = {"up", "found", "f_m", "f_n", "contact_lost", "stable", "floquet_modulus_error",
        *(quantity.column for quantity in RESPONSES if quantity.column != "h_min")}  # dry pairs have no film


DIAGRAM = {"force_ratio_max": "largest force on a\ncontact [static force]", "H0_after_leaving": "$H_0$ [-]",
           "V0_after_leaving": "$V_0$ [-]"}
BASINS = (BLUE, VERMILLION, GREEN, PURPLE)
BASIN_COLUMNS = {"H0", "V0", "attractor", "settles_on", "H0_end", "V0_end", "force_ratio_max"}


class Branch(NamedTuple):
    """The points of one direction, and their looks."""
    rows: numpy.ndarray
    label: str
    colour: str
    marker: str
    filling: str
    bottom: float  # of the panel: height of the marks of points that failed, as part of the panel's


class Sweep(NamedTuple):
    """Both ways, and what is varied on them."""
    table: numpy.ndarray
    varied: Quantity

    def branches(self):
        table = numpy.sort(self.table, order=self.varied.column)
        both = [Branch(table[table["up"] == 1], "on the way up", BLUE, "^", BLUE, 0.04),
                Branch(table[table["up"] == 0], "on the way down", VERMILLION, "v", "none", 0.12)]
        return [branch for branch in both if branch.rows.size]


def read_sweep(path):
    with open_results(path, "sweep", "it has no table of points") as results:
        varied = varied_quantity(results, "sweep.over", VARIED)
        table = read_table(results, "sweep", USED | {varied.column})
    if not table["found"].any():
        raise PlotError(f"{path} has no periodic state, all points failed")
    return Sweep(table, varied)


def draw_points(axes, branch, varied, response):
    """One response, with a gap where no periodic state was found, and with the errors that the sweep gives."""
    errors = branch.rows["floquet_modulus_error"] if response.column == "floquet_modulus" else None
    axes.errorbar(branch.rows[varied.column], response.scale * branch.rows[response.column], yerr=errors,
                  color=branch.colour, marker=branch.marker, markerfacecolor=branch.filling, markersize=5,
                  linewidth=1.2, elinewidth=0.8, label=branch.label)


def draw_marks(axes, branch, varied, response):
    """Draws marks around or over special points, and at the bottom of the panel for those that failed."""
    def mark(points, heights, label, **style):
        if points.any():
            axes.plot(branch.rows[varied.column][points], heights[points], linestyle="none", label=label, **style)

    found = branch.rows["found"] == 1
    heights = response.scale * branch.rows[response.column]
    mark(found & (branch.rows["contact_lost"] == 1), heights, "contact is lost", color=DARK, marker="o", markersize=9,
         markerfacecolor="none", markeredgewidth=0.7)
    mark(found & (branch.rows["stable"] == 0), heights, "unstable", color=DARK, marker="x", markersize=9)
    mark(~found, numpy.full(found.size, branch.bottom), f"none found {branch.label}", color=branch.colour, marker="|",
         markersize=7, markeredgewidth=2, transform=axes.get_xaxis_transform())


def draw(sweep):
    responses = [response for response in RESPONSES if response.column in sweep.table.dtype.names
                 and numpy.isfinite(sweep.table[response.column]).any()]
    figure, axes = pyplot.subplots(len(responses), 1, sharex=True, figsize=(8, 2.2 * len(responses) + 1),
                                   constrained_layout=True)
    for panel, response in zip(axes, responses):
        for part in (draw_points, draw_marks):
            for branch in sweep.branches():
                part(panel, branch, sweep.varied, response)
        panel.set_ylabel(response.label)
        add_grid(panel)
        if response.column == "floquet_modulus":
            panel.axhline(1, color=GREY, linewidth=0.8, zorder=0)
    over_speed = sweep.varied.column == "speed_rpm"
    if over_speed:
        add_frequency_ratio(axes, sweep.table["speed_rpm"], sweep.table["f_m"] / sweep.table["f_n"])
    add_legend(axes[0], *axes[0].get_legend_handles_labels(), base=1.2 if over_speed else 1.0)
    axes[-1].set_xlabel(sweep.varied.label)
    figure.align_ylabels(axes)
    return figure


def draw_diagram(folder):
    """Draws a sweep of marches: the motion once a mesh period, at the end of every march."""
    with open_results(folder / "results.h5", "sweep", "it has no table of points") as results:
        varied = varied_quantity(results, "sweep.over", VARIED | {"equivalent_mass": MASS})
    rows = read_marches(folder, varied)
    figure, axes = pyplot.subplots(len(MARCHED), 1, sharex=True, figsize=(8, 8), constrained_layout=True)
    for panel, (column, label) in zip(axes, DIAGRAM.items()):
        for up, colour, name in ((1, BLUE, "on the way up"), (0, VERMILLION, "on the way down")):
            way = rows[rows["up"] == up]
            if way.size:
                draw_marches(panel, way, varied, column, color=colour, label=name)
        panel.set_ylabel(label)
        add_grid(panel)
    add_legend(axes[0], *axes[0].get_legend_handles_labels())
    axes[-1].set_xlabel(varied.label)
    figure.align_ylabels(axes)
    return figure


def draw_basins(table):
    """Draws where marches lead from every start of a grid."""
    H0, V0 = numpy.unique(table["H0"]), numpy.unique(table["V0"])
    leads_to = table["attractor"].reshape(H0.size, V0.size)
    figure, axes = pyplot.subplots(figsize=(7, 6), constrained_layout=True)
    kinds = numpy.unique(leads_to)
    colours = [BASINS[(number - 1) % len(BASINS)] if number else PALE for number in kinds]
    axes.pcolormesh(H0, V0, numpy.searchsorted(kinds, leads_to).T, cmap=ListedColormap(colours), vmin=-0.5,
                    vmax=kinds.size - 0.5, alpha=0.6, shading="nearest")
    handles = []
    for number, colour in zip(kinds, colours):
        ends = table[table["attractor"] == number]
        name = "does not repeat"
        if number:
            name = f"repeats every {ends['settles_on'][0]:.0f}, force {ends['force_ratio_max'][-1]:.2f}"
            axes.plot(ends["H0_end"][-1], ends["V0_end"][-1], marker="*", markersize=13, color=colour,
                      markeredgecolor=DARK)
        handles.append(Patch(color=colour, alpha=0.6, label=f"{name} ({ends.size / table.size:.0%})"))
    axes.set_xlabel("$H_0$ just after a contact has left [-]")
    axes.set_ylabel("$V_0$ [-]")
    add_legend(axes, handles, [handle.get_label() for handle in handles])
    return figure


def draw_folder(folder):
    """Draws `gearfilm sweep` of any kind."""
    path = folder / "results.h5"
    with open_results(path, "sweep", "it has no table of points") as results:
        basins = read_table(results, "basins", BASIN_COLUMNS) if "basins" in results else None
        marched = "diagram" in results
    if basins is not None:
        return draw_basins(basins)
    return draw_diagram(folder) if marched else draw(read_sweep(path))
