"""Figure of what the films mean for the gears: stresses below them, fatigue of the flanks, ratings.

Of a periodic state or a march with fatigue.criterion: Dang Van stress over flank and depth of both gears, with the
line of the safety 1, and beside it the least safety and the hardness over the depth. With stresses or
ratings alone, or with --path: stresses, temperatures and film ratio over the line of action. Of a film at rest, or with
--section: the von Mises stress in the section below it, of a march at its worst moment, and the loads above.
"""
import numpy
from matplotlib import pyplot

from .canvas import (BLUE, DARK, GREEN, GREY, PURPLE, VERMILLION, Foreign, add_grid, add_legend, by_contact, draw_over_path,
                     fill, of_last_period, open_results, read_table)

LACK = "it has no stresses below films; give stress.model"
LOADED = 0.02       # of the largest force: contacts that carry less are left out
LEVELS = 16
GEARS = ("pinion", "wheel")


def add_options(parser):
    parser.add_argument("--path", action="store_true", help="over the line of action, where maps of flanks are there too")
    parser.add_argument("--section", action="store_true", help="below the contact when its stresses are largest")


def flank_of(results, gear):
    return {name: values[()].squeeze() for name, values in results[f"flank/{gear}"].items()}


def draw_flank(axes, flank, gear, levels):
    """The map of one gear and, beside it, safety and hardness over the depth."""
    chart, beside = axes
    s, z = 1e3 * flank["s"], 1e3 * flank["z"]
    image = fill(chart, s, z, 1e-6 * flank["dang_van"].T, levels)
    chart.set_ylim(z[-1], 0)
    chart.set_xlabel(f"{gear}: place along the flank, root to tip [mm]")
    chart.set_ylabel("depth [mm]")
    beside.set_ylim(z[-1], 0)
    if "safety" in flank:
        beside.plot(flank["safety"].min(axis=0), z, color=VERMILLION, linewidth=1.4, label="least safety")
        beside.axvline(1.0, color=GREY, linewidth=0.8, linestyle="--")
        beside.set_xlim(0, min(4.0, 1.1 * flank["safety"].min(axis=0).max()))
        if flank["safety"].min() < 1.0 < flank["safety"].max():
            chart.contour(s, z, flank["safety"].T, levels=[1.0], colors="white", linewidths=1.2)
        beside.set_xlabel("least safety [-]", color=VERMILLION)
    else:
        beside.plot(1e-6 * flank["dang_van"].max(axis=0), z, color=DARK, linewidth=1.4)
        beside.set_xlabel("largest [MPa]")
    if "hardness" in flank:
        hard = beside.twiny()
        hard.plot(flank["hardness"], z, color=BLUE, linewidth=1.4)
        hard.set_xlabel("hardness [HV]", color=BLUE)
    add_grid(beside)
    return image


def draw_flanks(flanks):
    largest = 1e-6 * max(flank["dang_van"].max() for flank in flanks)
    levels = numpy.linspace(0, largest, LEVELS)
    figure, axes = pyplot.subplots(2, 2, figsize=(9, 7.2), width_ratios=(3, 1), constrained_layout=True)
    for row, flank, gear in zip(axes, flanks, GEARS):
        image = draw_flank(row, flank, gear, levels)
    figure.colorbar(image, ax=axes[:, 0], location="top", shrink=0.7, aspect=40, format="%.0f",
                    label="largest Dang Van stress of a passage [MPa]")
    return figure


def panels_of(names):
    """Panels of the columns that there are: each column with its scale, label and colour."""
    panels = [("von Mises stress [MPa]", [(f"von_mises_max_{gear}", 1e-6, gear, colour)
                                          for gear, colour in zip(GEARS, (BLUE, GREEN))]),
              ("contact stress [MPa]", [("p_max", 1e-6, "largest pressure", VERMILLION),
                                        ("sigma_H", 1e-6, "of a line contact", DARK)]),
              ("stress at the root [MPa]", [(f"sigma_F_{gear}", 1e-6, gear, colour)
                                            for gear, colour in zip(GEARS, (BLUE, GREEN))]),
              ("flanks, at most [K]", [("contact_temperature", 1.0, "", VERMILLION)]),
              ("film over Ra [-]", [("lambda_GF", 1.0, "", PURPLE)])]
    return [(label, lines) for label, lines in panels if all(line[0] in names for line in lines)]


def read_path(results):
    rows = of_last_period(results, read_table(results, "history/contacts", {"xi", "contact", "T", "force"}))
    if not panels_of(rows.dtype.names):
        raise Foreign("it has neither stresses below films nor ratings; give stress.model, or limits of rating")
    return by_contact(rows[rows["force"] > LOADED * rows["force"].max()])


def sections_of(results):
    """The sections of both gears: x, z, von Mises stress and what loads the surface."""
    for gear in GEARS:
        group, ending = (results["contact0/section"], f"_{gear}") if "contact0" in results else (results[f"section/{gear}"], "")
        zz, xz, stress = (group[name + ending][()] for name in ("sigma_zz", "sigma_xz", "von_mises"))
        yield gear, group["x"][()].ravel(), group["z"][()].ravel(), stress, (-zz[0], -xz[0])


def draw_section(results):
    """Von Mises stress in the sections of both gears, with pressure and shear on the surface above."""
    sections = list(sections_of(results))
    figure, axes = pyplot.subplots(3, 1, sharex=True, figsize=(7, 7.5), height_ratios=(1, 1.3, 1.3), constrained_layout=True)
    shears = axes[0].twinx()
    for (gear, x, _, _, (pressure, shear)), style in zip(sections, ("-", "--")):
        axes[0].plot(1e3 * x, 1e-9 * pressure, color=DARK, linewidth=1.4, linestyle=style)
        shears.plot(1e3 * x, 1e-6 * shear, color=BLUE, linewidth=1.2, linestyle=style, label=gear)
    axes[0].set_ylabel("pressure [GPa]")
    axes[0].set_ylim(bottom=0)
    shears.set_ylabel("shear on the surface [MPa]", color=BLUE)
    add_legend(shears, *shears.get_legend_handles_labels())
    add_grid(axes[0])
    levels = numpy.linspace(0, 1e-6 * max(stress.max() for _, _, _, stress, _ in sections), LEVELS)
    for panel, (gear, x, z, stress, _) in zip(axes[1:], sections):
        image = fill(panel, 1e3 * x, 1e3 * z, 1e-6 * stress, levels)
        panel.set_ylim(1e3 * z[-1], 0)
        panel.set_ylabel(f"{gear}: depth [mm]")
    axes[-1].set_xlabel("x along the entrainment [mm]")
    figure.colorbar(image, ax=axes[1:], format="%.0f", label="von Mises stress [MPa]")
    return figure


def draw_folder(folder, path=False, section=False):
    """Draws `gearfilm periodic`, `transient` or `steady`, with stress.model or limits of rating."""
    with open_results(folder / "results.h5", "periodic, transient or steady", LACK) as results:
        if section and "contact0" not in results and "section" not in results:
            raise Foreign("it has no section of its worst moment; give fatigue.criterion")
        if section or "history" not in results:
            return draw_section(results)
        if "dang_van" in results.get("flank/pinion", ()) and not path:
            return draw_flanks([flank_of(results, gear) for gear in GEARS])
        contacts = read_path(results)
        return draw_over_path(contacts, panels_of(contacts[0].dtype.names), height=2.2)
