"""Figures 5 and 6: flow charts of the mesh cycle and of the search of the periodic state.

One time step is drawn by the study pictures.
"""
from studies.common.boxes import LINE, Box, answers, chart, draw_box, link, link_around, link_down
from studies.common.gears import need_gears
from studies.common.plotting import BLUE, GREEN, GREY, VERMILLION
from studies.common.sketching import SMALL, label

# Lengths of charts in hundredths of an inch.
PADDING = 13     # above and below the text of a box, together
STEEPNESS = 1.9  # height of a decision over that of a box with the same text
GAP = 20         # between boxes

CYCLES_SHOWN = 3  # mesh periods in the lives of contacts
BAR = 0.62        # thickness of a life
LIFE_COLOURS = (BLUE, VERMILLION, GREEN)


def new_box(x, top, width, text, kind="solve"):
    height = LINE * (text.count("\n") + 1) + PADDING
    height *= STEEPNESS if kind == "decision" else 1
    return Box(x, top - 0.5 * height, width, height, kind, "", text)


def stack(x, top, *contents):
    """Boxes (width, text, kind) below each other."""
    boxes = []
    for content in contents:
        boxes.append(new_box(x, top, *content))
        top = boxes[-1].side("s")[1] - GAP
    return boxes


# --- Figure 5: the mesh cycle -----------------------------------------------------------------------------------------

def draw_cycle_chart(axes, top):
    """What MeshMarch::start and MeshMarch::run do."""
    boxes = stack(
        320, top,
        (380, "start at $T = 0$, one contact at the pitch point", "result"),
        (420, "stationary film under $w^*$, at rest\n(of several contacts: films that carry $w^*$ together)"),
        (420, "next event, whichever comes first:\n"
              r"a contact enters at $\xi_s$, one leaves at $\xi_e$, end of the march"),
        (420, "equal time steps of at most $dT$ up to it:\n"
              "first half a step of first order, then second order"),
        (300, r"a contact at $\xi_e$?", "decision"),
        (300, r"next contact at $\xi_s$?", "decision"),
        (300, "end of the march?", "decision"),
        (120, "end", "result"))
    event, steps, leaving, entering, over = boxes[2:7]
    halved = new_box(670, steps.side("n")[1], 200, "a step fails: it is\ntried again, then halved", "fail")
    dropped = new_box(660, leaving.y + 15, 220, "its film is dropped")
    entered = new_box(660, entering.y + 32, 220,
                      "its film: stationary at\nthe present $H_0$, held, from\nits neighbour's pressure")
    for box in (*boxes, halved, dropped, entered):
        draw_box(axes, box)
    link_down(axes, *boxes)
    link(axes, steps.side("e"), halved.side("w"), arrowstyle="<|-|>")
    for decision, consequence in ((leaving, dropped), (entering, entered)):
        link(axes, decision.side("e"), (consequence.side("w")[0], decision.y))
        answers(axes, decision, yes="e", no="s")
        back = decision.side("s")[1] - 0.5 * GAP
        link(axes, consequence.side("s"), (consequence.x, back), (decision.x, back))
    link_around(axes, over.side("w"), event.side("w"), 60)
    answers(axes, over, yes="s", no="w")
    label(axes, (60, 0.5 * (over.y + event.y)), "the scheme restarts at first order", (-8, 0), rotation=90)


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
    axes.tick_params(labelsize=SMALL)
    axes.set_xlabel("length travelled from the start [base pitches, or mesh periods]", fontsize=SMALL)
    axes.set_title(f"contacts of the case {summary['case']}, contact ratio {summary['contact_ratio']:.2f}; "
                   "dashed: events", fontsize=SMALL)


def draw_mesh_cycle(summary):
    """Figure 5."""
    need_gears(summary)
    figure, axes = chart(760)
    draw_cycle_chart(axes, 750)
    draw_lives(figure.add_axes([0.12, 0.07, 0.83, 0.17]), summary)
    return figure


# --- Figure 6: the search of the periodic state -----------------------------------------------------------------------

def draw_search_chart(axes, top):
    """What OrbitSearch does."""
    boxes = stack(
        400, top,
        (480, "dry pair with a damper: its periodic motion,\n$x = (H_0, V_0)$ just after a contact has left,\n"
              "Jacobian $J$ of its map over a mesh period"),
        (480, "$H_0$ shifted by the film;\nstationary films at this motion"),
        (480, r"one mesh period marched (figure 5): $\Phi(x)$"),
        (480, r"defect $r = \Phi(x) - x$; Broyden's update of $J$"),
        (300, "$x$ and all $P$ repeat?", "decision"),
        (300, "marched, and $r$ smaller\nthan the best so far?", "decision"),
        (480, r"next $x$: Newton's, $x - (J-1)^{-1}r$"),
        (480, "from the best period: step half as long;\nbelow a fifth: $J$ measured, by two periods;\n"
              "in vain: marched on, without a jump", "fail"),
        (480, "films displaced to the next $x$:\none implicit step of the change alone"),
        (480, "periodic state", "result"))
    _, _, march, _, repeats, better, newton, recovery, displaced, found = boxes
    for box in boxes:
        draw_box(axes, box)
    link_down(axes, *boxes[:7])
    link_down(axes, *boxes[7:9])
    for decision, yes, no in ((repeats, "e", "s"), (better, "s", "w")):
        answers(axes, decision, yes, no)
    link_around(axes, better.side("w"), recovery.side("w"), 130)
    link_around(axes, newton.side("e"), displaced.side("e"), 665)
    link_around(axes, displaced.side("w"), march.side("w"), 100)
    link_around(axes, repeats.side("e"), found.side("e"), 700)


def draw_solution(summary):
    """Figure 6; the same for every case of a gear pair."""
    need_gears(summary)
    figure, axes = chart(690)
    draw_search_chart(axes, 680)
    return figure
