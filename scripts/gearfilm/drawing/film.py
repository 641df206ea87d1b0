"""Figure of a film: the film over the contact, and pressure and film along its centre line y = 0.

Of `gearfilm steady`, or of a march that stores films: then that which is nearest to a place on the line of action.
"""
from typing import NamedTuple, Optional

import numpy
from matplotlib import pyplot

from ..folder import RunFolder
from .canvas import BLUE, VERMILLION, Foreign, fill, open_results

THICKEST_SHOWN = 1.5  # times the central film
SLENDER = 0.15         # length of the domain over its width, below which its axes have unequal scales
WIDE = 2.0             # width of a map over its height from which it stands above the sections
SAME_LENGTH = 1e-6     # relative, of a half-axis found at both ends of a domain


class Film(NamedTuple):
    """One contact, lengths in mm, pressure in GPa, film in µm; the Hertz contact is that of the reference load."""
    x: numpy.ndarray
    y: numpy.ndarray
    pressure: numpy.ndarray
    thickness: numpy.ndarray
    half_axes: Optional[tuple]          # None where they are not known
    hertz_pressure: Optional[float]     # the same
    place: str = ""                     # of the contact in a march, and the time


def half_axes(x, y, domains):
    """Those of the reference contact, from a domain in units of them that is as wide as the fields; None of another."""
    for x_min, x_max, y_half in domains:
        a = x[0] / x_min
        if abs(x[-1] / x_max - a) < SAME_LENGTH * a:
            return a, y[-1] / y_half
    return None


def read_marched(folder, place):
    """The stored film of a march that is nearest to a place on the line of action [mm]; None where it stores none."""
    run = RunFolder(folder)
    if not run.stores_films():
        return None
    film = run.film(place)
    names = ("x_min", "x_max", "y_half")
    domains = [[float(run.attributes[name]) for name in names]] if set(names) <= set(run.attributes) else []
    final = run.summary.get("final_grid")
    domains += [[final[name] for name in names]] if final else []
    return Film(film.x, film.y, film.pressure, film.thickness, half_axes(film.x, film.y, domains), None,
                rf"$\xi$ = {film.xi:.3g} mm, t = {1e3 * film.time:.4g} ms")


def read_film(folder, place=0.0):
    path = folder / "results.h5"
    with open_results(path, "steady, or a march with films", "contact0 with x, y, P, H is missing") as results:
        if "history" in results:
            marched = read_marched(folder, place)
            if marched is None:
                raise Foreign("it stores no films; run it with -output_snapshot_interval 0.1")
            return marched
        contact = results["contact0"]
        film = Film(x=1e3 * contact["x"][:], y=1e3 * contact["y"][:], pressure=1e-9 * contact["P"][:],
                    thickness=1e6 * contact["H"][:],
                    half_axes=(1e3 * contact.attrs["a"], 1e3 * contact.attrs["b"]),
                    hertz_pressure=1e-9 * contact.attrs["p_hertz"])
        if film.pressure.shape != (film.x.size, film.y.size) or film.thickness.shape != film.pressure.shape:
            raise Foreign("P, H do not fit x, y")
    return film


def draw_map(figure, axes, film, centre):
    i, j = centre
    levels = numpy.linspace(film.thickness.min(), THICKEST_SHOWN * film.thickness[i, j], 25)
    filled = fill(axes, film.y, film.x, film.thickness, levels)
    ellipse = ""
    if film.half_axes:
        angle = numpy.linspace(0, 2 * numpy.pi, 200)
        a, b = film.half_axes
        axes.plot(b * numpy.cos(angle), a * numpy.sin(angle), color="white", linestyle="--", linewidth=1)
        ellipse = "dashed: Hertz ellipse of the reference contact"
    # As it is; a slender contact would be a sliver, and has unequal axes.
    slender = numpy.ptp(film.x) < SLENDER * numpy.ptp(film.y)
    axes.set_aspect("auto" if slender else "equal")
    axes.set_xlabel("y [mm]")
    axes.set_ylabel("x [mm]")
    # In two lines, since narrow domains leave little room beside the axes.
    unequal = "; axes of unequal scales" if slender else ""
    below = "; ".join(words for words in (film.place, ellipse) if words)
    axes.set_title(f"film thickness; oil enters from below{unequal}\n{below}", fontsize=9)
    figure.colorbar(filled, ax=axes, label="h [µm]", format="%.2f", shrink=0.9)


def draw_sections(pressure_axes, film_axes, film, centre):
    i, j = centre
    pressure_axes.plot(film.x, film.pressure[:, j], color=BLUE, label="lubricated")
    if film.hertz_pressure:
        dry = film.hertz_pressure * numpy.sqrt(numpy.maximum(1 - (film.x / film.half_axes[0]) ** 2, 0))
        pressure_axes.plot(film.x, dry, color="black", linestyle="--", linewidth=1, label="Hertz, reference")
    pressure_axes.set_ylabel("p [GPa]")
    pressure_axes.set_title("pressure along y = 0", fontsize=9)
    if film.hertz_pressure:
        pressure_axes.legend(frameon=False, fontsize=8, loc="upper left")
    film_axes.plot(film.x, film.thickness[:, j], color=VERMILLION)
    film_axes.set_ylim(0, 2.5 * film.thickness[i, j])
    film_axes.set_ylabel("h [µm]")
    film_axes.set_title("film along y = 0", fontsize=9)
    for axes in (pressure_axes, film_axes):
        axes.set_xlabel("x [mm]")
        axes.set_xlim(film.x[0], film.x[-1])
        axes.grid(alpha=0.3)


def draw(film):
    centre = (abs(film.x).argmin(), abs(film.y).argmin())
    figure = pyplot.figure(figsize=(8, 5), constrained_layout=True)
    grid = figure.add_gridspec(2, 2)
    # A map that is not much wider than high stands beside the sections, a wider one above them.
    beside = numpy.ptp(film.y) < WIDE * numpy.ptp(film.x)
    places = (grid[:, 0], grid[0, 1], grid[1, 1]) if beside else (grid[0, :], grid[1, 0], grid[1, 1])
    draw_map(figure, figure.add_subplot(places[0]), film, centre)
    draw_sections(figure.add_subplot(places[1]), figure.add_subplot(places[2]), film, centre)
    return figure


def add_options(parser):
    parser.add_argument("--at", type=float, default=0.0,
                        help="position on the line of action of the stored film that is drawn of a march [mm]")


def draw_folder(folder, at=0.0):
    """Draws `gearfilm steady`, or the stored film of a march that is nearest to a position [mm]."""
    return draw(read_film(folder, at))
