"""Figure 4: crowned teeth, the equivalent body, the domain of computation, and a section through film and pressure."""
from studies.common.gears import need_gears
from studies.common.plotting import BLUE, DARK, GREEN, GREY, PALE, VERMILLION, numpy, pyplot
from studies.common.sketching import (BODY_SHADE, OIL_SHADE, SMALL, arrow, dimension, label, plot_line, show_window,
                                      true_scale_axes)

CROWN = 0.13           # of half the face width, in the sketch of two teeth
FOOT = 0.6             # height of a tooth there
ELLIPSE = (0.5, 1.15)  # half-axes under the sketched paraboloid
STRETCH = 1.5          # of the paraboloid along y
LEVELS = (0.5, 1.05)   # heights of its contour lines
DEPTH = 0.55 * numpy.array([numpy.cos(0.7), numpy.sin(0.7)])  # of its y axis on paper
SIZE = 0.72           # of the body on paper
SKETCH_WINDOW = ((0, -0.15), (1.75, 1.15))
PLANE_SHOWN = 0.3      # thickness of the plane under the film, in a^2/R_x

# The paper's Table 1: (inlet edge, outlet edge, half width) in units of a, a, b.
LOW_LOAD = 200  # M
LONG_DOMAIN, SHORT_DOMAIN = (-4.5, 1.5, 3.0), (-2.083, 1.25, 1.1)
QUADRATURE_POINTS = 2000


def drawn_domain(summary):
    """x_min, x_max and half the width, in a, a, b."""
    return LONG_DOMAIN if summary["M"] < LOW_LOAD else SHORT_DOMAIN


def film_scale(summary):
    """The unit of H in m."""
    return summary["a"] ** 2 / summary["R_x"]


def dry_gap(summary, X):
    """Gap of the dry Hertz contact along y = 0, lengths in a, heights in a^2/R_x.

    The deformation is proportional to Int (1 - X^2/(1+s)) / sqrt((1+s) (1/kappa^2+s) s) ds over s from the confocal
    ellipse through X on; here s = begin + tan(t)^2.
    """
    begin = numpy.maximum(X ** 2 - 1, 0)[:, None]
    t = (numpy.arange(QUADRATURE_POINTS) + 0.5) / QUADRATURE_POINTS * 0.5 * numpy.pi
    s = begin + numpy.tan(t) ** 2
    integrand = (1 - X[:, None] ** 2 / (1 + s)) / numpy.sqrt((1 + s) * (summary["kappa"] ** -2 + s) * s)
    deformation = (integrand * 2 * numpy.tan(t) / numpy.cos(t) ** 2).sum(axis=1)
    approach = summary["hertz_approach"] / film_scale(summary)
    return X ** 2 / 2 + approach * (deformation / deformation[abs(X).argmin()] - 1)


def draw_crowned_teeth(axes):
    """Two teeth seen along the motion of the oil, crowning exaggerated."""
    y = numpy.linspace(-1, 1, 101)
    for side, colour, name, number in ((-1, BLUE, "pinion", 1), (1, VERMILLION, "wheel", 2)):
        crown = side * CROWN * y ** 2
        axes.fill_between(y, crown, side * FOOT, color=colour, alpha=BODY_SHADE, linewidth=0)
        plot_line(axes, [(-1, side * FOOT), *zip(y, crown), (1, side * FOOT)], color=colour, linewidth=1.5)
        label(axes, (-0.62, 0.7 * side * FOOT), name, color=colour)
        arrow(axes, (0.2, 0.8 * side * FOOT), (0.45, side * CROWN * 0.45 ** 2), color=colour)
        label(axes, (0.2, 0.8 * side * FOOT), f"$R_{{{number}y}}$", (-12, 0))
        plot_line(axes, [(1, side * CROWN), (1.35, side * CROWN)], color=GREY, linewidth=0.6)
        arrow(axes, (1.25, side * (CROWN + 0.2)), (1.25, side * CROWN), linewidth=0.8)
        label(axes, (1.25, side * (CROWN + 0.2)), f"mag$_{number}$", (4, 7 * side))
    plot_line(axes, [(-1.35, 0), (1.35, 0)], color=GREY, linewidth=0.8)
    dimension(axes, (-1, -FOOT), (1, -FOOT), "$F_w$", across=-0.16)
    label(axes, (0, -1.08), r"$R_{iy} = F_w^2/(8\,\mathrm{mag}_i)$,   $1/R_y = 1/R_{1y} + 1/R_{2y}$")
    show_window(axes, *SKETCH_WINDOW)


