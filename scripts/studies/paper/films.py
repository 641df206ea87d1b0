"""Figures 11 to 13: pressures, films and fields over the life of a contact in the periodic state."""
from studies.common.plotting import (BLUE, DARK, GREY, VERMILLION, add_grid, add_legend, fill, numpy, pyplot,
                                     read_summary)
from studies.paper import printed
from studies.paper.life import find_positions, read_fields, read_life

POSITION_AXIS = r"position $\xi$ of the contact [mm]"
SECTION_RANGE = ((0, 5.5), (0, 4))        # µm and GPa, of film and pressure in sections
MAP_LEVELS = numpy.linspace(1.7, 3.5, 37)  # µm, of the film in maps
MAP_WIDTH = 1.25                           # in half-axes a, of the maps on both sides of the middle


def mark_events(axes, life, labelled=False):
    """Light lines where the other contacts leave and enter."""
    for place, text in ((life.other_left, "elder\nleaves"), (life.other_entered, "next\nenters")):
        axes.axvline(1e3 * place, color=GREY, linewidth=0.8, linestyle="--", zorder=0)
        if labelled:
            axes.annotate(text, (1e3 * place, 0), xycoords=axes.get_xaxis_transform(), xytext=(3, 3),
                          textcoords="offset points", fontsize=7, color=DARK)


def mark_printed(axes, xi, value, text, shift=(6, 6)):
    """A number that the paper prints, as a cross at its place, in the axes' units."""
    axes.plot(xi, value, marker="x", markersize=7, markeredgewidth=1.8, color=DARK, linestyle="none", zorder=5)
    axes.annotate(text, (xi, value), xytext=shift, textcoords="offset points", fontsize=7, color=DARK)


def label_life(axes, quantity):
    """Names, legend and grid of an axes over the line of action."""
    axes.set_xlabel(POSITION_AXIS)
    axes.set_ylabel(quantity)
    add_legend(axes, *axes.get_legend_handles_labels())
    add_grid(axes)


def draw_pressures(folder):
    """Figure 11."""
    life = read_life(folder / "periodic")
    xi = 1e3 * life.rows["xi"]
    figure, axes = pyplot.subplots(figsize=(8, 4), constrained_layout=True)
    axes.plot(xi, 1e-9 * life.rows["p_max"], color=VERMILLION, linestyle="--", label="largest")
    axes.plot(xi, 1e-9 * life.rows["p_central"], color=BLUE, label="central")
    greatest = life.rows[life.rows["p_max"].argmax()]
    mark_printed(axes, 1e3 * greatest["xi"], 1e-9 * printed.LARGEST_PRESSURE, "paper: 3.28 GPa", shift=(10, -3))
    mark_events(axes, life, labelled=True)
    label_life(axes, "pressure [GPa]")
    return figure


