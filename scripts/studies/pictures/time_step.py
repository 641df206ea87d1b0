"""One time step of the coupled films and motion: prediction, Newton's method, linear solves, what follows a failure."""
from studies.common.boxes import Box, answers, chart, draw_box, link, link_around, link_down
from studies.common.plotting import BLUE
from studies.common.sketching import NORMAL, label

from matplotlib.patches import FancyBboxPatch  # after plotting, which says what is missing

HEIGHT, BOTTOM = 702, 30
MAIN, SIDE, EDGE = 218, 600, 786  # middles of both columns; where failures go up

START = Box(MAIN, 699, 340, 52, "result", "state at $T$", "pressures of all films, motion of the pair")
PREDICT = Box(MAIN, 608, 340, 84, "solve", "predict the state at $T + dT$",
              "extrapolated; no pressure falls by more than half;\nwhat the last mesh period's guess missed, added",
              "dynamics/segment_stepper")
RESIDUAL = Box(MAIN, 478, 340, 84, "solve", "residual", "contacts placed on the line of action at $T + dT$\n"
               "films: $\\min(d\\,P,\\ R) = 0$;  bodies: equation of motion", "solver/film_system")
SMALL_ENOUGH = Box(MAIN, 388, 220, 56, "decision", "", "small enough?")
LINEAR = Box(MAIN, 287, 340, 100, "solve", "linear system of films and motion",
             "nodes with $R \\geq d\\,P$ are cavitated, others full of oil\n"
             "FGMRES; products without a matrix,\none convolution (FFT) a film", "numerics/newton")
CHANGE = Box(MAIN, 180, 340, 68, "solve", "change of the state", "limited at each node, smaller where it overshoots,\n"
             "shortened until the residual falls")
GOES_ON = Box(MAIN, 86, 236, 66, "decision", "", "it falls, and\niterations are left?")
AGAIN = Box(SIDE, 608, 300, 100, "fail", "the step failed: try again",
            "1. from the state at $T$; residual may only fall\n"
            "2. from where four short steps lead\n3. with $dT/2$, 12 times at most", "dynamics/segment_stepper")
ACCEPTED = Box(SIDE, 420, 300, 118, "result", "accepted", "heat and shear of the films advance by $dT$\n"
               "friction on the motion is brought up to date\nforces, films and motion are recorded\n"
               "next step, of the full length again", "traction, dynamics")
CYCLE = Box(SIDE, 262, 300, 150, "solve", "preconditioner", "1. the motion, as if no force changed with it;\n"
            "films eliminated exactly where teeth bend\nor bodies have no inertia\n"
            "2. each film, by a multigrid cycle (PCMG)\nwith a line smoother; in short time steps\n"
            "by the smoother alone", "solver/film_system, film")
ALL = (START, PREDICT, RESIDUAL, SMALL_ENOUGH, LINEAR, CHANGE, GOES_ON, AGAIN, ACCEPTED, CYCLE)


def draw_time_step():
    figure, axes = chart(HEIGHT, BOTTOM)
    axes.add_patch(FancyBboxPatch((12, 40), 386, 510, boxstyle="round,pad=0,rounding_size=6", facecolor="none",
                                  edgecolor=BLUE, linewidth=1.3, linestyle="--"))
    label(axes, (48, 535), "Newton's method", fontsize=NORMAL, fontweight="bold", ha="left")
    for box in ALL:
        draw_box(axes, box)
    link_down(axes, START, PREDICT, RESIDUAL, SMALL_ENOUGH, LINEAR, CHANGE, GOES_ON)
    link(axes, SMALL_ENOUGH.side("e"), (ACCEPTED.side("w")[0], SMALL_ENOUGH.y))
    link_around(axes, GOES_ON.side("w"), RESIDUAL.side("w"), 30)
    link_around(axes, GOES_ON.side("e"), AGAIN.side("e"), EDGE)
    link(axes, AGAIN.side("w"), PREDICT.side("e"))
    link(axes, LINEAR.side("e"), (CYCLE.side("w")[0], LINEAR.y), arrowstyle="<|-|>")
    answers(axes, SMALL_ENOUGH, yes="e", no="s")
    answers(axes, GOES_ON, yes="w", no="e")
    return figure
