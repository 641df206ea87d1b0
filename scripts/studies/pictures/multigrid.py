"""The multigrid cycle of one film: its grids, what is transferred between them, and the line smoother."""
from studies.common.boxes import Box, chart, draw_box, link
from studies.common.plotting import BLUE, DARK, GREEN, GREY, PALE, VERMILLION, numpy, pyplot
from studies.common.sketching import LARGE, NORMAL, SMALL, arrow, label

HEIGHT = 735
GRID_AT, GRID_SIZE = 92, (150, 62)
LEVELS = ((620, (129, 65), (16, 8)), (493, (65, 33), (8, 4)), (366, (33, 33), (4, 4)))  # y, nodes, cells drawn
DOWN = [Box(x, y, 196, 68, "solve", "1 relaxation", "then the residual by\na full convolution (FFT)")
        for x, (y, _, _) in zip((310, 348), LEVELS)]
UP = [Box(x, y, 196, 68, "solve", "1 relaxation", "of the residual by\na full convolution (FFT)")
      for x, (y, _, _) in zip((688, 650), LEVELS)]
COARSEST = Box(499, 366, 250, 68, "solve", "4 relaxations", "a full convolution (FFT)\nbefore each but the first")
HALF_WIDTH, SHOWN = 3, 9       # of the band; nodes on either side in the plots
WEIGHT = 0.25                  # of a neighbour in a distributive change, square cells
STRIP = "#F3F6F9"


def draw_grid(axes, y, nodes, cells):
    """The grid of a level with fewer lines than it has, the contact's ellipse, and the cavitated oil behind it."""
    left, bottom = GRID_AT - 0.5 * GRID_SIZE[0], y - 0.5 * GRID_SIZE[1]
    axes.add_patch(pyplot.Rectangle((left, bottom), *GRID_SIZE, facecolor="white", edgecolor="none"))
    axes.add_patch(pyplot.Rectangle((left + 0.82 * GRID_SIZE[0], bottom), 0.18 * GRID_SIZE[0], GRID_SIZE[1],
                                    facecolor=PALE, edgecolor="none"))
    turn = numpy.linspace(0, 2 * numpy.pi, 100)
    axes.fill(left + GRID_SIZE[0] * (0.6 + 0.22 * numpy.cos(turn)), y + 0.44 * GRID_SIZE[1] * numpy.sin(turn),
              color=GREEN, alpha=0.3, linewidth=0)
    for n in range(cells[0] + 1):
        axes.plot([left + GRID_SIZE[0] * n / cells[0]] * 2, [bottom, bottom + GRID_SIZE[1]], color=GREY, linewidth=0.5)
    for n in range(cells[1] + 1):
        height = bottom + GRID_SIZE[1] * n / cells[1]
        axes.plot([left, left + GRID_SIZE[0]], [height, height], color=BLUE, linewidth=1.2)
    label(axes, (GRID_AT, y - 0.5 * GRID_SIZE[1] - 11), f"{nodes[0]} × {nodes[1]} nodes")


def draw_cycle(axes):
    """Its levels: relaxations before the way down and behind the way up."""
    for level in LEVELS:
        draw_grid(axes, *level)
    for box in (*DOWN, *UP, COARSEST):
        draw_box(axes, box)


def draw_transfers(axes):
    """What the arrows carry, into the cycle, between its levels and out of it."""
    top = DOWN[0].side("n")[1]
    for x, ends, text, side in ((DOWN[0].x, (top + 36, top), "residual, from FGMRES", "left"),
                                (UP[0].x, (top, top + 36), "change of the pressure", "right")):
        link(axes, (x, ends[0]), (x, ends[1]))
        label(axes, (x, top + 24), text, (7 if side == "left" else -7, 0), ha=side)
    down, up = "residual:\nfull weighting", "change: bilinear\ninterpolation"
    between = [0.5 * (upper + lower) for (upper, _, _), (lower, _, _) in zip(LEVELS, LEVELS[1:])]
    for finer, coarser, y, text, shift in (
            (DOWN[0], DOWN[1], between[0], down, 8), (UP[0], UP[1], between[0], up, -8),
            (DOWN[1], COARSEST, between[1], down, -8), (UP[1], COARSEST, between[1], up, 8)):
        inner = 1 if finer in DOWN else -1
        x = 0.5 * (finer.x + 0.5 * inner * finer.width + coarser.x - 0.5 * inner * coarser.width)
        ends = finer.side("s")[1], coarser.side("n")[1]
        link(axes, *((x, height) for height in (ends if finer in DOWN else ends[::-1])))
        label(axes, (x, y), text, (shift, 0), ha="left" if shift > 0 else "right", linespacing=1.25)
    for (y, _, _), (coarser, _, _) in zip(LEVELS, LEVELS[1:]):
        x = GRID_AT + 0.5 * GRID_SIZE[0] - 14
        arrow(axes, (x, y - 0.5 * GRID_SIZE[1]), (x, coarser + 0.5 * GRID_SIZE[1]), linestyle="--")
        label(axes, (x, 0.5 * (y + coarser)), "state: injected", (-7, -4), ha="right")


