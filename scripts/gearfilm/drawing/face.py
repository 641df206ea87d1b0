"""Figure of the face: largest pressure and smallest film over it, line load and films along it.

Of `gearfilm steady`: pressure and film of the contact, the load by unit length and the smallest film of its rows. Of a
periodic state or a march: the contact pattern, which is the largest pressure and the smallest film that the places of
the pinion's flank meet, and what friction does there.
"""
import math
from typing import NamedTuple

import numpy
from matplotlib import pyplot

from ..folder import RunFolder
from .canvas import BLUE, VERMILLION, Foreign, add_grid, fill, open_results

THICKEST_SHOWN = 1.5    # times the film in the middle
LEVELS = 25
# Name in the results, scale, title and label; those that there are, as many as there are panels.
PATTERN = (("p_max", 1e-9, "contact pattern: largest pressure", "p [GPa]"),
           ("h_min", 1e6, "smallest film", "h [µm]"),
           ("friction_energy", 1e-3, "heat of sliding in a passage", "E [kJ/m²]"),
           ("temperature_max", 1.0, "highest temperature", "T [K]"),
           ("sliding_distance", 1e3, "way of sliding in a passage", "L [mm]"))


class Rows(NamedTuple):
    """What one contact has along the face."""
    pressure: numpy.ndarray     # largest of a row [GPa]
    film: numpy.ndarray         # smallest of a row [um]
    line_load: numpy.ndarray    # [N/mm]


def rows_of(film, y):
    """Rows at the places y along the face; what lies beyond the film's own domain is not loaded."""
    line_load = 1e3 * numpy.trapz(film.pressure, film.x, axis=0)
    return Rows(numpy.interp(y, film.y, film.pressure.max(axis=0), left=0, right=0),
                numpy.interp(y, film.y, film.thickness.min(axis=0), left=math.nan, right=math.nan),
                numpy.interp(y, film.y, line_load, left=0, right=0))


def roll_angles(flank):
    """Roll angles of the pinion at the points of its flank, 2 s/rho [degrees]."""
    return numpy.degrees(2 * flank["s"] / flank["rho"])


def draw_along(axes, y, values, label, colour, top=None):
    axes.plot(y, values, color=colour)
    axes.set_ylabel(label)
    axes.set_ylim(0, top)
    axes.set_xlabel("y along the face [mm]")
    axes.set_xlim(y[0], y[-1])
    add_grid(axes)


def draw_film_along(axes, y, film, middle):
    draw_along(axes, y, film, "h [µm]", VERMILLION, THICKEST_SHOWN * middle)


def draw_map(figure, axes, y, places, values, levels, label):
    filled = fill(axes, y, places, values, levels)
    axes.set_xlabel("y along the face [mm]")
    figure.colorbar(filled, ax=axes, label=label, format="%.2f")


def pressure_levels(pressure):
    return numpy.linspace(0, pressure.max(), LEVELS)[1:]


def film_levels(film, middle):
    return numpy.linspace(max(0.0, numpy.nanmin(film)), THICKEST_SHOWN * middle, LEVELS)


def draw_contact(figure, panels, film):
    rows = rows_of(film, film.y)
    middle = film.thickness[abs(film.x).argmin(), abs(film.y).argmin()]
    draw_map(figure, panels[0][0], film.y, film.x, film.pressure, pressure_levels(film.pressure), "p [GPa]")
    draw_map(figure, panels[0][1], film.y, film.x, film.thickness, film_levels(film.thickness, middle), "h [µm]")
    for axes, title in zip(panels[0], ("pressure", "film; oil enters from below")):
        axes.set_title(title, fontsize=9)
        axes.set_ylabel("x [mm]")
    draw_along(panels[1][0], film.y, rows.line_load, "line load [N/mm]", BLUE)
    draw_film_along(panels[1][1], film.y, rows.film, float(numpy.interp(0, film.y, rows.film)))
    panels[1][0].set_title("load by unit length", fontsize=9)
    panels[1][1].set_title("smallest film of the rows", fontsize=9)


def draw_pattern(figure, panels, flank):
    """Draws one map over the face and the roll angle."""
    y, angles = 1e3 * flank["y"], roll_angles(flank)
    known = [entry for entry in PATTERN if entry[0] in flank]
    film = 1e6 * flank["h_min"].reshape(angles.size, y.size)
    middle = float(numpy.nanmin(film[:, abs(y).argmin()]))
    for axes in panels.flat[len(known):]:
        draw_film_along(axes, y, numpy.nanmin(film, axis=0), middle)
        axes.set_title("smallest film on the way over the flank", fontsize=9)
    for axes, (name, scale, title, label) in zip(panels.flat, known):
        values = scale * flank[name].reshape(angles.size, y.size)
        if name == "h_min":
            levels = film_levels(values, middle)
        else:
            # What no contact has met counts as the least.
            values = numpy.nan_to_num(values, nan=numpy.nanmin(values))
            levels = numpy.linspace(values.min(), values.max(), LEVELS)[1:]
        draw_map(figure, axes, y, angles, values, levels, label)
        axes.set_title(title, fontsize=9)
        axes.set_ylabel("roll angle of the pinion [°]")


def draw_folder(folder):
    """Draws `gearfilm steady`, or a periodic state or a march on films."""
    with open_results(folder / "results.h5", "steady, periodic or transient on films", "films are missing") as results:
        run = RunFolder(folder)
        flank = None
        if run.command != "steady":
            if "p_max" not in results.get("flank/pinion", ()):
                raise Foreign("it has no maps of the flanks")
            flank = {name: values[()].squeeze(axis=1) if values.shape[1] == 1 else values[()]
                     for name, values in results["flank/pinion"].items()}
            if flank["y"].size < 2:
                raise Foreign("its films have one row")
        elif not run.films():
            raise Foreign("it stores no films")
    figure, panels = pyplot.subplots(2, 2, figsize=(9, 6), constrained_layout=True)
    if flank is None:
        draw_contact(figure, panels, run.films()[0])
    else:
        draw_pattern(figure, panels, flank)
    return figure
