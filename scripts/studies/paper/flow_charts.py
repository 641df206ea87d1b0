"""Figures 5 and 6: flow charts of the mesh cycle, of one time step, and of the search of the periodic state."""
from typing import NamedTuple

from studies.common.plotting import BLUE, GREEN, GREY, VERMILLION, pyplot
from studies.paper.sketching import FONT, arrow, label, need_gears, plot_line

from matplotlib.patches import FancyBboxPatch  # after plotting, which says what is missing

# Lengths of charts in tenths of an inch.
LINE = 1.65      # height of a line of text
PADDING = 1.3    # above and below the text of a box, together
STEEPNESS = 1.9  # height of a decision over that of a box with the same text
GAP = 2.0        # between boxes
TEXT = {"fontsize": FONT - 0.5, "linespacing": 1.3}
FILL = {"step": "#E3EFF7", "decision": "#FBEBD9", "end": "#DDF0EA"}
EDGE = {"step": BLUE, "decision": VERMILLION, "end": GREEN}

CYCLES_SHOWN = 3  # mesh periods in the lives of contacts
BAR = 0.62        # thickness of a life
LIFE_COLOURS = (BLUE, VERMILLION, GREEN)


class Box(NamedTuple):
    """One box of a chart by its middle: a step, a decision or an end."""
    x: float
    y: float
    width: float
    height: float
    text: str
    kind: str

    def side(self, name):
        """The middle of the side n, e, s or w."""
        along, up = {"n": (0, 0.5), "e": (0.5, 0), "s": (0, -0.5), "w": (-0.5, 0)}[name]
        return self.x + along * self.width, self.y + up * self.height


def new_box(x, top, width, text, kind="step"):
    height = LINE * (text.count("\n") + 1) + PADDING
    height *= STEEPNESS if kind == "decision" else 1
    return Box(x, top - 0.5 * height, width, height, text, kind)


def stack(x, top, *contents):
    """Boxes (width, text, kind) below each other."""
    boxes = []
    for content in contents:
        boxes.append(new_box(x, top, *content))
        top = boxes[-1].side("s")[1] - GAP
    return boxes


def draw_box(axes, box):
    style = {"facecolor": FILL[box.kind], "edgecolor": EDGE[box.kind], "linewidth": 1.1}
    if box.kind == "decision":
        axes.add_patch(pyplot.Polygon([box.side(name) for name in "nesw"], **style))
    else:
        rounding = 1.2 if box.kind == "end" else 0.3
        axes.add_patch(FancyBboxPatch((box.x - 0.5 * box.width, box.y - 0.5 * box.height), box.width, box.height,
                                      boxstyle=f"round,pad=0,rounding_size={rounding}", **style))
    label(axes, (box.x, box.y), box.text, **TEXT)


def link(axes, *corners):
    """An arrow through the corners."""
    plot_line(axes, corners[:-1], solid_joinstyle="miter")
    arrow(axes, corners[-2], corners[-1])


def link_around(axes, start, end, x):
    """An arrow sideways to x, up or down there, and back to the end."""
    link(axes, start, (x, start[1]), (x, end[1]), end)


def link_down(axes, boxes):
    for upper, lower in zip(boxes, boxes[1:]):
        link(axes, upper.side("s"), lower.side("n"))


def answers(axes, decision, yes, no):
    """Beside the arrows that leave a decision on these sides."""
    for side, text in ((yes, "yes"), (no, "no")):
        shift = {"e": (4, 6), "w": (-4, 6), "s": (-5, -5)}[side]
        label(axes, decision.side(side), text, shift, ha="left" if side == "e" else "right", **TEXT)


def chart_axes(figure, low, high):
    """Axes over a part of the figure, in tenths of an inch from its lower left corner."""
    size = 10 * figure.get_size_inches()
    axes = figure.add_axes([low[0] / size[0], low[1] / size[1], (high[0] - low[0]) / size[0],
                            (high[1] - low[1]) / size[1]])
    axes.set_xlim(0, high[0] - low[0])
    axes.set_ylim(0, high[1] - low[1])
    axes.axis("off")
    return axes


