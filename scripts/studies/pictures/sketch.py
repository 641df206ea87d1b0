"""What the pictures have in common: sizes of print, arrows, labels, the written file."""
from matplotlib import pyplot
from PIL import Image

from gearfilm.drawing.canvas import COLOURS, DARK

WIDTH = 8           # inches: 800 pixels at 100 an inch, at which no print is below SMALL
SMALL, NORMAL, LARGE = 9, 10, 12  # points
TINT = 0.16         # opacity of bodies


def new_figure(height):
    """A white figure of the common width."""
    return pyplot.figure(figsize=(WIDTH, height), facecolor="white")


def bare_axes(figure, box, limits=None):
    """Axes without a frame over a box (left, bottom, width, height) of the figure, in its own units 0 to 1."""
    axes = figure.add_axes(box)
    axes.axis("off")
    if limits:
        axes.set_xlim(limits[0])
        axes.set_ylim(limits[1])
    return axes


def arrow(axes, start, end, xycoords="data", **style):
    """A straight or bent arrow that touches both points."""
    axes.annotate("", end, start, xycoords=xycoords, textcoords=xycoords, annotation_clip=False, arrowprops={
        "arrowstyle": "-|>", "color": DARK, "linewidth": 1.2, "mutation_scale": 12, "shrinkA": 0, "shrinkB": 0,
        **style})


def label(axes, point, text, shift=(0, 0), **style):
    """A text at a point, moved by points of print."""
    return axes.annotate(text, point, shift, textcoords="offset points", annotation_clip=False,
                         **{"ha": "center", "va": "center", "fontsize": SMALL, "color": DARK, **style})


def save(figure, path):
    """A PNG with a palette, since pictures have few colours."""
    figure.savefig(path, dpi=150, facecolor="white")
    pyplot.close(figure)
    with Image.open(path) as image:
        small = image.convert("RGB").quantize(COLOURS, kmeans=1)
    small.save(path, optimize=True)
