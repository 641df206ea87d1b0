"""Boxes of charts and the arrows between them; lengths in hundredths of an inch, from the lower left corner."""
from typing import NamedTuple

from studies.common.plotting import BLUE, DARK, GREEN, GREY, PURPLE, VERMILLION, pyplot
from studies.common.sketching import NORMAL, SMALL, WIDTH, arrow, bare_axes, label, new_figure

from matplotlib.patches import FancyBboxPatch  # after plotting, which says what is missing

FILL = {"input": "#EFEFEF", "model": "#FBEBD9", "solve": "#E3EFF7", "result": "#DDF0EA", "decision": "#FFFFFF",
        "fail": "#F7E9F0"}
EDGE = {"input": GREY, "model": VERMILLION, "solve": BLUE, "result": GREEN, "decision": DARK, "fail": PURPLE}
LINE = 16.5        # height of a line of text
PLACE = "#555555"  # print of what names places of the sources
SIDES = {"n": (0, 0.5), "e": (0.5, 0), "s": (0, -0.5), "w": (-0.5, 0)}
BESIDE = {"e": (4, 7), "w": (-4, 7), "s": (-6, -7)}  # of an answer to the side that its arrow leaves, in points


class Box(NamedTuple):
    """By its middle; a title, lines below it, and the names of places of the sources."""
    x: float
    y: float
    width: float
    height: float
    kind: str
    title: str
    text: str = ""
    place: str = ""

    def side(self, name, along=0.0):
        """The middle of the side n, e, s or w, or a place `along` it: -0.5 to 0.5."""
        right, up = SIDES[name]
        right, up = (right, along) if right else (along, up)
        return self.x + right * self.width, self.y + up * self.height


def chart(height, bottom=0):
    """A figure, and axes over all of it, from a height on."""
    figure = new_figure(height / 100)
    return figure, bare_axes(figure, [0, 0, 1, 1], ((0, 100 * WIDTH), (bottom, bottom + height)))


def draw_box(axes, box):
    style = {"facecolor": FILL[box.kind], "edgecolor": EDGE[box.kind], "linewidth": 1.3}
    if box.kind == "decision":
        axes.add_patch(pyplot.Polygon([box.side(name) for name in "nesw"], **style))
    else:
        axes.add_patch(FancyBboxPatch((box.x - 0.5 * box.width, box.y - 0.5 * box.height), box.width, box.height,
                                      boxstyle="round,pad=0,rounding_size=5", **style))
    parts = [(line, style) for text, style in (
        (box.title, {"fontsize": NORMAL, "fontweight": "bold"}), (box.text, {"fontsize": SMALL}),
        (box.place, {"fontsize": SMALL, "family": "monospace", "color": PLACE})) for line in text.split("\n") if line]
    for n, (line, print_style) in enumerate(parts):
        label(axes, (box.x, box.y + LINE * (0.5 * (len(parts) - 1) - n)), line, **print_style)


def link(axes, *corners, **style):
    """An arrow through the corners, which ends at the last one."""
    for begin, end in zip(corners[:-2], corners[1:-1]):
        axes.plot(*zip(begin, end), color=style.get("color", DARK), linewidth=style.get("linewidth", 1.2),
                  linestyle=style.get("linestyle", "-"), solid_capstyle="projecting")
    arrow(axes, corners[-2], corners[-1], **style)


def link_down(axes, *boxes):
    for upper, lower in zip(boxes, boxes[1:]):
        link(axes, upper.side("s"), lower.side("n"))


def link_around(axes, start, end, x):
    """An arrow sideways to x, up or down there, and back to the end."""
    link(axes, start, (x, start[1]), (x, end[1]), end)


def answers(axes, decision, yes, no):
    """Beside the arrows that leave a decision on these sides."""
    for side, text in ((yes, "yes"), (no, "no")):
        label(axes, decision.side(side), text, BESIDE[side], ha="left" if side == "e" else "right")
