"""Figure 2: teeth, circles and the line of action at true scale, from the geometry that `gearfilm info` tells."""
from typing import NamedTuple

from studies.common.plotting import BLUE, DARK, GREEN, GREY, VERMILLION, numpy, pyplot
from studies.paper.sketching import (BODY_SHADE, FONT, ON_WHITE, Frame, arrow, bare_axes, dimension, label, need_gears,
                                     plot_circle, plot_line, polar, show_window)

# Of teeth, what is no part of the model.
ROOT_CLEARANCE = 0.085  # of the base pitch
BACKLASH = 0.02         # of the pitch on the pitch circle
TEETH_DRAWN = 12  # on either side of the one in contact
FLANK_POINTS = 100
WINDOW = 0.575    # height of a panel over its width
CIRCLES = (("outer_radius", "outer circles $R_a$", ":"), ("pitch_radius", "pitch circles", "--"),
           ("base_radius", "base circles $R_b$", "-."))


class Gear(NamedTuple):
    """A gear where it is drawn, lengths in m."""
    centre: numpy.ndarray
    base_radius: float
    pitch_radius: float
    outer_radius: float
    root_radius: float
    teeth: int
    angle: float  # of the radius to the point where the line of action touches the base circle


class Mesh(NamedTuple):
    """A gear pair with its pitch point at the origin, the pinion below, driving to the right; lengths in m."""
    pinion: Gear
    wheel: Gear
    direction: numpy.ndarray  # unit vector in which contacts travel
    pressure_angle: float
    base_pitch: float
    entry: float
    exit: float

    def point(self, xi):
        return numpy.multiply.outer(xi, self.direction)

    def curvatures(self, xi):
        """R_1x and R_2x: from the base circles to the contact."""
        slope = numpy.tan(self.pressure_angle)
        return self.pinion.base_radius * slope + xi, self.wheel.base_radius * slope - xi


def mesh_of(summary):
    """The pair of `gearfilm info`. Teeth end at the outer circles, which bound the path of contact."""
    need_gears(summary)
    alpha, pitch = numpy.radians(summary["working_pressure_angle_deg"]), summary["base_pitch"]
    base = numpy.array([summary["base_radius_pinion"], summary["base_radius_wheel"]])
    last = base * numpy.tan(alpha) + [summary["xi_exit"], -summary["xi_entry"]]  # curvature at the tips
    outer = numpy.hypot(base, last)
    working = base / numpy.cos(alpha)
    root = working.sum() - outer[::-1] - ROOT_CLEARANCE * pitch
    gears = [Gear(numpy.array([0.0, side * working[n]]), base[n], working[n], outer[n], root[n],
                  round(2 * numpy.pi * base[n] / pitch), alpha - 0.5 * side * numpy.pi)
             for n, side in ((0, -1), (1, 1))]
    return Mesh(*gears, numpy.array([numpy.cos(alpha), numpy.sin(alpha)]), alpha, pitch, summary["xi_entry"],
                summary["xi_exit"])


def flank(gear, curvature):
    """Radii and polar angles of the driving flank that the line of action meets at this radius of curvature.

    A thread unwound from the base circle by the angle `roll` ends on the involute, at the right angle to it.
    """
    ends = numpy.array([gear.root_radius, gear.outer_radius]) / gear.base_radius
    roll = numpy.linspace(*numpy.sqrt(numpy.maximum(ends ** 2 - 1, 0)), FLANK_POINTS)
    begin = gear.angle - curvature / gear.base_radius
    return gear.base_radius * numpy.hypot(1, roll), begin + roll - numpy.arctan(roll)


def flank_points(gear, curvature):
    """The same flank as points, from root to tip."""
    return polar(gear.centre, *flank(gear, curvature))