# --- Figure 5: the mesh cycle -----------------------------------------------------------------------------------------

def draw_cycle_chart(axes, top):
    """What MeshMarch::start and MeshMarch::run do."""
    boxes = stack(
        32, top,
        (38, "start at $T = 0$, one contact at the pitch point", "end"),
        (42, "stationary film under $w^*$, at rest\n(of several contacts: films that carry $w^*$ together)"),
        (42, "next event, whichever comes first:\n"
             r"a contact enters at $\xi_s$, one leaves at $\xi_e$, end of the march"),
        (42, "equal time steps of at most $dT$ up to it (figure 6):\n"
             "first half a step of first order, then second order"),
        (30, r"a contact at $\xi_e$?", "decision"),
        (30, r"next contact at $\xi_s$?", "decision"),
        (30, "end of the march?", "decision"),
        (12, "end", "end"))
    event, steps, leaving, entering, over = boxes[2:7]
    halved = new_box(67, steps.side("n")[1], 20, "Newton fails:\nstep halved, repeated")
    dropped = new_box(66, leaving.y + 1.5, 22, "its film is dropped")
    entered = new_box(66, entering.y + 3.2, 22,
                      "its film: stationary at\nthe present $H_0$, held, from\nits neighbour's pressure")
    for box in (*boxes, halved, dropped, entered):
        draw_box(axes, box)
    link_down(axes, boxes)
    arrow(axes, steps.side("e"), halved.side("w"), "<|-|>")
    for decision, consequence in ((leaving, dropped), (entering, entered)):
        link(axes, decision.side("e"), (consequence.side("w")[0], decision.y))
        answers(axes, decision, yes="e", no="s")
        back = decision.side("s")[1] - 0.5 * GAP
        link(axes, consequence.side("s"), (consequence.x, back), (decision.x, back))
    link_around(axes, over.side("w"), event.side("w"), 6)
    answers(axes, over, yes="s", no="w")
    label(axes, (6, 0.5 * (over.y + event.y)), "the scheme restarts at first order", (-8, 0), rotation=90, **TEXT)


def draw_lives(axes, summary):
    """Which contacts exist in the first mesh periods from the pitch point on."""
    entry, leaving = summary["xi_entry"] / summary["base_pitch"], summary["xi_exit"] / summary["base_pitch"]
    first_at = -int(leaving)  # of the contacts that exist at the start the one that leaves first
    numbers = range(first_at, int(CYCLES_SHOWN - entry) + 1)
    for row, number in enumerate(numbers):
        begin, end = max(entry + number, 0), min(leaving + number, CYCLES_SHOWN)
        axes.barh(row, end - begin, BAR, begin, color=LIFE_COLOURS[number % 3], alpha=0.35)
        for place, shown in ((entry + number, begin > 0), (leaving + number, end < CYCLES_SHOWN)):
            if shown:
                axes.axvline(place, color=GREY, linewidth=0.8, linestyle="--", zorder=0)
    axes.set_xlim(0, CYCLES_SHOWN)
    axes.set_ylim(len(numbers) - 0.5, -0.5)
    axes.set_yticks(range(len(numbers)), [f"contact {row}" for row in range(len(numbers))])
    axes.tick_params(labelsize=FONT - 1)
    axes.set_xlabel("length travelled from the start [base pitches, or mesh periods]", fontsize=FONT)
    axes.set_title(f"contacts of the case {summary['case']}, contact ratio {summary['contact_ratio']:.2f}; "
                   "dashed: events", fontsize=FONT)


def draw_mesh_cycle(summary):
    """Figure 5."""
    need_gears(summary)
    figure = pyplot.figure(figsize=(8, 7.6))
    draw_cycle_chart(chart_axes(figure, (0, 18), (80, 76)), 57)
    draw_lives(figure.add_axes([0.12, 0.07, 0.83, 0.17]), summary)
    return figure


