"""Figure of a march's recurrence: its motion once a mesh period, just after a contact has left.

Left H_0 over V_0, later points darker; right both and the largest force over the mesh periods, or over the speed of a
run-up.
"""
import numpy
from matplotlib import pyplot

from .canvas import BLUE, COLOUR_MAP, DARK, VERMILLION, PlotError, add_grid, open_results, read_table

COLUMNS = ["T", "H0", "V0", "force_max", "pinion_speed"]


def read_points(path):
    with open_results(path, "transient", "it has no table of motions once a mesh period") as results:
        table = read_table(results, "history/poincare", COLUMNS)
    if table.size < 2:
        raise PlotError(f"{path} has {table.size} point(s); march for more mesh periods")
    return table


def draw(table):
    ramped = numpy.ptp(table["pinion_speed"]) > 0
    over = table["pinion_speed"] if ramped else numpy.arange(1, table.size + 1)
    figure, panels = pyplot.subplot_mosaic([["plane", "H0"], ["plane", "V0"], ["plane", "force_max"]],
                                           figsize=(10, 5.5), constrained_layout=True)
    plane = panels["plane"]
    plane.plot(table["H0"], table["V0"], color=DARK, linewidth=0.4, alpha=0.4)
    shown = plane.scatter(table["H0"], table["V0"], c=over, cmap=COLOUR_MAP + "_r", s=14)
    label = "speed of the pinion [rpm]" if ramped else "mesh period"
    figure.colorbar(shown, ax=plane, location="top", label=label, shrink=0.8)
    plane.set_xlabel("$H_0$ [-]")
    plane.set_ylabel("$V_0$ [-]")
    for name, text, scale, colour in (("H0", "$H_0$ [-]", 1, BLUE), ("V0", "$V_0$ [-]", 1, BLUE),
                                      ("force_max", "largest force on\na contact [kN]", 1e-3, VERMILLION)):
        panels[name].plot(over, scale * table[name], color=colour, marker=".", markersize=3, linewidth=0.6)
        panels[name].set_ylabel(text)
    panels["force_max"].set_xlabel(label)
    add_grid(*panels.values())
    return figure


def draw_folder(folder):
    """Draws `gearfilm transient`."""
    return draw(read_points(folder / "results.h5"))
