"""Figure 1: the gear pair as a vibrating system, from the geometry that `gearfilm info` tells."""
from typing import NamedTuple

from studies.common.gears import need_gears
from studies.common.plotting import BLUE, DARK, GREEN, GREY, PALE, VERMILLION, numpy, pyplot
from studies.common.sketching import (BODY_SHADE, OIL_SHADE, Frame, arrow, dimension, label, plot_circle, plot_line,
                                      pointed_label, polar, true_scale_axes)

SPAN = 1.38            # of the line of action between the discs, drawn apart, in R_b1 + R_b2
PLATES = (0.40, 0.86)  # ends of the contacts on it
LANE = 0.075           # half the distance of two contacts
TURNS = 4
MASS, MASS_WIDTH = numpy.array([0.72, -0.55]), 0.2  # of the reduced model: middle of the left side


class Disc(NamedTuple):
    """A gear as a disc on its base circle; `towards` the line of action: 1 up, -1 down."""
    centre: numpy.ndarray
    radius: float
    towards: int
    colour: str
    number: int


def draw_spring(axes, frame, begin, end, width, colour):
    """A zigzag with an arrow across: a spring that is not linear."""
    zigzag = numpy.concatenate([[0, 0.1], 0.1 + 0.8 * (numpy.arange(2 * TURNS) + 0.5) / (2 * TURNS), [0.9, 1]])
    across = 0.5 * width * numpy.concatenate([[0, 0], numpy.resize([1, -1], 2 * TURNS), [0, 0]])
    plot_line(axes, frame.at(begin + (end - begin) * zigzag, across), color=colour, linewidth=1.3)
    middle, reach = 0.5 * (begin + end), 0.26 * (end - begin)
    arrow(axes, frame.at(middle - reach, -0.9 * width), frame.at(middle + reach, 0.9 * width), color=colour,
          linewidth=0.9)


def draw_film_element(axes, frame, begin, end, width, colour):
    """A dashpot filled with oil."""
    length = end - begin
    bottom, mouth, piston = begin + 0.2 * length, begin + 0.8 * length, begin + 0.55 * length
    sides = 0.5 * width * numpy.array([1, 1, -1, -1])
    oil = frame.at([piston, bottom, bottom, piston], sides)
    axes.fill(oil[:, 0], oil[:, 1], color=GREEN, alpha=OIL_SHADE, linewidth=0)
    plot_line(axes, frame.at([mouth, bottom, bottom, mouth], sides), color=colour, linewidth=1.3)
    plot_line(axes, frame.at([piston, piston], 0.84 * sides[[0, 2]]), color=colour, linewidth=1.8)
    for span in ((begin, bottom), (piston, end)):
        plot_line(axes, frame.at(span, 0), color=colour, linewidth=1.3)


def draw_contacts(axes, frame, begin, end):
    """Contacts side by side between two plates: each an elastic spring and a film, one behind the other."""
    middle = 0.5 * (begin + end)
    for across, colour in ((-LANE, GREY), (LANE, DARK)):
        lane = Frame(frame.at(0, across), frame.along)
        draw_spring(axes, lane, begin, middle, 0.7 * LANE, colour)
        draw_film_element(axes, lane, middle, end, 0.9 * LANE, colour)
    for plate in (begin, end):
        plot_line(axes, frame.at([plate, plate], [-1.7 * LANE, 1.7 * LANE]), linewidth=1.8)


def draw_turn(axes, disc, reach, clockwise, text, shift):
    """A curved arrow on the outer side of a disc."""
    side = 180 if disc.towards > 0 else 0
    angles = numpy.radians([side + 35, side - 35] if clockwise else [side - 35, side + 35])
    arrow(axes, *polar(disc.centre, reach * disc.radius, angles), color=disc.colour, linewidth=1.4,
          connectionstyle=f"arc3,rad={-0.315 if clockwise else 0.315}")
    label(axes, polar(disc.centre, reach * disc.radius, angles[0]), text, shift)


def draw_disc(axes, disc):
    """The driving torque turns the pinion; the torque on the wheel holds it back."""
    axes.add_patch(pyplot.Circle(disc.centre, disc.radius, facecolor=disc.colour, alpha=BODY_SHADE, linewidth=0))
    plot_circle(axes, disc.centre, disc.radius, color=disc.colour, linewidth=1.4)
    axes.plot(*disc.centre, marker="o", markersize=4, color=disc.colour)
    plot_line(axes, [disc.centre, disc.centre + [0, disc.towards * disc.radius]], color=disc.colour, linewidth=0.8)
    label(axes, disc.centre + [0, 0.5 * disc.towards * disc.radius], f"$R_{{b{disc.number}}}$", (14, 0))
    label(axes, disc.centre, f"$I_{{g{disc.number}}}$", (0, -12 * disc.towards))
    draw_turn(axes, disc, 0.5, disc.towards > 0, rf"$\varphi_{disc.number}$", (0, -9))
    draw_turn(axes, disc, 1.08, True, f"$T_{{g{disc.number}}}$", (-6, -9) if disc.towards > 0 else (8, 9))