def oblique(x, y, z):
    """Points of space on paper: x to the right, z up, y into the depth."""
    return numpy.stack(numpy.broadcast_arrays(SIZE * (x + DEPTH[0] * y), SIZE * (z + DEPTH[1] * y) - 0.25), axis=-1)


def draw_paraboloid(axes):
    """The equivalent body on a plane, above the ellipse of contact."""
    plane = oblique(numpy.array([-1.25, 1.25, 1.25, -1.25, -1.25]), numpy.array([-1.6, -1.6, 1.6, 1.6, -1.6]), 0)
    axes.fill(plane[:, 0], plane[:, 1], color=PALE, alpha=0.5)
    plot_line(axes, plane, color=GREY, linewidth=0.8)
    turn = numpy.linspace(0, 2 * numpy.pi, 200)
    ellipse = oblique(ELLIPSE[0] * numpy.cos(turn), ELLIPSE[1] * numpy.sin(turn), 0)
    axes.fill(ellipse[:, 0], ellipse[:, 1], color=GREEN, alpha=OIL_SHADE)
    for end, text, shift in (((1.7, 0, 0), "$x$", (7, 0)), ((0, -2.2, 0), "$y$", (-5, -5))):
        arrow(axes, oblique(0.0, 0.0, 0.0), oblique(*end), linewidth=0.9)
        label(axes, oblique(*end), text, shift)
    for height in LEVELS:
        radius = numpy.sqrt(height)
        plot_line(axes, oblique(radius * numpy.cos(turn), STRETCH * radius * numpy.sin(turn), height), color=GREY,
                  linewidth=0.8)
    reach = numpy.linspace(-1, 1, 101) * numpy.sqrt(LEVELS[-1])
    across, along = oblique(reach, 0, reach ** 2), oblique(0, STRETCH * reach, reach ** 2)
    plot_line(axes, across, color=BLUE, linewidth=1.6)
    plot_line(axes, along, color=VERMILLION, linewidth=1.6)
    label(axes, across[0], "$R_x$", (-10, 0), color=BLUE)
    label(axes, along[-1], "$R_y$", (11, 3), color=VERMILLION)
    label(axes, (0, -1.08), r"$1/R_x = 1/R_{1x} + 1/R_{2x}$")
    show_window(axes, *SKETCH_WINDOW)


def draw_domain(axes, summary):
    """The domain and the ellipse of contact at true scale; y to the right, the motion of the oil up."""
    x_min, x_max, y_half = drawn_domain(summary)
    a, b = 1.0, 1.0 / summary["kappa"]
    turn = numpy.linspace(0, 2 * numpy.pi, 400)
    ellipse = numpy.stack([b * numpy.sin(turn), a * numpy.cos(turn)], axis=1)
    axes.fill(ellipse[:, 0], ellipse[:, 1], color=GREEN, alpha=OIL_SHADE)
    plot_line(axes, ellipse, color=GREEN)
    plot_line(axes, [(0, a), (0, 0), (b, 0)], color=DARK, linewidth=0.8)
    axes.axis("on")
    axes.set_xlim(-y_half * b, y_half * b)
    axes.set_ylim(x_min, x_max)
    axes.set_xticks([-b, 0, b], ["$-b$", "$y = 0$", "$b$"], fontsize=SMALL)
    axes.set_yticks([-a, 0, a], ["$-a$", "$x = 0$", "$a$"], fontsize=SMALL)
    edges, sides = axes.secondary_yaxis("right"), axes.secondary_xaxis("top")
    edges.set_yticks([x_min, x_max], [f"${x_min:g}\\,a$ inlet", f"${x_max:g}\\,a$ outlet"], fontsize=SMALL)
    sides.set_xticks([-y_half * b, y_half * b], [f"$-{y_half:g}\\,b$", f"${y_half:g}\\,b$"], fontsize=SMALL)
    for place in (-0.55 * b, 0.55 * b):
        arrow(axes, (place, x_min + 0.1), (place, -1.05 * a), linewidth=1.6)
    axes.set_xlabel("oil enters from below with $u_m$; $p = 0$ on the boundary", fontsize=SMALL)


