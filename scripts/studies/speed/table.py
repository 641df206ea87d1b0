#!/usr/bin/env python3
"""What kernels cost, of one or several measurements of `gearfilm bench`: the smallest of each, as a Markdown table.

    scripts/studies/speed/table.py FOLDER ... [--publish]      folders with the summary.json of gearfilm bench

In convolution times of the same measurement, but for the convolution itself, which is in ms; in the last column ns per
node on the smallest grid. --publish writes the table to docs/data/speed_kernels.md too. Exit status 1, with one line,
where a summary is missing or not that of bench.
"""
import argparse
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
# pylint: disable=wrong-import-position
from studies.common.runs import RunError, one_line_errors  # noqa: E402
from studies.common.tables import add_publish, heading, row, sheet  # noqa: E402

KERNELS = {"stationary film": "stationary film from nothing, all grids",
           "deformation, single": "deformation, single precision",
           "smoother factors, single": "stencil and smoother factors of one level, single precision",
           "smoother sweep, single": "one smoother sweep, single precision",
           "deformation, double": "deformation, double precision",
           "film and residual": "film, oil and Reynolds residual",
           "linearisation, all levels": "linearisation and smoother factors, all levels",
           "Jacobian application": "Jacobian times vector",
           "V-cycle": "one V(1,1) cycle"}


def grids_of(folder):
    """The grids of a measurement; of each its convolution time, and its kernels by name."""
    path = folder / "summary.json"
    try:
        grids = json.loads(path.read_text(encoding="utf-8"))["grids"]
        return [grid | {"kernels": {line["kernel"]: line for line in grid["rows"]}} for grid in grids]
    except OSError as error:
        raise RunError(f"{path} cannot be read: {error.strerror}; run gearfilm bench first") from None
    except (ValueError, KeyError, TypeError):
        raise RunError(f"{path} is not a summary of gearfilm bench") from None


def times(value):
    return f"{value:.0f}" if value >= 10 else f"{value:.2f}"


def nanoseconds(value):
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}"


def say_table(measurements, say):
    """Of measurements on the same grids."""
    grids = list(zip(*measurements))
    smallest = grids[0]
    nodes = smallest[0]["nx"] * smallest[0]["ny"]
    titles = [f"{grid[0]['nx']} x {grid[0]['ny']}" for grid in grids]
    units = [min(grid["convolution_time"] for grid in same) for same in grids]
    say(heading("kernel", *titles, f"ns per node, {titles[0]}"))
    say(row("the unit: one convolution", *(f"{1e3 * unit:.3g} ms" for unit in units), nanoseconds(1e9 * units[0] / nodes)))
    for kernel, title in KERNELS.items():
        found = [[grid["kernels"][kernel] for grid in same if kernel in grid["kernels"]] for same in grids]
        say(row(title, *(times(min(line["convolutions"] for line in lines)) if lines else "" for lines in found),
                nanoseconds(min(line["ns_per_node"] for line in found[0])) if found[0] else ""))


def main():
    parser = argparse.ArgumentParser(prog="scripts/studies/speed/table.py", description=__doc__.split("\n", 1)[0])
    parser.add_argument("folders", type=pathlib.Path, nargs="+", metavar="FOLDER", help="of gearfilm bench")
    add_publish(parser)
    arguments = parser.parse_args()
    with one_line_errors("table", "docs/data"), sheet("speed_kernels", arguments.publish) as say:
        say_table([grids_of(folder) for folder in arguments.folders], say)


if __name__ == "__main__":
    main()
