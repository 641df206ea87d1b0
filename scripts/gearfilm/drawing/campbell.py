"""Campbell diagram of a drive train: its natural frequencies over the speed, with the harmonics of the mesh.

Lines across are the modes, on films where they were computed, the darker the more the teeth strain in them; dots mark
where 1, 2 and 3 times the mesh frequency meet them, and the dashed line is the speed of the case.
"""
import numpy
from matplotlib import pyplot
from matplotlib.colors import LogNorm

from .canvas import COLOUR_MAP, DARK, GREY, PlotError, add_grid, read_summary

COMMANDS = "info or eigen"
FELT = 1e-3           # share of the mesh from which a mode answers to it
HARMONICS = (1, 2, 3)


def read_modes(folder):
    """The summary of a case with a drive train."""
    summary = read_summary(folder, COMMANDS)
    if not summary.get("modes"):
        raise PlotError(f"{folder} has no modes of a drive train; give one (motor, load, bearings or train.file) and run "
                        f"gearfilm {COMMANDS}")
    return summary


def frequency_of(mode):
    """Frequency of a mode on films, or of the dry mesh where no other was found [Hz]."""
    return mode["frequency_dry"] if mode.get("frequency") is None else mode["frequency"]


def limits_of(summary):
    """Largest speed [rpm] and frequency [Hz] of the diagram."""
    highest = max(map(frequency_of, summary["modes"]))
    speed = summary["speed_rpm"]
    return min(max(1.25 * speed, 1.1 * highest / hertz_by_rpm(summary)), 3 * speed), 1.12 * highest


def hertz_by_rpm(summary):
    """Mesh frequency over the speed."""
    first = summary["modes"][0]
    return first["frequency_dry"] / first["crossing_rpm"][0]


def draw_modes(axes, modes, fastest, norm):
    for mode in modes:
        felt = mode["mesh_share"] > FELT
        colour = pyplot.get_cmap(COLOUR_MAP + "_r")(norm(mode["mesh_share"])) if felt else GREY
        axes.plot([0, fastest], 2 * [1e-3 * frequency_of(mode)], color=colour, linewidth=1.8 if felt else 0.9,
                  linestyle="-" if felt else ":")


def draw_harmonics(axes, summary, fastest, highest):
    slope = hertz_by_rpm(summary)
    for harmonic in HARMONICS:
        end = min(fastest, highest / (harmonic * slope))
        axes.plot([0, end], [0, 1e-3 * harmonic * slope * end], color=DARK, linewidth=0.9)
        axes.annotate(f"{harmonic if harmonic > 1 else ''}$f_m$", (end, 1e-3 * harmonic * slope * end),
                      textcoords="offset points", xytext=(3, 2), fontsize=8, color=DARK)
        met = numpy.array([frequency_of(mode) for mode in summary["modes"] if mode["mesh_share"] > FELT])
        axes.plot(met / (harmonic * slope), 1e-3 * met, "o", color=DARK, markersize=3.5)


def draw_folder(folder):
    """Draws `gearfilm info` or `eigen` of a case with a drive train."""
    summary = read_modes(folder)
    fastest, highest = limits_of(summary)
    norm = LogNorm(FELT, 1)
    figure, axes = pyplot.subplots(figsize=(7, 4.6), constrained_layout=True)
    draw_modes(axes, summary["modes"], fastest, norm)
    draw_harmonics(axes, summary, fastest, highest)
    axes.axvline(summary["speed_rpm"], color=DARK, linewidth=0.9, linestyle="--")
    axes.set_xlim(0, fastest)
    axes.set_ylim(0, 1e-3 * highest)
    axes.set_xlabel("speed of the pinion [rpm]")
    axes.set_ylabel("frequency [kHz]")
    add_grid(axes)
    scale = pyplot.cm.ScalarMappable(norm, COLOUR_MAP + "_r")
    figure.colorbar(scale, ax=axes, label="share of the teeth in the mode [-]")
    return figure