def tooth(gear, curvature):
    """Radii and polar angles around one pitch: driving flank, tip, back, root.

    The tooth is half a pitch thick on the pitch circle, but for the backlash.
    """
    radius, angle = flank(gear, curvature)
    pitch = 2 * numpy.pi / gear.teeth
    middle = numpy.interp(gear.pitch_radius, radius, angle) + 0.25 * (1 - BACKLASH) * pitch
    tip = numpy.linspace(angle[-1], 2 * middle - angle[-1], 10)
    root = numpy.linspace(2 * middle - angle[0], angle[0] + pitch, 10)
    radii = [radius, numpy.full(tip.size, gear.outer_radius), radius[::-1], numpy.full(root.size, gear.root_radius)]
    return numpy.concatenate(radii), numpy.concatenate([angle, tip, 2 * middle - angle[::-1], root])


def draw_teeth(axes, gear, curvature, colour):
    """Some teeth of a gear, one of them in contact at this radius of curvature."""
    radius, angle = tooth(gear, curvature)
    count = min(TEETH_DRAWN, gear.teeth // 2)
    turns = 2 * numpy.pi / gear.teeth * numpy.arange(-count, count + 1)
    outline = polar(gear.centre, numpy.tile(radius, turns.size), numpy.add.outer(turns, angle).ravel())
    body = numpy.concatenate([outline, [gear.centre]])
    axes.fill(body[:, 0], body[:, 1], color=colour, alpha=BODY_SHADE, linewidth=0)
    plot_line(axes, outline, color=colour, linewidth=1.3)


def draw_meshing_teeth(axes, mesh, xi):
    """Both gears with a contact at xi, their circles, and the line of action between the base circles."""
    for gear, curvature, colour in zip((mesh.pinion, mesh.wheel), mesh.curvatures(xi), (BLUE, VERMILLION)):
        draw_teeth(axes, gear, curvature, colour)
        for radius, _, line in CIRCLES:
            plot_circle(axes, gear.centre, getattr(gear, radius), color=colour, linewidth=0.9, linestyle=line)
    first, second = mesh.curvatures(0.0)
    plot_line(axes, mesh.point(numpy.array([-first, second])), linewidth=1.2)


def mark_point(axes, point, text="", shift=(0, 0), colour=DARK, size=4):
    axes.plot(*point, marker="o", markersize=size, color=colour, zorder=5)
    label(axes, point, text, shift, **ON_WHITE)


def mark_pressure_angle(axes, mesh, radius):
    """Between the common tangent of the pitch circles and the line of action."""
    plot_line(axes, [(-0.2 * radius, 0), (1.25 * radius, 0)], color=GREY, linewidth=0.8)
    plot_circle(axes, (0, 0), radius, (0, mesh.pressure_angle), linewidth=0.8)
    label(axes, polar(numpy.zeros(2), radius, 0.5 * mesh.pressure_angle), r"$\alpha'$", (9, 0), **ON_WHITE)


def draw_speed(axes, gear, colour, text, half_angle):
    """A curved arrow inside the base circle, away from the middle; a negative half angle turns clockwise."""
    side = numpy.sign(-gear.centre[1])
    middle = side * (0.5 * numpy.pi + 3 * half_angle)
    radius = 0.92 * gear.base_radius
    arrow(axes, *polar(gear.centre, radius, middle + numpy.array([-half_angle, half_angle])), color=colour,
          linewidth=1.4, connectionstyle=f"arc3,rad={0.5 * numpy.tan(half_angle)}")
    label(axes, polar(gear.centre, radius, middle - 1.5 * half_angle), text)


def draw_whole_line(axes, mesh, xi):
    """From base circle to base circle, with the radii of curvature of a contact."""
    draw_meshing_teeth(axes, mesh, xi)
    first, second = mesh.curvatures(0.0)
    reach = first + second
    for end, gear, name, shift in ((-first, mesh.pinion, "$N_1$", (-12, 6)), (second, mesh.wheel, "$N_2$", (12, -6))):
        plot_line(axes, [gear.centre, mesh.point(end)], color=GREY, linewidth=0.8)
        mark_point(axes, mesh.point(end), name, shift)
    dimension(axes, mesh.point(-first), mesh.point(xi), "$R_{1x}$", across=-0.075 * reach)
    dimension(axes, mesh.point(xi), mesh.point(second), "$R_{2x}$", across=0.075 * reach)
    mark_pressure_angle(axes, mesh, 0.8 * second)
    draw_speed(axes, mesh.pinion, BLUE, r"$\Omega_1$", -0.05 * reach / mesh.pinion.base_radius)
    draw_speed(axes, mesh.wheel, VERMILLION, r"$\Omega_2$", 0.05 * reach / mesh.wheel.base_radius)
    mark_point(axes, mesh.point(xi), colour=GREEN, size=6)
    mark_point(axes, (0, 0), "P", (-2, 10))
    half_width = max(reach * (0.5 * mesh.direction + 0.1) / [1, WINDOW])
    show_window(axes, mesh.point(0.5 * (second - first)), half_width * numpy.array([1, WINDOW]))


def draw_path_of_contact(axes, mesh, xi):
    """The part of the line of action between the outer circles, with the contacts on it."""
    draw_meshing_teeth(axes, mesh, xi)
    frame = Frame(numpy.zeros(2), mesh.direction)
    pitch = mesh.base_pitch
    for place, text in ((mesh.entry, r"$\xi_s$: enters"), (0.0, r"$\xi = 0$"), (mesh.exit, r"$\xi_e$: leaves")):
        plot_line(axes, frame.at([place, place], [-0.2 * pitch, 0.06 * pitch]))
        label(axes, frame.at(place, -0.24 * pitch), text, (2, 0), ha="left", **ON_WHITE)
    contacts = numpy.arange(xi, mesh.entry, -pitch)
    for place in contacts:
        mark_point(axes, mesh.point(place), colour=GREEN, size=7)
    if contacts.size > 1:
        dimension(axes, mesh.point(contacts[1]), mesh.point(xi), "$p_b$", across=0.25 * pitch)
    arrow(axes, frame.at(mesh.exit + 0.12 * pitch), frame.at(mesh.exit + 0.32 * pitch), color=GREEN, linewidth=2)
    label(axes, frame.at(mesh.exit + 0.22 * pitch), r"$\dot\xi = \Omega_1 R_{b1}$", (-12, 14), **ON_WHITE)
    show_window(axes, numpy.zeros(2), 0.95 * (mesh.exit - mesh.entry) * numpy.array([1, WINDOW]))


def add_circle_legend(axes):
    """What the lines and colours are, below the axes."""
    handles = [pyplot.Line2D([], [], color=DARK, linewidth=0.9, linestyle=line) for _, _, line in CIRCLES]
    handles += [pyplot.Rectangle((0, 0), 1, 1, facecolor=colour, alpha=2 * BODY_SHADE) for colour in (BLUE, VERMILLION)]
    axes.legend(handles, [*(name for _, name, _ in CIRCLES), "pinion, drives", "wheel"], loc="upper center",
                bbox_to_anchor=(0.5, 0.0), ncol=5, frameon=False, fontsize=FONT)


def draw_line_of_action(summary):
    """Figure 2: the pair of the case at true scale, in the middle of the time that two pairs of teeth share."""
    mesh = mesh_of(summary)
    xi = mesh.exit - 0.5 * (mesh.exit - mesh.entry - mesh.base_pitch)
    figure = pyplot.figure(figsize=(8, 9.6), constrained_layout=True)
    grid = figure.add_gridspec(2, 1)
    whole = bare_axes(figure, grid[0], r"radii of curvature $R_{1x}$, $R_{2x}$ of a contact (green); pitch point P; "
                      rf"working pressure angle $\alpha'$ = {summary['working_pressure_angle_deg']:.2f}°")
    path = bare_axes(figure, grid[1], rf"path of contact: $\xi_s = {1e3 * mesh.entry:.2f}$ mm, "
                     rf"$\xi_e = {1e3 * mesh.exit:.2f}$ mm, base pitch $p_b = {1e3 * mesh.base_pitch:.2f}$ mm")
    draw_whole_line(whole, mesh, xi)
    draw_path_of_contact(path, mesh, xi)
    for axes in (whole, path):
        axes.axis("on")
        axes.set_xticks([])
        axes.set_yticks([])
    add_circle_legend(path)
    return figure
