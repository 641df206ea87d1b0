"""Mode shapes of a drive train: how far every node turns and moves in each mode.

Rotations are lengths at the base circle of the gear on their side, x is along the line of centres and y across it; the
largest of a mode is 1.
"""
import numpy
from matplotlib import pyplot

from .campbell import frequency_of, read_modes
from .canvas import BLUE, DARK, GREEN, VERMILLION

WAYS = {"rotation": ("turns", BLUE), "x": ("x", VERMILLION), "y": ("y", GREEN)}
MOST = 12  # panels


def bars_of(mode):
    """Labels, values and colours of one mode's bars, node by node."""
    bars = [(f"{node} {WAYS[way][0]}", value, WAYS[way][1])
            for node, ways in mode["shape"].items() for way, value in ways.items()]
    return zip(*bars)


def draw_folder(folder):
    """Draws the lowest modes of `gearfilm info` or `eigen` of a case with a drive train."""
    modes = read_modes(folder)["modes"][:MOST]
    columns = min(4, len(modes))
    rows = -(-len(modes) // columns)
    labels = list(bars_of(modes[0]))[0]
    figure, axes = pyplot.subplots(rows, columns, sharex=True, sharey=True, squeeze=False, constrained_layout=True,
                                   figsize=(1.5 + 1.9 * columns, 0.6 + rows * (0.7 + 0.19 * len(labels))))
    for panel, mode in zip(axes.flat, modes):
        _, values, colours = bars_of(mode)
        panel.barh(numpy.arange(len(values)), values, color=colours)
        panel.axvline(0, color=DARK, linewidth=0.6)
        panel.set_title(f"{frequency_of(mode):.0f} Hz, teeth {mode['mesh_share']:.2f}", fontsize=8)
        panel.set_xlim(-1.08, 1.08)
        panel.tick_params(labelsize=8)
    for panel in list(axes.flat)[len(modes):]:
        panel.set_visible(False)
    axes[0, 0].set_yticks(numpy.arange(len(labels)), labels)
    axes[0, 0].invert_yaxis()
    figure.supxlabel("way, the largest of the mode 1 [-]", fontsize=9)
    return figure
