"""What figures over a speed, a torque or a mass share: what is varied, the axis of frequency ratios, marched motions."""
from typing import NamedTuple

import numpy

from .canvas import GREY, Foreign, PlotError, open_results, read_summary, read_table, read_text


class Quantity(NamedTuple):
    """A column of a table, and how it is drawn."""
    column: str
    label: str
    scale: float = 1.0


SPEED = Quantity("speed_rpm", "speed of the pinion [rpm]")
TORQUE = Quantity("torque", "torque of the pinion [N m]")
MASS = Quantity("m_ge", "equivalent mass [kg]")
# Columns of the table /diagram, by those of /continuation that mean the same.
MARCHED = {"force_ratio_max": "force_ratio_max", "H0_after_leaving": "H0", "V0_after_leaving": "V0"}


def varied_quantity(results, key, known):
    """The known quantity that is varied, as the parameters of an open results file say."""
    name = read_text(results["parameters"].attrs[key])
    if name not in known:
        raise Foreign(f"unknown {key} '{name}'")
    return known[name]


def add_frequency_ratio(axes, speed, frequency_ratio):
    """An axis on top with f_m/f_n, in figures over the speed; a line in all panels at f_m = f_n."""
    ratio = numpy.mean(frequency_ratio / speed)  # a constant: f_n does not depend on the speed
    top = axes[0].secondary_xaxis("top", functions=(lambda x: ratio * x, lambda r: r / ratio))
    top.set_xlabel("$f_m/f_n$ [-]")
    if speed.min() < 1 / ratio < speed.max():
        for panel in axes:
            panel.axvline(1 / ratio, color=GREY, linewidth=0.8, linestyle="--", zorder=0)


def read_marches(folder, varied):
    """Marched motions, one row a mesh period: of a sweep of marches over the same quantity, or of a transient, from
    its middle on where its speed is held."""
    path = folder / "results.h5"
    with open_results(path, "sweep or transient", "it has no table of points") as results:
        if "diagram" in results:
            return read_table(results, "diagram", {varied.column, *MARCHED.values()})
        if "history/poincare" not in results or varied is not SPEED:
            raise PlotError(f"{path} has no marches over the {varied.label}; make them with sweep.kind marches")
        points = read_table(results, "history/poincare", {"pinion_speed", "H0", "V0", "force_max"})
    force = read_summary(folder, "transient")["static_force"]
    rows = numpy.rec.fromarrays([points["pinion_speed"], points["force_max"] / force, points["H0"], points["V0"]],
                                names=[SPEED.column, *MARCHED.values()])
    return rows if numpy.ptp(points["pinion_speed"]) > 0 else rows[rows.size // 2:]


def draw_marches(axes, rows, varied, column, **style):
    """A dot for every mesh period that was kept of every march."""
    axes.plot(rows[varied.column], rows[MARCHED[column]], linestyle="none", marker=".", markersize=4,
              markeredgewidth=0, **style)
