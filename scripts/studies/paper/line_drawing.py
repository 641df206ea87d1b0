"""Figure 2: teeth, circles and the line of action at true scale, from the geometry that `gearfilm info` tells."""
from studies.common.gears import DrawnGears, gear_pair
from studies.common.plotting import BLUE, DARK, GREEN, GREY, VERMILLION, numpy, pyplot
from studies.common.sketching import (BODY_SHADE, ON_WHITE, SMALL, Frame, arrow, dimension, label, plot_circle,
                                      plot_line, polar, show_window, true_scale_axes)

TEETH_DRAWN = 12  # on either side of the one in contact
WINDOW = 0.575    # height of a panel over its width
CIRCLES = (("tip", "tip circles $R_a$", ":"), ("working", "pitch circles", "--"), ("base", "base circles $R_b$", "-."))


def draw_meshing_teeth(axes, pair, xi):
    """Both gears with a contact at xi, their circles, and the line of action between the base circles."""
    DrawnGears(axes, pair, TEETH_DRAWN).turn(xi)
    for gear, colour in ((pair.pinion, BLUE), (pair.wheel, VERMILLION)):
        for radius, _, line in CIRCLES:
            plot_circle(axes, gear.centre, getattr(gear, radius), color=colour, linewidth=0.9, linestyle=line)
    first, second = pair.curvatures(0.0)
    plot_line(axes, pair.at([-first, second]), linewidth=1.2)


def mark_point(axes, point, text="", shift=(0, 0), colour=DARK, size=4):
    axes.plot(*point, marker="o", markersize=size, color=colour, zorder=5)
    label(axes, point, text, shift, **ON_WHITE)


def mark_pressure_angle(axes, pair, radius):
    """Between the common tangent of the pitch circles and the line of action."""
    plot_line(axes, [(-0.2 * radius, 0), (1.25 * radius, 0)], color=GREY, linewidth=0.8)
    plot_circle(axes, (0, 0), radius, (0, pair.pressure_angle), linewidth=0.8)
    label(axes, polar(numpy.zeros(2), radius, 0.5 * pair.pressure_angle), r"$\alpha'$", (9, 0), **ON_WHITE)


def draw_speed(axes, gear, colour, text, half_angle):
    """A curved arrow inside the base circle, away from the middle; a negative half angle turns clockwise."""
    side = numpy.sign(-gear.centre[1])
    middle = side * (0.5 * numpy.pi + 3 * half_angle)
    radius = 0.92 * gear.base
    arrow(axes, *polar(gear.centre, radius, middle + numpy.array([-half_angle, half_angle])), color=colour,
          linewidth=1.4, connectionstyle=f"arc3,rad={0.5 * numpy.tan(half_angle)}")
    label(axes, polar(gear.centre, radius, middle - 1.5 * half_angle), text)


def draw_whole_line(axes, pair, xi):
    """From base circle to base circle, with the radii of curvature of a contact."""
    draw_meshing_teeth(axes, pair, xi)
    first, second = pair.curvatures(0.0)
    reach = first + second
    for end, gear, name, shift in ((-first, pair.pinion, "$N_1$", (-12, 6)), (second, pair.wheel, "$N_2$", (12, -6))):
        plot_line(axes, [gear.centre, pair.at(end)], color=GREY, linewidth=0.8)
        mark_point(axes, pair.at(end), name, shift)
    dimension(axes, pair.at(-first), pair.at(xi), "$R_{1x}$", across=-0.075 * reach)
    dimension(axes, pair.at(xi), pair.at(second), "$R_{2x}$", across=0.075 * reach)
    mark_pressure_angle(axes, pair, 0.8 * second)
    draw_speed(axes, pair.pinion, BLUE, r"$\Omega_1$", -0.05 * reach / pair.pinion.base)
    draw_speed(axes, pair.wheel, VERMILLION, r"$\Omega_2$", 0.05 * reach / pair.wheel.base)
    mark_point(axes, pair.at(xi), colour=GREEN, size=6)
    mark_point(axes, (0, 0), "P", (-2, 10))
    half_width = max(reach * (0.5 * pair.direction + 0.1) / [1, WINDOW])
    show_window(axes, pair.at(0.5 * (second - first)), half_width * numpy.array([1, WINDOW]))


def draw_path_of_contact(axes, pair, xi):
    """The part of the line of action between the tip circles, with the contacts on it."""
    draw_meshing_teeth(axes, pair, xi)
    frame = Frame(numpy.zeros(2), pair.direction)
    pitch = pair.base_pitch
    for place, text in ((pair.entry, r"$\xi_s$: enters"), (0.0, r"$\xi = 0$"), (pair.exit, r"$\xi_e$: leaves")):
        plot_line(axes, frame.at([place, place], [-0.2 * pitch, 0.06 * pitch]))
        label(axes, frame.at(place, -0.24 * pitch), text, (2, 0), ha="left", **ON_WHITE)
    contacts = numpy.arange(xi, pair.entry, -pitch)
    for place in contacts:
        mark_point(axes, pair.at(place), colour=GREEN, size=7)
    if contacts.size > 1:
        dimension(axes, pair.at(contacts[1]), pair.at(xi), "$p_b$", across=0.25 * pitch)
    arrow(axes, frame.at(pair.exit + 0.12 * pitch), frame.at(pair.exit + 0.32 * pitch), color=GREEN, linewidth=2)
    label(axes, frame.at(pair.exit + 0.22 * pitch), r"$\dot\xi = \Omega_1 R_{b1}$", (-12, 14), **ON_WHITE)
    show_window(axes, numpy.zeros(2), 0.95 * (pair.exit - pair.entry) * numpy.array([1, WINDOW]))


def add_circle_legend(axes):
    """What the lines and colours are, below the axes."""
    handles = [pyplot.Line2D([], [], color=DARK, linewidth=0.9, linestyle=line) for _, _, line in CIRCLES]
    handles += [pyplot.Rectangle((0, 0), 1, 1, facecolor=colour, alpha=2 * BODY_SHADE) for colour in (BLUE, VERMILLION)]
    axes.legend(handles, [*(name for _, name, _ in CIRCLES), "pinion, drives", "wheel"], loc="upper center",
                bbox_to_anchor=(0.5, 0.0), ncol=5, frameon=False, fontsize=SMALL)


def draw_line_of_action(summary):
    """Figure 2: the pair of the case at true scale, in the middle of the time that two pairs of teeth share."""
    pair = gear_pair(summary)
    xi = pair.exit - 0.5 * (pair.exit - pair.entry - pair.base_pitch)
    figure = pyplot.figure(figsize=(8, 9.6), constrained_layout=True)
    grid = figure.add_gridspec(2, 1)
    whole = true_scale_axes(figure, grid[0], r"radii of curvature $R_{1x}$, $R_{2x}$ of a contact (green); pitch point P; "
                      rf"working pressure angle $\alpha'$ = {summary['working_pressure_angle_deg']:.2f}°")
    path = true_scale_axes(figure, grid[1], rf"path of contact: $\xi_s = {pair.entry:.2f}$ mm, "
                     rf"$\xi_e = {pair.exit:.2f}$ mm, base pitch $p_b = {pair.base_pitch:.2f}$ mm")
    draw_whole_line(whole, pair, xi)
    draw_path_of_contact(path, pair, xi)
    for axes in (whole, path):
        axes.axis("on")
        axes.set_xticks([])
        axes.set_yticks([])
    add_circle_legend(path)
    return figure