# --- Figure 6: one time step, and the search of the periodic state ----------------------------------------------------

def draw_step_chart(axes, top):
    """What SegmentStepper and the solvers of LubricatedPair do."""
    boxes = stack(
        20, top,
        (32, r"$[P_1, \dots, P_n, H_0, V_0]$ at $T$, step $dT$", "end"),
        (32, "first guess: extrapolated, $P$ clipped at zero"),
        (32, "residual at $T + dT$\n" r"films: $G_k = \min(d\,P_k,\ R_k)$, Reynolds (22)" "\n"
             r"motion: $dH_0/dT - V_0$" "\n" r"and $I_n\,dV_0/dT - \Sigma_k\iint P_k + 2\pi/(3\kappa)$"),
        (24, "small enough?", "decision"),
        (32, "Newton's direction by FGMRES:\nexact Jacobian, matrix-free; preconditioner:\n"
             "motion first, then a multigrid cycle a film"),
        (32, "no $P$ falls by more than half\nor rises by more than $0.2\\,p_h$;\nshortened until the residual falls"),
        (28, "it falls, and\niterations are left?", "decision"),
        (24, "$dT$ halved, at most 12 times"),
        (32, "accepted, films checked;\nthe next step has its full length again", "end"))
    _, guess, residual, small, _, _, goes_on, halved, accepted = boxes
    for box in boxes:
        draw_box(axes, box)
    link_down(axes, boxes[:-1])
    for decision, yes, no in ((small, "e", "s"), (goes_on, "w", "s")):
        answers(axes, decision, yes, no)
    link_around(axes, goes_on.side("w"), residual.side("w"), 2.6)
    link_around(axes, halved.side("w"), guess.side("w"), 1.0)
    link_around(axes, small.side("e"), accepted.side("e"), 38.5)


def draw_search_chart(axes, top):
    """What OrbitSearch does."""
    boxes = stack(
        20, top,
        (32, "dry pair with a damper: its periodic motion,\n$x = (H_0, V_0)$ just after a contact has left,\n"
             "Jacobian $J$ of its map over a mesh period"),
        (32, "$H_0$ shifted by the film;\nstationary films at this motion"),
        (32, r"one mesh period marched (figure 5): $\Phi(x)$"),
        (32, r"defect $r = \Phi(x) - x$; Broyden's update of $J$"),
        (28, "$x$ and all $P$ repeat?", "decision"),
        (28, "marched, and $r$ smaller\nthan the best so far?", "decision"),
        (32, r"next $x$: Newton's, $x - (J-1)^{-1}r$"),
        (32, "from the best period: step half as long;\nbelow a fifth: $J$ measured, by two periods;\n"
             "in vain: marched on, without a jump"),
        (32, "films displaced to the next $x$:\none implicit step of the change alone"),
        (32, "periodic state", "end"))
    _, _, march, _, repeats, better, newton, recovery, displaced, found = boxes
    for box in boxes:
        draw_box(axes, box)
    link_down(axes, boxes[:7])
    link_down(axes, boxes[7:9])
    for decision, yes, no in ((repeats, "e", "s"), (better, "s", "w")):
        answers(axes, decision, yes, no)
    link_around(axes, better.side("w"), recovery.side("w"), 2.6)
    link_around(axes, newton.side("e"), displaced.side("e"), 37.2)
    link_around(axes, displaced.side("w"), march.side("w"), 1.0)
    link_around(axes, repeats.side("e"), found.side("e"), 38.8)


def draw_solution(summary):
    """Figure 6; the same for every case of a gear pair."""
    need_gears(summary)
    figure = pyplot.figure(figsize=(8, 7.1))
    for left, title, draw in ((0, "one time step", draw_step_chart),
                              (40, "search of the periodic state", draw_search_chart)):
        axes = chart_axes(figure, (left, 0), (left + 40, 71))
        label(axes, (20, 69.5), title, fontsize=FONT + 1)
        draw(axes, 67.5)
    return figure
