"""Figure of a motion over its mesh periods: phase portrait, forces along the line of action, spectrum of H_0.

Drawn is the periodic state found by `gearfilm periodic`, or the last mesh periods of `gearfilm transient`.
"""
from typing import NamedTuple, Optional

import numpy
from matplotlib import pyplot

from .canvas import (BLUE, DARK, GREY, VERMILLION, PlotError, add_grid, add_legend, add_periods, open_results,
                     read_summary, read_table, read_text, require_periods)

SAME_TIME = 1e-6       # in mesh periods, of an end of the span and a step
FEW_PERIODS = 5        # beyond, lines are thinner and markers smaller
DECADES = 5            # height of the spectrum
LABELLED_PEAKS = 12.0  # kHz, up to which peaks carry their frequency
LABEL_DISTANCE = 0.03  # of the width of the spectrum, between the labels of two peaks
LABEL_SPACE = 0.1      # of that width, for the label of a marked frequency


class Orbit(NamedTuple):
    """The part of a history that is drawn, from the state at its begin, after any leaving, to the step at its end."""
    steps: numpy.ndarray
    contacts: numpy.ndarray
    change: numpy.ndarray           # number of contacts after each step, less that before: 1 at an entering
    mesh_period: float              # dimensionless, as T
    mesh_frequency: float           # kHz
    static_force: Optional[float]   # N
    spectrum: Optional[numpy.ndarray]
    periodic: bool
    summary: dict


def read_orbit(folder, periods):
    path = folder / "results.h5"
    with open_results(path, "periodic or transient", "it has no history") as results:
        steps = read_table(results, "history/steps", ["step", "T", "t", "dT", "H0", "V0", "force_total", "contacts"])
        contacts = read_table(results, "history/contacts", ["step", "contact", "T", "xi", "force"])
        spectrum = read_table(results, "spectrum", ["frequency", "H0"]) if "spectrum" in results else None
        ends = dict(results["history"].attrs)
        periodic = read_text(results.attrs["command"]) == "periodic"
    if periodic and "periodic_from" not in ends:
        raise PlotError(f"{path} is a search that found no periodic state")
    if not steps["T"].any():
        raise PlotError(f"{path} has no time step yet")
    summary = read_summary(folder, "periodic or transient")
    T = steps["T"]
    time_scale = steps["t"][-1] / T[-1]
    if periodic:
        begin, end = ends["periodic_from"], ends["periodic_to"]
        mesh_period = (end - begin) / summary.get("order", 1)
    elif "mesh_period" in summary:
        mesh_period = summary["mesh_period"] / time_scale
        begin, end = max(0.0, T[-1] - periods * mesh_period), T[-1]
    else:
        raise PlotError(f"{folder / 'summary.json'} has no mesh_period")
    first = max(0, numpy.searchsorted(T, begin + SAME_TIME * mesh_period) - 1)
    last = numpy.searchsorted(T, end - SAME_TIME * mesh_period)
    span = slice(first, last + 1)
    within = (contacts["step"] >= steps["step"][first]) & (contacts["step"] <= steps["step"][last])
    # Several rows may have one time: contacts change against the last row of the time before.
    row_before = numpy.searchsorted(T, T) - 1
    change = numpy.where(row_before < 0, 0, steps["contacts"] - steps["contacts"][row_before])
    return Orbit(steps[span], contacts[within], change[span], mesh_period, 1e-3 / (mesh_period * time_scale),
                 summary.get("static_force"), spectrum, periodic, summary)


def thickness(orbit):
    """Factor on lines and markers."""
    return 1.0 if numpy.ptp(orbit.steps["T"]) < (FEW_PERIODS + 0.5) * orbit.mesh_period else 0.5


def draw_phases(axes, orbit):
    """Phase portrait, marked where contacts enter and leave."""
    axes.plot(orbit.steps["H0"], orbit.steps["V0"], color=DARK, linewidth=thickness(orbit))
    for sign, marker, colour, label in ((1, "^", VERMILLION, "contact enters"), (-1, "v", BLUE, "contact leaves")):
        rows = orbit.steps[sign * orbit.change > 0]
        if rows.size:
            axes.plot(rows["H0"], rows["V0"], color=colour, marker=marker, markersize=6 * thickness(orbit),
                      linestyle="none", label=label)
            add_legend(axes, *axes.get_legend_handles_labels())
    axes.set_xlabel("$H_0$ [-]")
    axes.set_ylabel("$V_0$ [-]")