def draw_notes(axes):
    label(axes, (499, 716), "V-cycle: preconditioner of one film", fontsize=LARGE, fontweight="bold")
    label(axes, (GRID_AT - 75, 690), "lines along x (blue),\ncontact (green),\ncavitated nodes (grey)", ha="left",
          linespacing=1.25)
    label(axes, (499, LEVELS[0][0]), "in short time steps\nthe finest level\nalone: 1 relaxation", linespacing=1.25)
    label(axes, (499, LEVELS[1][0]), "cavitated\nnodes neither\ngive nor take", linespacing=1.25)
    label(axes, (634, LEVELS[2][0]), "coarsest: 33 nodes, or\nsteps as long as the rise\nof pressure in the inlet",
          ha="left", linespacing=1.25)
    label(axes, (364, LEVELS[2][0]), "where cells are long,\nlevels keep all rows\nin stationary films", ha="right",
          linespacing=1.25)


def kernel(i, j):
    """Deformation at (i, j) cells from a cell under a uniform pressure: Love's closed form, square cells."""
    def corner(x, y):
        return x * numpy.arcsinh(y / abs(x)) + y * numpy.arcsinh(x / abs(y))
    return (corner(i + 0.5, j + 0.5) - corner(i - 0.5, j + 0.5) - corner(i + 0.5, j - 0.5) + corner(i - 0.5, j - 0.5))


def draw_unknown(figure, left, distributive):
    """A unit change of one kind, and the deformation on its line."""
    axes = figure.add_axes([left, 0.085, 0.27, 0.185])
    places = numpy.arange(-SHOWN, SHOWN + 1)
    deformed = kernel(places, 0)
    if distributive:
        deformed = deformed - WEIGHT * (kernel(places - 1, 0) + kernel(places + 1, 0) + 2 * kernel(places, 1))
    axes.axvspan(-HALF_WIDTH - 0.5, HALF_WIDTH + 0.5, color=BLUE, alpha=0.12, linewidth=0)
    axes.bar(places, deformed / kernel(0, 0), 0.6, color=VERMILLION if distributive else GREY)
    axes.set_ylim(-0.2, 1.05)
    axes.set_xlim(-SHOWN - 0.6, SHOWN + 0.6)
    axes.tick_params(labelsize=SMALL)
    axes.set_yticks([0, 1])
    axes.set_xticks([-6, -3, 0, 3, 6])
    axes.set_xlabel("deformation at nodes of the line", fontsize=SMALL)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    axes.axhline(0, color=DARK, linewidth=0.8)
    return axes


def draw_smoother(figure, axes):
    """The relaxation, and the two kinds of unknowns."""
    axes.add_patch(pyplot.Rectangle((8, 6), 784, 304, facecolor=STRIP, edgecolor=GREY, linewidth=0.8, zorder=-2))
    label(axes, (20, 294), "one relaxation: line smoother", fontsize=LARGE, fontweight="bold", ha="left")
    label(axes, (20, 266), "All lines along x are\nrelaxed at once, each by\na direct solve of a band\n"
          "of half-width 3 (blue).\n\nThe band holds the flow\nand the deformation by\nnear nodes alone: no\n"
          "convolution.\n\nChanges are damped: 0.75.", ha="left", va="top",
          linespacing=1.35)
    for left, distributive, title, text in (
            (0.285, False, "plain change", "where oil flows easily,\n" r"$\xi_R/h_x^2 \geq 1.5$"),
            (0.67, True, "distributive change", "elsewhere: a node up,\nits four neighbours down")):
        panel = draw_unknown(figure, left, distributive)
        label(panel, (0, 1.44), title, xycoords="axes fraction", ha="left", fontsize=NORMAL, fontweight="bold")
        label(panel, (0, 1.18), text, xycoords="axes fraction", ha="left", linespacing=1.25)


def draw_multigrid():
    figure, axes = chart(HEIGHT)
    draw_cycle(axes)
    draw_transfers(axes)
    draw_notes(axes)
    draw_smoother(figure, axes)
    return figure
