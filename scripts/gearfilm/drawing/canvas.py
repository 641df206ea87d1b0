"""What figures have in common: the results they read, their colours, grids and legends, the written file."""
import contextlib
import json
import sys

import h5py
import numpy
from matplotlib import pyplot
from matplotlib.collections import Collection
from PIL import Image

from ..folder import FORMAT, ResultsError

ENDINGS = ("png", "pdf")

# Distinguishable with every kind of colour vision: colours of Okabe and Ito.
BLUE = "#0072B2"
VERMILLION = "#D55E00"
GREEN = "#009E73"
PURPLE = "#CC79A7"
DARK = "#333333"
GREY = "#999999"  # of marked lines
PALE = "#DDDDDD"  # of grids
COLOURS = 255     # of a PNG
SAME_TIME = 1e-6  # of the longest time step: what rounding leaves of two equal times
COLOUR_MAP = "cividis"  # of maps; distinguishable likewise


class PlotError(ResultsError):
    """Something that keeps the figure from being made; the text is for the user."""


class Foreign(Exception):
    """What results lack, or have instead, when they are not those of the wanted command."""


@contextlib.contextmanager
def open_results(path, command, lack):
    """The results of `gearfilm <command>`; `lack` is what to say of them when a group or dataset is missing."""
    if not path.exists():
        raise PlotError(f"{path} does not exist; run gearfilm {command} first")
    foreign = f"{path} is not a result of gearfilm {command}"
    try:
        with h5py.File(path) as results:
            require_format(results, path, command)
            yield results
    except OSError:
        raise PlotError(f"{path} is not an HDF5 file that can be read") from None
    except KeyError:
        raise PlotError(f"{foreign}: {lack}") from None
    except Foreign as found:
        raise PlotError(f"{foreign}: {found}") from None


def require_format(results, path, command):
    """Results of another version of the program may have the same names for something else."""
    version = results.attrs.get("format_version")
    if version != FORMAT:
        theirs = "no format version" if version is None else f"format version {read_text(version)}"
        raise PlotError(f"{path} has {theirs}, and this package reads version {FORMAT} alone; "
                        f"run gearfilm {command} again, or use the package of the gearfilm that wrote it")


def read_table(results, name, columns):
    """The rows of a table of the results, of which these columns are used."""
    table = results[name][...]
    if not set(columns) <= set(table.dtype.names or ()):
        raise Foreign(f"columns of the {name.split('/')[0]} are missing")
    return table


def of_last_period(results, rows):
    """Rows of the last whole period in the history of a periodic state; all rows of a march."""
    begin, end = (results["history"].attrs.get(name, limit)
                  for name, limit in (("periodic_from", -numpy.inf), ("periodic_to", numpy.inf)))
    rows = rows[(rows["T"] >= begin - 1e-9) & (rows["T"] <= end + 1e-9)]
    return rows


def by_contact(rows):
    """Rows of the contacts' history as one array a contact."""
    return [rows[rows["contact"] == number] for number in numpy.unique(rows["contact"])]


def read_summary(folder, command):
    """The values in FOLDER/summary.json of `gearfilm <command>`."""
    path = folder / "summary.json"
    try:
        summary = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        summary = None
    if not isinstance(summary, dict):
        raise PlotError(f"{path} is missing or not a summary; run gearfilm {command} to its end")
    return summary


def read_text(attribute):
    return attribute.decode() if isinstance(attribute, bytes) else str(attribute)


def gaps(steps):
    """Rows of a history before which a stretch of time is missing: a search leaves out what it takes from a coarser
    grid."""
    missing = steps["T"][1:] - steps["dT"][1:] - steps["T"][:-1]
    return 1 + numpy.flatnonzero(missing > SAME_TIME * steps["dT"].max())


def broken(values, rows):
    """Values of a line that has a gap before each of these rows."""
    return numpy.insert(numpy.asarray(values, dtype=float), rows, numpy.nan)


def add_grid(*panels):
    """Pale lines behind the curves."""
    for axes in panels:
        axes.grid(color=PALE, linewidth=0.6)
        axes.set_axisbelow(True)


def fill(axes, x, y, values, levels):
    """Map of the values[y, x] in steps of the levels; what is above them in the last colour."""
    filled = axes.contourf(x, y, values, levels, cmap=COLOUR_MAP, extend="both")
    # One collection of all levels since Matplotlib 3.8, before one for each.
    for part in [filled] if isinstance(filled, Collection) else filled.collections:
        part.set_edgecolor("face")  # no hair lines between the levels of the PDF
    return filled


def add_legend(axes, handles, labels, base=1.0):
    """A legend above the axes, where it hides nothing, with every label once, from the height `base` of the axes on."""
    entries = dict(zip(labels, handles))
    axes.legend(entries.values(), entries.keys(), loc="lower center", bbox_to_anchor=(0.5, base),
                ncol=min(len(entries), 5), frameon=False, fontsize=8)


def add_output(parser, name):
    """--name and --format of a figure."""
    parser.add_argument("--name", default=name, help="file name of the figure, without ending (%(default)s)")
    parser.add_argument("--format", choices=ENDINGS, nargs="+", default=ENDINGS, help="files to write; all by default")


def add_periods(parser):
    """--periods of a figure that shows the end of a march."""
    parser.add_argument("--periods", type=int, default=1, help="mesh periods drawn of a transient (default 1)")


def require_periods(periods):
    if periods < 1:
        raise PlotError("the number of mesh periods must be at least 1")


def save(figure, paths):
    """Writes the figure once for each ending; PNG with a palette, since figures have few colours."""
    for path in paths:
        figure.savefig(path, dpi=150)
        if path.suffix == ".png":
            with Image.open(path) as image:
                small = image.convert("RGB").quantize(COLOURS, kmeans=1)
            small.save(path, optimize=True)


def write_figure(folder, name, draw, endings=ENDINGS, program="gearfilm"):
    """Writes the figure that draw() returns to the folder; exit status 1, with one line, where that cannot be done."""
    paths = [folder / f"{name}.{ending}" for ending in endings]
    try:
        figure = draw()
        save(figure, paths)
        pyplot.close(figure)
    except ResultsError as error:
        sys.exit(f"{program}: {error}")
    except OSError as error:
        sys.exit(f"{program}: cannot write the figure: {error}")
    for path in paths:
        print(f"figure: {path}")


def draw_over_path(contacts, panels, height, from_zero=False):
    """Columns of contacts over their place on the line of action.

    panels: label and lines of each; a line is a column, its scale, name and colour. height: of a panel [in].
    """
    figure, axes = pyplot.subplots(len(panels), 1, sharex=True, figsize=(7, height * len(panels) + 0.6), squeeze=False,
                                   constrained_layout=True)
    for panel, (label, lines) in zip(axes[:, 0], panels):
        for column, scale, name, colour in lines:
            for number, rows in enumerate(contacts):
                order = numpy.argsort(rows["xi"])
                panel.plot(1e3 * rows["xi"][order], scale * rows[column][order], color=colour, linewidth=1.4,
                           label=name if number == 0 and name else None)
        panel.set_ylabel(label)
        if from_zero:
            panel.set_ylim(bottom=0)
        if len(lines) > 1:
            add_legend(panel, *panel.get_legend_handles_labels())
    axes[-1, 0].set_xlabel(r"position $\xi$ of the contact [mm]")
    add_grid(*axes[:, 0])
    return figure