def draw_forces(axes, orbit):
    """Force on each contact, and on all, over the position of the contact; over the time where the geometry is held."""
    scale, unit = (1 / orbit.static_force, "static force") if orbit.static_force else (1e-3, "kN")
    jumps = orbit.change != 0  # of the total: left out, as gaps
    total = dict(zip(orbit.steps["step"], numpy.where(jumps, numpy.nan, scale * orbit.steps["force_total"])))
    together = orbit.steps["contacts"].max() > 1
    held = numpy.ptp(orbit.contacts["xi"]) == 0
    for tooth in numpy.unique(orbit.contacts["contact"]):
        rows = orbit.contacts[orbit.contacts["contact"] == tooth]
        place = rows["T"] / orbit.mesh_period if held else 1e3 * rows["xi"]
        axes.plot(place, scale * rows["force"], color=BLUE, linewidth=1.2 * thickness(orbit))
        if together:
            axes.plot(place, [total[step] for step in rows["step"]], color=VERMILLION, linewidth=thickness(orbit),
                      linestyle="--")
    if together:
        add_legend(axes, axes.lines[:2], ["on the contact", "on all contacts"])
    axes.set_xlabel("time [mesh periods]" if held else r"position $\xi$ of the contact [mm]")
    axes.set_ylabel(f"force [{unit}]")


def mark_frequencies(axes, orbit):
    """Mesh frequency and, where it is known, that of the free oscillation, as light lines with labels side by side."""
    marks = {orbit.mesh_frequency: "mesh\nfrequency"}
    if orbit.summary.get("free_frequency"):
        marks[1e-3 * orbit.summary["free_frequency"]] = "free\noscillation"
    width = axes.get_xlim()[1]
    for place, name in marks.items():
        leftwards = place < max(marks) and place > LABEL_SPACE * width
        axes.axvline(place, color=GREY, linewidth=0.8, linestyle="--", zorder=0)
        axes.annotate(f"{name}\n{place:.2f} kHz", (place, 1), xycoords=axes.get_xaxis_transform(),
                      xytext=(-4 if leftwards else 4, -4), textcoords="offset points", va="top",
                      ha="right" if leftwards else "left", fontsize=8)


def label_peaks(axes, orbit, lowest):
    """Frequencies of the peaks above the lowest one; of two that are too near to each other only the larger."""
    distance = LABEL_DISTANCE * axes.get_xlim()[1]
    labelled = []
    for peak in orbit.summary.get("spectrum_peaks", []):  # largest first
        frequency = 1e-3 * peak["frequency"]
        if lowest < frequency < LABELLED_PEAKS and all(abs(frequency - other) > distance for other in labelled):
            labelled.append(frequency)
            axes.annotate(f"{frequency:.2f}", (frequency, peak["H0"]), xytext=(0, 4), textcoords="offset points",
                          ha="center", fontsize=7, color=DARK, bbox={"color": "white", "pad": 0.5})


def draw_spectrum(axes, orbit):
    """Amplitudes of H_0: the lines of a periodic state, or the curve of a march with its peaks."""
    # The mean is no oscillation; the window of a march spreads it over the next line.
    lines = orbit.spectrum[1 if orbit.periodic else 2:]
    frequency, amplitude = 1e-3 * lines["frequency"], lines["H0"]
    largest = amplitude.max()
    axes.set_yscale("log")
    axes.set_ylim(10.0 ** -DECADES * largest, 20 * largest)
    axes.set_xlim(0, max(LABELLED_PEAKS, (6.5 if orbit.periodic else 3.5) * orbit.mesh_frequency))
    mark_frequencies(axes, orbit)
    if orbit.periodic:
        axes.vlines(frequency, axes.get_ylim()[0], amplitude, color=BLUE, linewidth=1.5)
        axes.plot(frequency, amplitude, color=BLUE, marker="o", markersize=4, linestyle="none")
    else:
        axes.plot(frequency, amplitude, color=BLUE, linewidth=0.8)
        label_peaks(axes, orbit, frequency[0])
    axes.set_xlabel("frequency [kHz]")
    axes.set_ylabel("amplitude of $H_0$ [-]")


def draw(orbit):
    panels = [["phases", "forces"]]
    if orbit.spectrum is not None:
        panels.append(["spectrum", "spectrum"])
    figure, axes = pyplot.subplot_mosaic(panels, figsize=(8, 3.5 * len(panels)), constrained_layout=True)
    draw_phases(axes["phases"], orbit)
    draw_forces(axes["forces"], orbit)
    if orbit.spectrum is not None:
        draw_spectrum(axes["spectrum"], orbit)
    add_grid(*axes.values())
    return figure


def add_options(parser):
    add_periods(parser)


def draw_folder(folder, periods=1):
    """Draws `gearfilm periodic`, or the last mesh periods of `transient`, so many of them."""
    require_periods(periods)
    return draw(read_orbit(folder, periods))
