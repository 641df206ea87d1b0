"""Figure of a march: motion, forces and films over the length travelled, or over time where contacts are held."""
from typing import NamedTuple

import numpy
from matplotlib import pyplot

from .canvas import BLUE, DARK, GREEN, PALE, VERMILLION, add_grid, broken, gaps, open_results, read_table

TOOTH_COLOURS = [BLUE, VERMILLION, GREEN]  # teeth take turns
WIDE_RANGE = 5  # of film thickness: beyond it, when contact is lost, the axis is logarithmic


class March(NamedTuple):
    """The two tables of a history, and what of it is the periodic state."""
    steps: numpy.ndarray
    contacts: numpy.ndarray
    periodic: tuple     # from, to [-]; empty where there is none

    @property
    def over(self):
        """What the curves are drawn over, and its label: the length travelled, or time where contacts are held."""
        if numpy.ptp(self.steps["distance"]) > 0:
            return 1e3 * self.steps["distance"], "length travelled along the line of action [mm]"
        return 1e3 * self.steps["t"], "time [ms]; the contacts are held where they are"


def read_march(path):
    with open_results(path, "transient", "it has no history") as results:
        span = [results["history"].attrs[name] for name in ("periodic_from", "periodic_to")
                if name in results["history"].attrs]
        return March(read_table(results, "history/steps", ["step", "T", "t", "dT", "distance", "H0", "force_total"]),
                     read_table(results, "history/contacts", ["step", "contact", "force", "p_max"]), tuple(span))


def draw_motion(axes, march, column, scale):
    """One line, which ends where time is missing and begins again behind it."""
    rows = gaps(march.steps)
    axes.plot(broken(march.over[0], rows), broken(scale * march.steps[column], rows), color=DARK, linewidth=1.2)


def draw_teeth(axes, march, column, scale, **style):
    """One line a tooth pair, with the gaps of the motion."""
    distance = dict(zip(march.steps["step"], march.over[0]))
    behind = march.steps["step"][gaps(march.steps)]
    for tooth in numpy.unique(march.contacts["contact"]):
        rows = march.contacts[march.contacts["contact"] == tooth]
        missing = numpy.searchsorted(rows["step"], behind)
        axes.plot(broken([distance[step] for step in rows["step"]], missing), broken(scale * rows[column], missing),
                  color=TOOTH_COLOURS[tooth % len(TOOTH_COLOURS)], linewidth=1.2, **style)


def draw(march):
    lubricated = "h_min" in march.contacts.dtype.names
    figure, rows = pyplot.subplots(4 if lubricated else 3, 1, sharex=True, figsize=(8, 8 if lubricated else 6.5),
                                   constrained_layout=True)
    travelled, label = march.over
    draw_motion(rows[0], march, "H0", 1)
    rows[0].set_ylabel("$H_0$ [-]")
    draw_motion(rows[1], march, "force_total", 1e-3)
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
    rows[-1].set_xlabel(label)
    if march.periodic:
        begin, end = numpy.interp(march.periodic, march.steps["T"], travelled)
        for axes in rows:
            axes.axvspan(begin, end, color=PALE, alpha=0.5, zorder=0, linewidth=0)
        rows[0].set_title("shaded: the periodic state", fontsize=9)
    add_grid(*rows)
    for axes in rows:
        axes.margins(x=0)
    return figure


def draw_folder(folder):
    """Draws `gearfilm transient` or `periodic`."""
    return draw(read_march(folder / "results.h5"))
