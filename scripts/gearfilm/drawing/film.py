"""Figure of a stationary film: the film over the contact, and pressure and film along its centre line y = 0."""
from typing import NamedTuple

import numpy
from matplotlib import pyplot

from .canvas import BLUE, VERMILLION, Foreign, fill, open_results

THICKEST_SHOWN = 1.5  # times the central film
SLENDER = 0.15         # length of the domain over its width, below which its axes have unequal scales


class Film(NamedTuple):
    """One contact, lengths in mm, pressure in GPa, film in µm; the Hertz contact is that of the reference load."""
    x: numpy.ndarray
    y: numpy.ndarray
    pressure: numpy.ndarray
    thickness: numpy.ndarray
    half_axes: tuple
    hertz_pressure: float


def read_film(path):
    with open_results(path, "steady", "contact0 with x, y, P, H is missing") as results:
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
    angle = numpy.linspace(0, 2 * numpy.pi, 200)
    a, b = film.half_axes
    axes.plot(b * numpy.cos(angle), a * numpy.sin(angle), color="white", linestyle="--", linewidth=1)
    # As it is; a slender contact would be a sliver, and has unequal axes.
    slender = numpy.ptp(film.x) < SLENDER * numpy.ptp(film.y)
    axes.set_aspect("auto" if slender else "equal")
    axes.set_xlabel("y [mm]")
    axes.set_ylabel("x [mm]")
    # In two lines, since narrow domains leave little room beside the axes.
    unequal = "; axes of unequal scales" if slender else ""
    axes.set_title(f"film thickness; oil enters from below{unequal};\ndashed: Hertz ellipse of the reference contact",
                   fontsize=9)
    figure.colorbar(filled, ax=axes, label="h [µm]", format="%.2f", shrink=0.9)


def draw_sections(pressure_axes, film_axes, film, centre):
    i, j = centre
    a = film.half_axes[0]
    dry = film.hertz_pressure * numpy.sqrt(numpy.maximum(1 - (film.x / a) ** 2, 0))
    pressure_axes.plot(film.x, film.pressure[:, j], color=BLUE, label="lubricated")
    pressure_axes.plot(film.x, dry, color="black", linestyle="--", linewidth=1, label="Hertz, reference")
    pressure_axes.set_ylabel("p [GPa]")
    pressure_axes.set_title("pressure along y = 0", fontsize=9)
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
    draw_map(figure, figure.add_subplot(grid[0, :]), film, centre)
    draw_sections(figure.add_subplot(grid[1, 0]), figure.add_subplot(grid[1, 1]), film, centre)
    return figure


def draw_folder(folder):
    """Of `gearfilm steady`."""
    return draw(read_film(folder / "results.h5"))
