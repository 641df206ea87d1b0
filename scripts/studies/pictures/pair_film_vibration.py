"""A gear pair, the film of one of its contacts, and the vibration of the pair, side by side."""
from studies.common.plotting import BLUE, DARK, GREEN, GREY, PURPLE, VERMILLION, add_grid, numpy, pyplot
from studies.common.sketching import LARGE, SMALL, arrow, bare_axes, label, new_figure
from studies.pictures.film_map import LEVELS, film_colours
from studies.pictures.gears_in_mesh import draw_gears_in_mesh

from matplotlib.patches import ConnectionPatch, FancyArrowPatch, FancyBboxPatch  # after plotting

HEIGHT = 3.7        # inches
MOMENT = 35         # of the cycle: two contacts are in mesh
PERIODS = 2
TITLE_AT = 0.945
OIL = "#CFE3EE"
FRAME = (0.322, 0.012, 0.338, 0.888)  # of the film's panels, in the figure


def draw_gears(figure, pair, films):
    axes = bare_axes(figure, [0.005, 0.13, 0.295, 0.755])
    draw_gears_in_mesh(axes, pair.gears, (1.9, 0.4), (7.1, 8.4)).turn(films[0].xi)
    for film, colour in zip(films, (GREEN, PURPLE)):
        axes.plot(*pair.gears.at(film.xi), marker="o", markersize=7, color=colour, markeredgecolor="white", zorder=6)
    spot = pair.gears.at(films[0].xi)
    axes.add_patch(pyplot.Circle(spot, 1.25, facecolor="none", edgecolor=DARK, linewidth=1.6, zorder=7))
    for text, tone, height in (("wheel", VERMILLION, 0.96), ("pinion", BLUE, 0.04)):
        label(axes, (0, height), text, (5, 0), xycoords="axes fraction", ha="left")
        arrow(axes, (0.27, height), (0.42, height), xycoords="axes fraction", color=tone, linewidth=2)
    return axes, spot + [1.25, 0]


def finish(axes):
    axes.tick_params(labelsize=SMALL, pad=2)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    add_grid(axes)


def draw_film(figure, film):
    """The film over the contact, pressure and film along its middle, on one axis of x."""
    upper, pressure, gap = (figure.add_axes([0.4, bottom, 0.195, height])
                            for bottom, height in ((0.63, 0.2), (0.38, 0.19), (0.13, 0.19)))
    shades = upper.contourf(film.x, film.y, film.thickness.T, LEVELS, cmap=film_colours(), extend="both")
    bar = figure.colorbar(shades, figure.add_axes([0.604, 0.63, 0.01, 0.2]), ticks=LEVELS[::3])
    bar.ax.tick_params(labelsize=SMALL, pad=1, length=2)
    upper.set_ylabel("y [mm]", fontsize=SMALL, labelpad=1)
    upper.set_yticks([-2, 0, 2])
    upper.set_title("film [µm]", fontsize=SMALL, loc="right", pad=3)
    middle = abs(film.y).argmin()
    pressure.plot(film.x, film.pressure[:, middle], color=GREEN, linewidth=1.6)
    pressure.set_ylabel("pressure\n[GPa]", fontsize=SMALL, labelpad=2)
    pressure.set_ylim(0, 3.6)
    gap.fill_between(film.x, film.thickness[:, middle], color=OIL)
    gap.plot(film.x, film.thickness[:, middle], color=GREEN, linewidth=1.6)
    gap.set_ylim(0, 5)
    gap.set_yticks([0, 2, 4])
    gap.set_ylabel("film\n[µm]", fontsize=SMALL, labelpad=2)
    gap.set_xlabel("x, direction of rolling [mm]", fontsize=SMALL, labelpad=2)
    for axes in (upper, pressure, gap):
        finish(axes)
        axes.set_xlim(film.x[0], film.x[-1])
        axes.tick_params(labelbottom=axes is gap)
        axes.set_xticks([-1, -0.5, 0, 0.5], ["-1", "-0.5", "0", "0.5"])
    return upper


def draw_vibration(figure, pair, films):
    """Transmission error and forces on the teeth over two mesh periods."""
    error, force = (figure.add_axes([0.742, bottom, 0.248, 0.325]) for bottom in (0.56, 0.13))
    now = pair.at_moment(films) / pair.period
    periods = numpy.concatenate([pair.time / pair.period + n for n in range(PERIODS)])
    error.plot(periods, numpy.tile(pair.transmission_error, PERIODS), color=DARK, linewidth=1.6)
    error.plot(now, numpy.interp(now, periods, numpy.tile(pair.transmission_error, PERIODS)), marker="o", color=DARK)
    error.set_ylabel("transmission\nerror [µm]", fontsize=SMALL, labelpad=2)
    for n in range(-1, PERIODS):
        for order, (time, _, own) in pair.force.items():
            colour, style = ((GREEN, "-"), (PURPLE, (0, (5, 1))))[(n + order) % 2]
            force.plot(time / pair.period + n, own, color=colour, linestyle=style, linewidth=1.6)
    force.axhline(pair.static_force, color=GREY, linewidth=1, linestyle=":")
    for order, colour in enumerate((GREEN, PURPLE)):
        time, _, own = pair.force[order]
        force.plot(now, numpy.interp(now, time / pair.period, own), marker="o", color=colour, zorder=5)
    label(force, (1.37, pair.static_force), "static", (0, 7))
    force.set_ylim(0, 20)
    force.set_ylabel("force on each\ntooth [kN]", fontsize=SMALL, labelpad=2)
    force.set_xlabel("time [mesh periods]", fontsize=SMALL, labelpad=2)
    for axes in (error, force):
        finish(axes)
        axes.set_xlim(0, PERIODS)
        axes.set_xticks(numpy.arange(0, PERIODS + 0.1, 0.5), ["0", "", "1", "", "2"])
        axes.tick_params(labelbottom=axes is force)
    figure.align_ylabels([error, force])


def draw_pair_film_vibration(pair):
    films = pair.moments[MOMENT]
    figure = new_figure(HEIGHT)
    gears, spot = draw_gears(figure, pair, films)
    draw_film(figure, films[0])
    draw_vibration(figure, pair, films)
    left, bottom, width, height = FRAME
    figure.add_artist(FancyBboxPatch((left, bottom), width, height, boxstyle="round,pad=0,rounding_size=0.01",
                                     facecolor="none", edgecolor=DARK, linewidth=0.8, transform=figure.transFigure))
    for corner in (bottom + 0.02, bottom + height - 0.02):
        figure.add_artist(ConnectionPatch(spot, (left, corner), gears.transData, figure.transFigure, color=DARK,
                                          linewidth=0.8))
    for centre, text in ((0.153, "gears"), (0.49, "oil film in a contact"), (0.862, "vibration")):
        figure.text(centre, TITLE_AT, text, fontsize=LARGE, color=DARK, ha="center", va="center")
    for begin, end in ((0.215, 0.335), (0.645, 0.775)):
        figure.add_artist(FancyArrowPatch((begin, TITLE_AT), (end, TITLE_AT), arrowstyle="-|>", mutation_scale=16,
                                          color=DARK, linewidth=1.8, transform=figure.transFigure))
    return figure
