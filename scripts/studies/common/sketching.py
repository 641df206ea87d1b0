"""Pieces of drawings: figures of the common width, lines, arrows, dimensions and texts."""
from typing import NamedTuple

from studies.common.plotting import DARK, GREY, numpy, pyplot

WIDTH = 8           # inches of a figure: 800 pixels at 100 an inch, at which no print is below SMALL
SMALL, NORMAL, LARGE = 9, 10, 12  # points
BODY_SHADE = 0.16   # opacity of solids
OIL_SHADE = 0.45
ON_WHITE = {"bbox": {"facecolor": "white", "edgecolor": "none", "pad": 0.8, "alpha": 0.8}}  # texts over lines


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


def new_figure(height):
    """A white figure of the common width; its height in inches."""
    return pyplot.figure(figsize=(WIDTH, height), facecolor="white")


def bare_axes(figure, box, limits=None):
    """Axes without a frame over a box (left, bottom, width, height) of the figure, in its own units 0 to 1."""
    axes = figure.add_axes(box)
    axes.axis("off")
    if limits:
        axes.set_xlim(limits[0])
        axes.set_ylim(limits[1])
    return axes


def true_scale_axes(figure, place, title=""):
    """Axes at true scale without a frame, at a place of the figure's grid."""
    axes = figure.add_subplot(place)
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_title(title, fontsize=SMALL)
    return axes


def show_window(axes, middle, half):
    """Limits the axes to what lies within half a width and half a height of the middle."""
    axes.set_xlim(middle[0] - half[0], middle[0] + half[0])
    axes.set_ylim(middle[1] - half[1], middle[1] + half[1])


def plot_line(axes, points, **style):
    points = numpy.asarray(points)
    axes.plot(points[:, 0], points[:, 1], **{"color": DARK, "linewidth": 1, **style})


def plot_circle(axes, centre, radius, span=(0, 2 * numpy.pi), **style):
    plot_line(axes, polar(numpy.asarray(centre), radius, numpy.linspace(*span, 400)), **style)


def arrow(axes, start, end, xycoords="data", **style):
    """An arrow that touches both points, bent by a connectionstyle."""
    axes.annotate("", end, start, xycoords=xycoords, textcoords=xycoords, annotation_clip=False, arrowprops={
        "arrowstyle": "-|>", "color": DARK, "linewidth": 1.2, "mutation_scale": 12, "shrinkA": 0, "shrinkB": 0,
        **style})


def label(axes, point, text, shift=(0, 0), **style):
    """A text at a point, moved by points of print."""
    return axes.annotate(text, point, shift, textcoords="offset points", annotation_clip=False,
                         **{"ha": "center", "va": "center", "fontsize": SMALL, "color": DARK, **style})


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
    arrow(axes, frame.at(0.0, across), frame.at(length, across), arrowstyle="<|-|>", linewidth=0.8)
    label(axes, frame.at(0.5 * length, across), text, rotation=frame.degrees(), **ON_WHITE)
