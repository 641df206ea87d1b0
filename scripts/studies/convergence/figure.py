"""Figure of a study: distance from the limit over the step, or changes from one domain to another.

The limit is extrapolated from the two finest runs, so that these always lie on a slope of 2: the order shows in the
coarser ones. Hollow marks are nearer to the limit than its error bar, and tell nothing about the order.
"""
import math

from studies.common.plotting import BLUE, DARK, GREEN, GREY, VERMILLION, add_grid, add_legend, pyplot
from studies.convergence.limit import FORMAL_ORDER, limit_of
from studies.convergence.tables import all_changes

LOOKS = ((BLUE, "o"), (VERMILLION, "s"), (GREEN, "^"), (DARK, "D"))
COLUMNS = 2
PANEL = (5.2, 3.8)        # width and height, inches
LINE_HEIGHT = 0.28        # of a line of a panel of changes, inches


def distance_panels(solved):
    """Series and quantities, panel by panel."""
    return [(one, [quantity for quantity in one.series.quantities if quantity.panel == panel])
            for one in solved if len(one.series.runs) > 1
            for panel in dict.fromkeys(quantity.panel for quantity in one.series.quantities)]


def distances(solved, quantity):
    """Steps and |value/limit - 1|, where there is a limit and the value is not the limit itself."""
    values, limit = solved.values(quantity), limit_of(solved.values(quantity)).value
    if not limit:
        return []
    return [(run.step, abs(value / limit - 1)) for run, value in zip(solved.series.runs, values)
            if value is not None and value != limit]


def draw_distance(axes, solved, quantities):
    """|value/limit - 1| over the step; dotted the bar of the limit; a line of the formal order through the greatest."""
    corner = None
    for (colour, marker), quantity in zip(LOOKS, quantities):
        points = distances(solved, quantity)
        if not points:
            continue
        limit = limit_of(solved.values(quantity))
        corner = max([*points, corner or points[0]], key=lambda point: point[1])
        bar = abs(limit.bar / limit.value)
        beyond = [point for point in points if point[1] > bar]
        looks = {"color": colour, "marker": marker, "markersize": 5}
        axes.plot(*zip(*points), **looks, markerfacecolor="white", linewidth=1.2)
        axes.plot(*zip(*beyond), **looks, linestyle="none")
        axes.plot([], [], **looks, linewidth=1.2, label=quantity.label)
        axes.axhline(bar, color=colour, linestyle=":", linewidth=0.8, zorder=0)
    axes.set_title(solved.series.title, fontsize=9)
    axes.set(xlabel=solved.series.step, ylabel="|value/limit - 1|")
    if corner is None:
        axes.text(0.5, 0.5, "no limit", ha="center", transform=axes.transAxes)
        return
    steps = [run.step for run in solved.series.runs]
    axes.plot(steps, [corner[1] * (step / corner[0]) ** FORMAL_ORDER for step in steps], color=GREY, linewidth=0.9,
              linestyle="--", label=f"slope {FORMAL_ORDER}", zorder=0)
    axes.plot([], [], color=GREY, linestyle=":", linewidth=0.8, label="bars of the limits")
    axes.set(xscale="log", yscale="log")
    axes.set_xticks(steps, [f"{step:.3g}" for step in steps])
    axes.minorticks_off()
    axes.legend(fontsize=7)
    add_grid(axes)


def draw_distances(solved):
    panels = distance_panels(solved)
    lines = math.ceil(len(panels) / COLUMNS)
    figure, axes = pyplot.subplots(lines, COLUMNS, figsize=(COLUMNS * PANEL[0], lines * PANEL[1]), squeeze=False,
                                   constrained_layout=True)
    for panel, (one, quantities) in zip(axes.flat, panels):
        draw_distance(panel, one, quantities)
    for panel in axes.flat[len(panels):]:
        panel.remove()
    return figure


def draw_change(axes, changes):
    """A line a case or quantity, with a mark a column of the table."""
    names = [line.name for line in changes.rows]
    for n, ((colour, marker), label) in enumerate(zip(LOOKS, changes.columns)):
        percents = [math.nan if line.changes[n] is None else 100 * line.changes[n] for line in changes.rows]
        axes.plot(percents, range(len(names)), color=colour, marker=marker, markerfacecolor="none", linestyle="none",
                  label=label)
    axes.axvline(0, color=GREY, linewidth=0.8, zorder=0)
    axes.set_yticks(range(len(names)), names)
    axes.set_ylim(len(names) - 0.5, -0.5)
    axes.set_xlabel("change from the short domain [%]")
    add_legend(axes, *axes.get_legend_handles_labels())
    add_grid(axes)


def draw_changes(solved):
    tables = all_changes(solved)
    heights = [LINE_HEIGHT * len(changes.rows) + 1.2 for changes in tables]
    figure, axes = pyplot.subplots(len(tables), 1, figsize=(COLUMNS * PANEL[0], sum(heights)), squeeze=False,
                                   height_ratios=heights, constrained_layout=True)
    for panel, changes in zip(axes.flat, tables):
        draw_change(panel, changes)
    return figure


def draw(study, solved):
    return draw_distances(solved) if study.refined else draw_changes(solved)