def draw_films(folder):
    """Figure 12: films over the line of action, with sections along y = 0 at A to F."""
    life, fields = read_life(folder / "periodic"), read_fields(folder / "periodic")
    positions = find_positions(life)
    figure = pyplot.figure(figsize=(8, 8.5), constrained_layout=True)
    grid = figure.add_gridspec(3, 3, height_ratios=[1.5, 1, 1])
    axes = figure.add_subplot(grid[0, :])
    draw_film_history(axes, life, positions)
    pressure_axes = None
    for n, (name, position) in enumerate(positions.items()):
        panel = figure.add_subplot(grid[1 + n // 3, n % 3])
        pressure_axes = draw_section(panel, fields, name, position, pressure_axes)
        if n % 3 == 0:
            panel.set_ylabel("film [µm]", color=BLUE)
        if n % 3 == 2:
            pressure_axes.set_ylabel("pressure [GPa]", color=VERMILLION)
        if n >= 3:
            panel.set_xlabel("x [mm]")
    return figure


def draw_film_history(axes, life, positions):
    xi = 1e3 * life.rows["xi"]
    axes.plot(xi, 1e6 * life.rows["h_central"], color=BLUE, label="central")
    axes.plot(xi, 1e6 * life.rows["h_min"], color=VERMILLION, linestyle="--", linewidth=1, label="smallest")
    for name, position in positions.items():
        place = (1e3 * position.xi, 1e6 * position.film)
        axes.plot(*place, color=DARK, marker="o", markersize=4)
        axes.annotate(name, place, xytext=(0, 7), textcoords="offset points", ha="center", fontweight="bold")
    mark_printed(axes, 0, 1e6 * printed.PITCH_CENTRAL, "paper: 2.495", shift=(6, -10))
    mark_printed(axes, 0, 1e6 * printed.PITCH_SMALLEST, "paper: 2.127", shift=(6, -10))
    entered = xi[0]
    mark_printed(axes, entered, 1e6 * printed.ENTRY_CENTRAL, "paper: 2.2", shift=(6, -11))
    mark_printed(axes, entered, 1e6 * printed.ENTRY_SMALLEST, "paper: 1.9", shift=(6, -11))
    mark_events(axes, life, labelled=True)
    axes.margins(y=0.1)
    label_life(axes, "film [µm]")


def draw_section(axes, fields, name, position, beside):
    """Film and pressure along y = 0; the pressure on an axis of its own, shared with the section `beside`."""
    n, middle = fields.nearest(position.xi), abs(fields.y).argmin()
    x = 1e3 * fields.x
    axes.plot(x, 1e6 * fields.films[n, :, middle], color=BLUE)
    axes.set_ylim(SECTION_RANGE[0])
    pressure_axes = axes.twinx()
    if beside is not None:
        pressure_axes.sharey(beside)
    pressure_axes.plot(x, 1e-9 * fields.pressures[n, :, middle], color=VERMILLION, linestyle="--", linewidth=1)
    pressure_axes.set_ylim(SECTION_RANGE[1])
    axes.set_title(rf"{name}: $\xi$ = {1e3 * fields.xi[n]:.2f} mm", fontsize=9)
    add_grid(axes)
    return pressure_axes


def draw_maps(folder):
    """Figure 13: maps of the film at A to F, and the film along the centre line over the whole life."""
    pair = read_summary(folder / "info", "info")
    life, fields = read_life(folder / "periodic"), read_fields(folder / "periodic")
    figure = pyplot.figure(figsize=(8, 8.5), constrained_layout=True)
    grid = figure.add_gridspec(4, 2, height_ratios=[1, 1, 1, 2.2])
    panels = []
    for number, (name, position) in enumerate(find_positions(life).items()):
        axes = figure.add_subplot(grid[number // 2, number % 2])
        n = fields.nearest(position.xi)
        fill(axes, 1e3 * fields.y, 1e3 * fields.x, 1e6 * fields.films[n], MAP_LEVELS)
        axes.set_title(rf"{name}: $\xi$ = {1e3 * fields.xi[n]:.2f} mm", fontsize=9)
        axes.set_xlabel("y [mm]" if number >= 4 else "")
        panels.append(axes)
    panels.append(figure.add_subplot(grid[3, :]))
    filled = draw_centre_line(panels[-1], life, fields, pair)
    half = 1e3 * MAP_WIDTH * pair["a"]
    for axes in panels:
        axes.set_ylim(-half, half)
        axes.set_ylabel("x [mm]")
    figure.colorbar(filled, ax=panels, label="h [µm]", format="%.1f", shrink=0.6)
    return figure


def draw_centre_line(axes, life, fields, pair):
    """Film along y = 0 over the life, with paths of oil that is at the inlet when something happens to the load."""
    xi, x = 1e3 * fields.xi, 1e3 * fields.x
    filled = fill(axes, xi, x, 1e6 * fields.films[:, :, abs(fields.y).argmin()].T, MAP_LEVELS)
    for begin in (life.rows["xi"][0], life.other_left, life.other_entered):
        path = path_of_oil(pair, begin, fields.xi) - pair["a"]
        axes.plot(xi[fields.xi >= begin], 1e3 * path[fields.xi >= begin], color="white", linestyle="--", linewidth=1.2)
    axes.set_xlim(xi[0], xi[-1])
    axes.set_xlabel(POSITION_AXIS)
    axes.set_title("film along y = 0; dashed: oil that is at the inlet when a contact enters or leaves", fontsize=9)
    return filled


def path_of_oil(pair, begin, xi):
    """Way [m] of the oil through the contact while that travels from `begin` to xi.

    It moves with u_m = Omega_1 (R_b1 tan(alpha') + (1 - tau) xi/2), equation (19), the contact with Omega_1 R_b1.
    """
    radius = pair["base_radius_pinion"]
    growth = (1 - radius / pair["base_radius_wheel"]) / (4 * radius)
    return (numpy.tan(numpy.radians(pair["working_pressure_angle_deg"])) * (xi - begin)
            + growth * (xi ** 2 - begin ** 2))
