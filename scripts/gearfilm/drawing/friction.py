"""Figure of friction and heat: coefficient, losses and temperatures over the line of action, and along one contact.

Of a film at rest with heat: temperatures along y = 0, and across the film there.
"""
from typing import NamedTuple

import numpy
from matplotlib import pyplot

from .canvas import (BLUE, DARK, GREEN, VERMILLION, Foreign, add_grid, add_legend, by_contact, of_last_period,
                     open_results, read_table)

OF_FRICTION = {"contact", "T", "xi", "friction_coefficient", "power_sliding", "power_rolling"}
OF_HEAT = ("film_temperature_max", "surface_temperature_pinion", "surface_temperature_wheel")
ALONG = {"temperature_mid": ("middle", VERMILLION), "temperature_mean": ("mean", DARK),
         "temperature_pinion": ("pinion", BLUE), "temperature_wheel": ("wheel", GREEN)}


class Profile(NamedTuple):
    """Temperatures [K] along y = 0 of one contact, over x [m]; across the film, the wheel's wall first."""
    xi: float
    x: numpy.ndarray
    fields: dict
    across: numpy.ndarray = None
    pressure: numpy.ndarray = None  # [Pa]


def read_contacts(results):
    """Rows of all contacts in the last whole period, or all there are, as one array a contact."""
    rows = read_table(results, "history/contacts", {"xi"})
    if "friction_coefficient" not in rows.dtype.names:
        raise Foreign("it has no friction; give friction.law")
    read_table(results, "history/contacts", OF_FRICTION)
    return by_contact(of_last_period(results, rows))


def read_profile(results, wanted):
    """Profile of the stored contact nearest to a position [m]; None where no temperatures are stored."""
    best = None
    for snapshot in results.get("snapshots", {}).values():
        mesh = snapshot.attrs["mesh"]
        mesh = mesh.decode() if isinstance(mesh, bytes) else mesh
        for contact in snapshot.values():
            nearer = best is None or abs(contact.attrs["xi"] - wanted) < abs(best[1].attrs["xi"] - wanted)
            if set(ALONG) <= set(contact) and nearer:
                best = mesh, contact
    if best is None:
        return None
    mesh, contact = best
    x, y = results[f"{mesh}/x"][:], results[f"{mesh}/y"][:]
    middle = int(numpy.argmin(abs(y)))
    return Profile(float(contact.attrs["xi"]), x, {name: contact[name][:, middle] for name in ALONG})


def read_film(contact):
    """The profile of a film at rest."""
    if "temperature_across" not in contact:
        raise Foreign("it has no heat; give thermal.model")
    middle = int(numpy.argmin(abs(contact["y"][:])))
    return Profile(float(contact.attrs["xi"]), contact["x"][:], {name: contact[name][:, middle] for name in ALONG},
                   contact["temperature_across"][:], contact["P"][:, middle])


def draw_results(path, wanted):
    with open_results(path, "transient, periodic or steady", "it has no history of contacts") as results:
        if "history" not in results and "contact0" in results:
            return draw_film(read_film(results["contact0"]))
        return draw(read_contacts(results), read_profile(results, wanted))


def draw_over_line(axes, contacts, lines):
    """Draws one line for each quantity: column, scale, label and colour."""
    for column, scale, label, colour in lines:
        for rows in contacts:
            axes.plot(1e3 * rows["xi"], scale * rows[column], color=colour, linewidth=1.4, label=label)
    axes.set_xlabel(r"position $\xi$ of the contact [mm]")
    if len(lines) > 1:
        add_legend(axes, *axes.get_legend_handles_labels())


def draw_profile(axes, profile):
    for name, (label, colour) in ALONG.items():
        axes.plot(1e3 * profile.x, profile.fields[name], color=colour, linewidth=1.4, label=label)
    add_legend(axes, *axes.get_legend_handles_labels())
    axes.set_xlabel(rf"x along y = 0 [mm], $\xi$ = {1e3 * profile.xi:.2f} mm")
    axes.set_ylabel("temperature [K]")


def draw(contacts, profile):
    heated = set(OF_HEAT) <= set(contacts[0].dtype.names)
    figure, axes = pyplot.subplots(2 if heated else 1, 2, figsize=(8, 7 if heated else 3.6), squeeze=False,
                                   constrained_layout=True)
    draw_over_line(axes[0, 0], contacts, [("friction_coefficient", 1.0, "", BLUE)])
    axes[0, 0].set_ylabel("friction coefficient [-]")
    draw_over_line(axes[0, 1], contacts, [("power_sliding", 1.0, "sliding", BLUE),
                                          ("power_rolling", 1.0, "rolling", VERMILLION)])
    axes[0, 1].set_ylabel("power lost [W]")
    if heated:
        draw_over_line(axes[1, 0], contacts, [(OF_HEAT[0], 1.0, "film", VERMILLION), (OF_HEAT[1], 1.0, "pinion", BLUE),
                                              (OF_HEAT[2], 1.0, "wheel", GREEN)])
        axes[1, 0].set_ylabel("largest temperature [K]")
        if profile:
            draw_profile(axes[1, 1], profile)
        else:
            axes[1, 1].axis("off")
    add_grid(*axes.flat)
    return figure


def draw_across(figure, axes, profile):
    """Draws the temperature over x and the place across the film, and where pressure is a tenth of its largest."""
    height = numpy.linspace(0, 1, profile.across.shape[1])
    image = axes.pcolormesh(1e3 * profile.x, height, profile.across.T, cmap="inferno", shading="gouraud", rasterized=True)
    loaded = profile.x[profile.pressure > 0.1 * profile.pressure.max()]
    for edge in (loaded[0], loaded[-1]):
        axes.axvline(1e3 * edge, color="white", linewidth=0.8, linestyle=":")
    axes.set_xlabel("x along y = 0 [mm]; dotted: a tenth of the largest pressure")
    axes.set_ylabel("z/h, wheel to pinion")
    figure.colorbar(image, ax=axes, label="temperature [K]")


def draw_film(profile):
    figure, (along, over) = pyplot.subplots(2, 1, figsize=(8, 7), constrained_layout=True)
    draw_profile(along, profile)
    add_grid(along)
    draw_across(figure, over, profile)
    return figure


def add_options(parser):
    parser.add_argument("--at", type=float, default=2.0, help="position of the contact whose temperatures are drawn [mm]")


def draw_folder(folder, at=2.0):
    """Of `gearfilm transient`, `periodic` or `steady` with friction; temperatures of the stored contact nearest to a
    position [mm]."""
    return draw_results(folder / "results.h5", 1e-3 * at)
