"""The gears of a pair in a window of their plane, with the line of action and the path of contact."""
from studies.common.gears import DrawnGears
from studies.common.plotting import GREY
from studies.common.sketching import plot_line, show_window

BEYOND = 3  # of the line of action on either side of the path [mm]


def draw_gears_in_mesh(axes, pair, middle, half):
    """Gears that can be turned, within half a width and half a height of the middle [mm]."""
    axes.set_aspect("equal")
    show_window(axes, middle, half)
    drawn = DrawnGears(axes, pair)
    plot_line(axes, pair.at([pair.entry - BEYOND, pair.exit + BEYOND]), color=GREY, linestyle="--", zorder=3)
    plot_line(axes, pair.at([pair.entry, pair.exit]), linewidth=1.6, zorder=3)
    return drawn
