"""Figure of a continuation: branches of periodic states, stable ones full, unstable ones dashed, bifurcations marked."""
import pathlib
from typing import NamedTuple

import numpy
from matplotlib import pyplot

from .canvas import BLUE, DARK, GREEN, GREY, VERMILLION, PlotError, add_grid, add_legend, open_results, read_table
from .diagrams import MASS, SPEED, TORQUE, Quantity, add_frequency_ratio, draw_marches, read_marches, varied_quantity


VARIED = {"speed": SPEED, "torque": TORQUE, "mass": MASS,
          "viscosity": Quantity("viscosity", "viscosity of the oil [Pa s]")}
RESPONSES = [Quantity("force_ratio_max", "largest force on a\ncontact [static force]"),
             Quantity("H0_after_leaving", "$H_0$ after leaving [-]"),
             Quantity("V0_after_leaving", "$V_0$ after leaving [-]")]
USED = {"branch", "order", "kind", "f_m", "f_n", "stable", *(quantity.column for quantity in RESPONSES)}
COLOURS = (BLUE, VERMILLION, GREEN)  # of orders that double: first, second, and all others
MARKS = {1: ("fold", "s"), 2: ("flip", "o"), 3: ("Neimark-Sacker", "D"), 4: ("grazing", "x")}


class Continuation(NamedTuple):
    """All points of a continuation, and what it varies."""
    table: numpy.ndarray
    varied: Quantity

    def branches(self):
        for number in numpy.unique(self.table["branch"]):
            yield self.table[self.table["branch"] == number]

    def colour(self, rows):
        doublings = int(numpy.log2(rows["order"][0] / self.table["order"].min()))
        return COLOURS[min(doublings, len(COLOURS) - 1)]


def read_continuation(path):
    with open_results(path, "continuation", "it has no table of points") as results:
        varied = varied_quantity(results, "continuation.parameter", VARIED)
        table = read_table(results, "continuation", USED | {varied.column})
    if not table.size:
        raise PlotError(f"{path} has no point yet")
    return Continuation(table, varied)


def stretches(rows):
    """Pieces of a branch that are all stable or all unstable; neighbours share the bifurcation between them."""
    regular = rows["kind"] == 0
    begin, stable = 0, rows["stable"][regular][0] if regular.any() else rows["stable"][0]
    for n in numpy.flatnonzero(regular):
        if rows["stable"][n] == stable:
            continue
        border = n - 1 if n > begin + 1 and not regular[n - 1] else n
        yield rows[begin:border + 1], stable
        begin, stable = border, rows["stable"][n]
    yield rows[begin:], stable


def draw_branch(axes, rows, varied, response, colour):
    order = f"order {rows['order'][0]}" if colour != COLOURS[-1] else "higher orders"
    for piece, stable in stretches(rows):
        axes.plot(piece[varied.column], piece[response.column], color=colour, linewidth=1.4 if stable else 1.0,
                  linestyle="-" if stable else (0, (4, 2)),
                  label=f"{order}, {'stable' if stable else 'unstable'}")


def draw_marks(axes, table, varied, response):
    for kind, (label, marker) in MARKS.items():
        points = table[table["kind"] == kind]
        if points.size:
            axes.plot(points[varied.column], points[response.column], linestyle="none", label=label, color=DARK,
                      marker=marker, markersize=6, markerfacecolor="none")


def draw(continuation, marches):
    figure, axes = pyplot.subplots(len(RESPONSES), 1, sharex=True, figsize=(8, 2.2 * len(RESPONSES) + 1.4),
                                   constrained_layout=True)
    for panel, response in zip(axes, RESPONSES):
        for rows in marches:
            draw_marches(panel, rows, continuation.varied, response.column, color=GREY, label="marches", zorder=0)
        for rows in continuation.branches():
            draw_branch(panel, rows, continuation.varied, response, continuation.colour(rows))
        draw_marks(panel, continuation.table, continuation.varied, response)
        panel.set_ylabel(response.label)
        add_grid(panel)
    over_speed = continuation.varied.column == "speed_rpm"
    if over_speed:
        table = continuation.table
        add_frequency_ratio(axes, table["speed_rpm"], table["f_m"] / table["f_n"])
    add_legend(axes[0], *axes[0].get_legend_handles_labels(), base=1.2 if over_speed else 1.0)
    axes[-1].set_xlabel(continuation.varied.label)
    figure.align_ylabels(axes)
    return figure


def add_options(parser):
    parser.add_argument("--marches", type=pathlib.Path, nargs="+", default=(), metavar="FOLDER",
                        help="folders of sweeps of marches over the same quantity, or of transients over the speed")


def draw_folder(folder, marches=()):
    """Draws `gearfilm continuation`, with the marches in other folders as dots."""
    continuation = read_continuation(folder / "results.h5")
    return draw(continuation, [read_marches(place, continuation.varied) for place in marches])
