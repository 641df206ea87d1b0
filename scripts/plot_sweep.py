#!/usr/bin/env python3
"""Figure of a sweep: forces, transmission error, film and stability of the periodic states, on the way up and down.

    scripts/plot_sweep.py FOLDER [--name sweep]   reads FOLDER/results.h5, writes FOLDER/sweep.png and FOLDER/sweep.pdf

Exit status 1, with one line, where the results are missing or not those of `gearfilm sweep`.
"""
from typing import NamedTuple

from plotting import (BLUE, DARK, GREY, VERMILLION, Foreign, PlotError, add_grid, add_legend, command_line, numpy,
                      open_results, pyplot, read_table, read_text, write_figure)


class Quantity(NamedTuple):
    """A column of the table /sweep, and how it is drawn."""
    column: str
    label: str
    scale: float = 1.0


VARIED = {"speed": Quantity("speed_rpm", "speed of the pinion [rpm]"),
          "torque": Quantity("torque", "torque of the pinion [N m]"),
          "equivalent_mass": Quantity("I_n", "dimensionless inertia $I_n$ [-]")}
RESPONSES = [Quantity("force_ratio_max", "largest force on a\ncontact [static force]"),
             Quantity("transmission_error_peak_to_peak", "transmission error,\npeak to peak [µm]", 1e6),
             Quantity("h_min", "smallest film [µm]", 1e6),
             Quantity("floquet_modulus", "modulus of the Floquet\nmultipliers [-]")]
USED = {"up", "found", "f_m", "f_n", "contact_lost", "stable", "floquet_modulus_error",
        *(quantity.column for quantity in RESPONSES)}


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
        over = read_text(results["parameters"].attrs["sweep.over"])
        if over not in VARIED:
            raise Foreign(f"unknown sweep.over '{over}'")
        table = read_table(results, "sweep", USED | {VARIED[over].column})
    if not table["found"].any():
        raise PlotError(f"{path} has no periodic state, all points failed")
    return Sweep(table, VARIED[over])


def draw_points(axes, branch, varied, response):
    """One response, with a gap where no periodic state was found, and with the errors that the sweep gives."""
    errors = branch.rows["floquet_modulus_error"] if response.column == "floquet_modulus" else None
    axes.errorbar(branch.rows[varied.column], response.scale * branch.rows[response.column], yerr=errors,
                  color=branch.colour, marker=branch.marker, markerfacecolor=branch.filling, markersize=5,
                  linewidth=1.2, elinewidth=0.8, label=branch.label)


def draw_marks(axes, branch, varied, response):
    """Around or over the points that are special; at the bottom of the panel for those that failed."""
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


def add_frequency_ratio(axes, sweep):
    """An axis on top with f_m/f_n, for a sweep over the speed; a line in all panels at f_m = f_n."""
    speed = sweep.table[sweep.varied.column]
    ratio = numpy.mean(sweep.table["f_m"] / sweep.table["f_n"] / speed)  # a constant: f_n does not depend on the speed
    top = axes[0].secondary_xaxis("top", functions=(lambda x: ratio * x, lambda r: r / ratio))
    top.set_xlabel("$f_m/f_n$ [-]")
    if speed.min() < 1 / ratio < speed.max():
        for panel in axes:
            panel.axvline(1 / ratio, color=GREY, linewidth=0.8, linestyle="--", zorder=0)


def draw(sweep):
    responses = [response for response in RESPONSES if numpy.isfinite(sweep.table[response.column]).any()]
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
        add_frequency_ratio(axes, sweep)
    add_legend(axes[0], *axes[0].get_legend_handles_labels(), base=1.2 if over_speed else 1.0)
    axes[-1].set_xlabel(sweep.varied.label)
    figure.align_ylabels(axes)
    return figure


def main():
    arguments = command_line(__doc__, "sweep", "sweep").parse_args()
    write_figure(arguments, lambda: draw(read_sweep(arguments.folder / "results.h5")))


if __name__ == "__main__":
    main()
