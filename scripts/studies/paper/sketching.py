"""Pieces of drawings: points, lines, arrows, dimensions and texts at true scale."""
from typing import NamedTuple

from studies.common.plotting import DARK, GREY, PlotError, numpy

FONT = 9           # points
BODY_SHADE = 0.14  # opacity of solids
OIL_SHADE = 0.45
ON_WHITE = {"bbox": {"facecolor": "white", "edgecolor": "none", "pad": 0.8, "alpha": 0.8}}  # texts over lines
NEEDED = {"working_pressure_angle_deg", "base_radius_pinion", "base_radius_wheel", "base_pitch", "xi_entry", "xi_exit"}


def need_gears(summary):
    """Refuses a summary of `gearfilm info` without the geometry of gears."""
    if not NEEDED <= set(summary):
        raise PlotError(f"case {summary.get('case', '')} is not that of a gear pair")


class Frame(NamedTuple):
    """Coordinates along a direction and across it, to the left."""
    origin: numpy.ndarray
    along: numpy.ndarray  # unit vector

    def at(self, along, across=0.0):
        """The point, or the points."""
        left = numpy.array([-self.along[1], self.along[0]])
        return self.origin + numpy.multiply.outer(along, self.along) + numpy.multiply.outer(across, left)

    def degrees(self):
        """Slope of the direction, which has a part to the right."""
        return numpy.degrees(numpy.arctan(self.along[1] / self.along[0]))


def polar(centre, radius, angle):
    return centre + numpy.stack([radius * numpy.cos(angle), radius * numpy.sin(angle)], axis=-1)


def plot_line(axes, points, **style):
    points = numpy.asarray(points)
    axes.plot(points[:, 0], points[:, 1], **{"color": DARK, "linewidth": 1, **style})


def plot_circle(axes, centre, radius, span=(0, 2 * numpy.pi), **style):
    plot_line(axes, polar(numpy.asarray(centre), radius, numpy.linspace(*span, 400)), **style)


def arrow(axes, start, end, style="-|>", **line):
    """An arrow, bent by a connectionstyle."""
    axes.annotate("", end, start, annotation_clip=False, arrowprops={
        "arrowstyle": style, "color": DARK, "linewidth": 1, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 9, **line})


def label(axes, point, text, shift=(0, 0), **style):
    """A text at a point, moved by points of print."""
    axes.annotate(text, point, shift, textcoords="offset points", annotation_clip=False,
                  **{"ha": "center", "va": "center", "fontsize": FONT, "color": DARK, **style})


def pointed_label(axes, point, text, shift):
    """A text away from a point, with a thin line to it."""
    label(axes, point, text, shift, arrowprops={
        "arrowstyle": "-", "color": GREY, "linewidth": 0.7, "shrinkA": 1, "shrinkB": 0})


def dimension(axes, start, end, text, across):
    """A dimension line between two points, moved across, with its text in a gap of it."""
    step = numpy.subtract(end, start)
    length = numpy.hypot(*step)
    frame = Frame(numpy.asarray(start), step / length)
    for along in (0.0, length):
        plot_line(axes, frame.at([along, along], [0.0, across]), color=GREY, linewidth=0.6)
    arrow(axes, frame.at(0.0, across), frame.at(length, across), "<|-|>", linewidth=0.8)
    label(axes, frame.at(0.5 * length, across), text, rotation=frame.degrees(), **ON_WHITE)


def show_window(axes, middle, half):
    """Limits the axes to what lies within half a width and half a height of the middle."""
    axes.set_xlim(middle[0] - half[0], middle[0] + half[0])
    axes.set_ylim(middle[1] - half[1], middle[1] + half[1])


def bare_axes(figure, place, title=""):
    """Axes at true scale without a frame."""
    axes = figure.add_subplot(place)
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_title(title, fontsize=FONT)
    return axes
