"""Figure of mixed lubrication: what oil and asperities carry.

Of a sweep over the speed: the Stribeck curve, which is the mean friction coefficient over the speed, and the part of
the load that asperities carry. Of a march or a periodic state: that part, friction and wear over the line of action. Of
a film at rest: pressures of oil and asperities, and the mean gap, along y = 0.
"""
import numpy
from matplotlib import pyplot

from .canvas import (BLUE, DARK, GREEN, VERMILLION, Foreign, PlotError, add_grid, add_legend, by_contact,
                     draw_over_path, of_last_period, open_results, read_table)
from .diagrams import SPEED, varied_quantity

LACK = "it has no asperities; give roughness.model"
LOADED = 0.02       # of the largest force: contacts that carry less are left out


def read_sweep(results):
    if varied_quantity(results, "sweep.over", {"speed": SPEED}) is not SPEED:
        raise Foreign("it is no sweep over the speed")
    rows = read_table(results, "sweep", {"found", SPEED.column})
    if "asperity_load_share_mean" not in rows.dtype.names:
        raise Foreign(LACK)
    return numpy.sort(rows[rows["found"] == 1], order=SPEED.column)


def draw_sweep(rows):
    """The Stribeck curve."""
    rubs = "mean_friction_coefficient" in rows.dtype.names
    figure, axes = pyplot.subplots(1 + rubs, 1, sharex=True, figsize=(7, 3 + 2.4 * rubs), squeeze=False,
                                   constrained_layout=True)
    axes = axes[:, 0]
    if rubs:
        axes[0].semilogx(rows[SPEED.column], rows["mean_friction_coefficient"], color=VERMILLION, marker="o", markersize=4)
        axes[0].set_ylabel("mean friction coefficient [-]")
        axes[0].set_ylim(bottom=0)
    axes[-1].semilogx(rows[SPEED.column], rows["asperity_load_share_mean"], color=BLUE, marker="o", markersize=4)
    axes[-1].set_ylabel("load carried by asperities [-]")
    axes[-1].set_ylim(0, 1)
    axes[-1].set_xlabel(SPEED.label)
    add_grid(*axes)
    return figure


def read_march(results):
    rows = read_table(results, "history/contacts", {"xi", "contact", "T", "force"})
    if "asperity_load_share" not in rows.dtype.names:
        raise Foreign(LACK)
    rows = of_last_period(results, rows)
    rows = rows[rows["force"] > LOADED * rows["force"].max()]
    return by_contact(rows)


def panels_of(names):
    """Panels of the columns that there are: each column with its scale, label and colour."""
    panels = [("load carried by asperities [-]", [("asperity_load_share", 1.0, "", BLUE)])]
    if "friction_coefficient" in names:
        panels.append(("friction coefficient [-]", [("friction_coefficient", 1.0, "all", DARK),
                                                    ("friction_coefficient_boundary", 1.0, "asperities", VERMILLION)]))
    if "wear_depth_pinion" in names:
        panels.append(("wear by one mesh [pm]", [("wear_depth_pinion", 1e12, "pinion", BLUE),
                                                 ("wear_depth_wheel", 1e12, "wheel", GREEN)]))
    return panels


def draw_march(contacts):
    return draw_over_path(contacts, panels_of(contacts[0].dtype.names), height=2.4, from_zero=True)


def draw_film(contact):
    """Pressures and the mean gap along y = 0."""
    if "p_asperity" not in contact:
        raise Foreign(LACK)
    middle = int(numpy.argmin(abs(contact["y"][:])))
    x = 1e3 * contact["x"][:]
    figure, (pressures, gap) = pyplot.subplots(2, 1, sharex=True, figsize=(7, 5.4), constrained_layout=True)
    for name, label, colour in (("P", "both", DARK), ("p_fluid", "oil", BLUE), ("p_asperity", "asperities", VERMILLION)):
        pressures.plot(x, 1e-9 * contact[name][:, middle], color=colour, linewidth=1.4, label=label)
    pressures.set_ylabel("pressure [GPa]")
    pressures.set_ylim(bottom=0)
    add_legend(pressures, *pressures.get_legend_handles_labels())
    loaded = contact["P"][:, middle] > 1e-3 * contact["P"][:, middle].max()
    mean = 1e6 * contact["gap_mean"][:, middle]
    gap.plot(x, mean, color=GREEN, linewidth=1.4)
    gap.set_ylim(0, 1.5 * mean[loaded].max())
    gap.set_ylabel("mean gap [µm]")
    gap.set_xlabel("x along y = 0 [mm]")
    add_grid(pressures, gap)
    return figure


def draw_folder(folder):
    """Draws `gearfilm sweep` over the speed, `periodic`, `transient` or `steady`, with roughness.model."""
    with open_results(folder / "results.h5", "sweep, periodic, transient or steady", LACK) as results:
        if "sweep" in results:
            rows = read_sweep(results)
            if not rows.size:
                raise PlotError(f"{folder} has no periodic state, all points failed")
            return draw_sweep(rows)
        if "history" in results:
            return draw_march(read_march(results))
        if "contact0" not in results:
            raise Foreign(LACK)
        return draw_film(results["contact0"])