def draw_pressure(axes, summary):
    """Hertz's, along y = 0."""
    x_min, x_max, _ = drawn_domain(summary)
    X = numpy.linspace(x_min, x_max, 801)
    pressure = numpy.sqrt(numpy.maximum(1 - X ** 2, 0))
    axes.fill_between(X, pressure, color=BLUE, alpha=BODY_SHADE, linewidth=0)
    axes.plot(X, pressure, color=BLUE)
    axes.set_ylim(0, 1.2)
    axes.set_ylabel("$p/p_h$", fontsize=SMALL)
    axes.set_title(rf"section along $y = 0$; Hertz pressure, $p_h = {1e-9 * summary['p_hertz']:.2f}$ GPa",
                   fontsize=SMALL)
    axes.tick_params(labelbottom=False)


def draw_film(axes, summary):
    """The gap of the dry contact, lifted by the central film that Hamrock and Dowson's formula gives."""
    x_min, x_max, _ = drawn_domain(summary)
    X = numpy.linspace(x_min, x_max, 801)
    central = summary["hamrock_dowson_h_central"] / film_scale(summary)
    surface, H_0 = dry_gap(summary, X) + central, central - summary["hertz_approach"] / film_scale(summary)
    top = 1.1 * surface.max()
    axes.fill_between(X, surface, top, color=VERMILLION, alpha=BODY_SHADE, linewidth=0)
    axes.fill_between(X, 0, surface, color=GREEN, alpha=OIL_SHADE, linewidth=0)
    axes.fill_between(X, -PLANE_SHOWN, 0, color=GREY, alpha=OIL_SHADE, linewidth=0)
    axes.plot(X, surface, color=VERMILLION)
    axes.plot(X, H_0 + X ** 2 / 2, color=DARK, linestyle="--", linewidth=1)
    axes.axhline(0, color=DARK, linewidth=1)
    inlet = 0.2 * surface[0]
    arrow(axes, (x_min + 0.1, inlet), (x_min + 0.4, inlet), linewidth=1.6)
    label(axes, (x_min + 0.4, inlet), "$u_m$", (10, 0))
    arrow(axes, (0, 0), (0, H_0), linewidth=1.2)
    label(axes, (0, 0.6 * H_0), "$H_0 = -x_g R_x/a^2$", (6, 0), ha="left")
    label(axes, (x_min + 0.1, 0.95 * H_0), "dashed: undeformed, $H_0 + X^2/2$", ha="left")
    label(axes, (0, 0.6 * top), "equivalent body, deformed")
    label(axes, (-0.5, -0.5 * PLANE_SHOWN), "plane")
    axes.set_xlim(x_min, x_max)
    axes.set_ylim(1.15 * H_0, top)
    axes.set_ylabel("$H = h\\,R_x/a^2$", fontsize=SMALL)
    axes.set_xlabel("$X = x/a$", fontsize=SMALL)


def draw_contact(summary):
    """Figure 4."""
    need_gears(summary)
    x_min, x_max, y_half = drawn_domain(summary)
    domain_height = 6.4 * 0.5 * (x_max - x_min) * summary["kappa"] / y_half  # inches
    figure = pyplot.figure(figsize=(8, 7.4 + domain_height), constrained_layout=True)
    grid = figure.add_gridspec(4, 2, height_ratios=[2.3, domain_height, 0.9, 2.0])
    draw_crowned_teeth(true_scale_axes(figure, grid[0, 0], "crowned teeth along their width (exaggerated)"))
    draw_paraboloid(true_scale_axes(figure, grid[0, 1], "equivalent paraboloid on a plane"))
    draw_domain(true_scale_axes(figure, grid[1, :], f"usual domain for M = {summary['M']:.0f} and ellipse of contact, "
                          "at true scale"), summary)
    pressure = figure.add_subplot(grid[2, :])
    film = figure.add_subplot(grid[3, :], sharex=pressure)
    draw_film(film, summary)
    draw_pressure(pressure, summary)
    figure.align_ylabels([pressure, film])
    for axes in (pressure, film):
        axes.tick_params(labelsize=SMALL - 1)
    return figure
