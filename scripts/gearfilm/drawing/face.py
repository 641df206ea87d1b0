"""Figure of the face: largest pressure and smallest film over it, line load and films along it.

Of `gearfilm steady`: pressure and film of the contact, the load by unit length and the smallest film of its rows. Of a
march that stores films: the contact pattern, which is the largest pressure and the smallest film of every row while the
contact goes over the flank, and the largest line load and the smallest film that a row has on its way.
"""
import math
from typing import NamedTuple

import numpy
from matplotlib import pyplot

from ..folder import RunFolder
from .canvas import BLUE, VERMILLION, Foreign, PlotError, add_grid, fill, open_results

THICKEST_SHOWN = 1.5    # times the film in the middle
FEWEST_PLACES = 4       # of contacts on the flank, for a pattern
LEVELS = 25
ALIKE = 1e-6            # of two places on the line of action [mm]


class Rows(NamedTuple):
    """What one contact has along the face."""
    place: float                # on the line of action, from the pitch point [mm]
    pressure: numpy.ndarray     # largest of a row [GPa]
    film: numpy.ndarray         # smallest of a row [um]
    line_load: numpy.ndarray    # [N/mm]


def rows_of(film, y):
    """On the places y along the face; what lies beyond the film's own domain is not loaded."""
    line_load = 1e3 * numpy.trapz(film.pressure, film.x, axis=0)
    return Rows(film.xi, numpy.interp(y, film.y, film.pressure.max(axis=0), left=0, right=0),
                numpy.interp(y, film.y, film.thickness.min(axis=0), left=math.nan, right=math.nan),
                numpy.interp(y, film.y, line_load, left=0, right=0))


def roll_angles(run, places):
    """Of the pinion at places on the line of action [degrees]; None where the teeth are not given by a module."""
    values = {name: entry.value for name, entry in run.parameters.items()}
    needed = ("gear.module", "gear.pressure_angle_deg", "gear.centre_distance", "pinion.teeth", "wheel.teeth")
    if not all(isinstance(values.get(name), (int, float)) for name in needed):
        return None
    base_sum = 0.5 * values["gear.module"] * math.cos(math.radians(values["gear.pressure_angle_deg"]))
    base_radius = base_sum * values["pinion.teeth"]
    ratio = base_sum * (values["pinion.teeth"] + values["wheel.teeth"]) / values["gear.centre_distance"]
    return numpy.degrees(math.tan(math.acos(ratio)) + 1e-3 * numpy.asarray(places) / base_radius)


def pattern(films):
    """Rows of contacts over the flank, each place once and in order."""
    y = max((film.y for film in films), key=lambda values: values[-1] - values[0])
    known = []
    for rows in sorted((rows_of(film, y) for film in films), key=lambda rows: rows.place):
        if not known or rows.place - known[-1].place > ALIKE:
            known.append(rows)
    return y, known


def draw_along(axes, y, load, film):
    load_axes, film_axes = axes
    load_axes.plot(y, load, color=BLUE)
    load_axes.set_ylabel("line load [N/mm]")
    load_axes.set_ylim(bottom=0)
    film_axes.plot(y, film, color=VERMILLION)
    film_axes.set_ylabel("h [µm]")
    film_axes.set_ylim(0, THICKEST_SHOWN * float(numpy.interp(0, y, film)))
    for panel in axes:
        panel.set_xlabel("y along the face [mm]")
        panel.set_xlim(y[0], y[-1])
    add_grid(*axes)


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
    draw_along(panels[1], film.y, rows.line_load, rows.film)
    panels[1][0].set_title("load by unit length", fontsize=9)
    panels[1][1].set_title("smallest film of the rows", fontsize=9)


def draw_pattern(figure, panels, run, films):
    y, contacts = pattern(films)
    if len(contacts) < FEWEST_PLACES:
        raise PlotError(f"{run.folder} stores films at {len(contacts)} places of the flank, too few for a pattern; run "
                        "with -output_snapshot_interval 0.05")
    places = [rows.place for rows in contacts]
    angles = roll_angles(run, places)
    pressure, film, load = (numpy.array([getattr(rows, name) for rows in contacts])
                            for name in ("pressure", "film", "line_load"))
    heights = places if angles is None else angles
    middle = float(numpy.nanmin(film[:, abs(y).argmin()]))
    draw_map(figure, panels[0][0], y, heights, pressure, pressure_levels(pressure), "p [GPa]")
    draw_map(figure, panels[0][1], y, heights, film, film_levels(film, middle), "h [µm]")
    for axes, title in zip(panels[0], ("contact pattern: largest pressure of a row", "smallest film of a row")):
        axes.set_title(title, fontsize=9)
        axes.set_ylabel("place on the line of action [mm]" if angles is None else "roll angle of the pinion [°]")
    draw_along(panels[1], y, load.max(axis=0), numpy.nanmin(film, axis=0))
    panels[1][0].set_title("largest load by unit length", fontsize=9)
    panels[1][1].set_title("smallest film on the way over the flank", fontsize=9)


def draw_folder(folder):
    """Of `gearfilm steady`, or of a march that stores films."""
    with open_results(folder / "results.h5", "steady, or a march with films", "films are missing"):
        run = RunFolder(folder)
        films = run.films()
        if not films:
            raise Foreign("it stores no films; run it with -output_snapshot_interval 0.05")
    figure, panels = pyplot.subplots(2, 2, figsize=(9, 6), constrained_layout=True)
    if run.command == "steady":
        draw_contact(figure, panels, films[0])
    else:
        draw_pattern(figure, panels, run, films)
    return figure