def draw_reduced_pair(axes):
    """The pair in one coordinate: a mass pressed against the contacts."""
    frame = Frame(MASS, numpy.array([1.0, 0.0]))
    begin = MASS_WIDTH + 0.1
    wall = begin + PLATES[1] - PLATES[0]
    axes.add_patch(pyplot.Rectangle(frame.at(0, -0.6 * MASS_WIDTH), MASS_WIDTH, 1.2 * MASS_WIDTH, facecolor=PALE,
                                    edgecolor=DARK))
    axes.add_patch(pyplot.Rectangle(frame.at(wall, -2 * LANE), 0.03, 4 * LANE, facecolor="none", edgecolor=DARK,
                                    hatch="////", linewidth=0))
    label(axes, frame.at(0.5 * MASS_WIDTH), "$m_{ge}$")
    draw_contacts(axes, frame, begin, wall)
    plot_line(axes, frame.at([MASS_WIDTH, begin]))
    arrow(axes, frame.at(-0.2), frame.at(0), linewidth=1.6)
    label(axes, frame.at(-0.1), r"$w^* = \dfrac{T_{g1}}{R_{b1}}$", (-12, 22))
    arrow(axes, frame.at(0.1, 0.8 * MASS_WIDTH), frame.at(0.26, 0.8 * MASS_WIDTH), linewidth=1.6)
    label(axes, frame.at(0.26, 0.8 * MASS_WIDTH), "$x_g$", (10, 0))
    label(axes, frame.at(-0.2, -0.24), r"the same in one coordinate:  $m_{ge}\,\ddot x_g = w^* - \sum_k w_k$,   "
          r"$\dfrac{1}{m_{ge}} = \dfrac{R_{b1}^2}{I_{g1}} + \dfrac{R_{b2}^2}{I_{g2}}$", (0, -6), ha="left")


def draw_pair(summary):
    """Figure 1: gears as discs on their base circles, pressed together along the line of action."""
    need_gears(summary)
    radii = numpy.array([summary["base_radius_pinion"], summary["base_radius_wheel"]])
    radii = radii / radii.sum()
    figure = pyplot.figure(figsize=(8, 6.6), constrained_layout=True)
    axes = true_scale_axes(figure, 111)
    draw_disc(axes, Disc(numpy.array([0.0, -radii[0]]), radii[0], 1, BLUE, 1))
    draw_disc(axes, Disc(numpy.array([SPAN, radii[1]]), radii[1], -1, VERMILLION, 2))
    draw_contacts(axes, Frame(numpy.zeros(2), numpy.array([1.0, 0.0])), *PLATES)
    for end, plate in zip((0.0, SPAN), PLATES):
        plot_line(axes, [(end, 0), (plate, 0)])
    for start, text, across in ((0.14, r"$R_{b1}\varphi_1$", 12), (1.05, r"$R_{b2}\varphi_2$", -12)):
        arrow(axes, (start, 0), (start + 0.15, 0), linewidth=1.8)
        label(axes, (start + 0.075, 0), text, (0, across))
    dimension(axes, (PLATES[0], -1.7 * LANE), (PLATES[1], -1.7 * LANE), "$h_0$", across=-0.5 * LANE)
    pointed_label(axes, (PLATES[0] + 0.12, 1.3 * LANE), "elastic teeth", (-36, 34))
    pointed_label(axes, (PLATES[0] + 0.31, 1.4 * LANE), "oil film", (-10, 32))
    label(axes, (PLATES[0], -0.24), "one branch a contact; all share $h_0$", ha="left")
    label(axes, (-0.4, 0.6), "transmission error:\n"
          r"$x_g = R_{b1}\varphi_1 - R_{b2}\varphi_2 = -h_0$" "\n\n"
          "$h_0 = 0$: rigid teeth would just touch\n$h_0 < 0$: teeth pressed together\n$h_0 > 0$: teeth apart",
          ha="left", linespacing=1.5)
    draw_reduced_pair(axes)
    return figure
