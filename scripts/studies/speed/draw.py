#!/usr/bin/env python3
"""Draws what kernels cost: bars of docs/performance.md from the table docs/data/speed_kernels.md.

    scripts/studies/speed/draw.py TABLE PICTURE.png

The table has a kernel a row and a grid a column, in convolution times; of its rows those in one grid of `bench` are
drawn but for the first one (the unit) and the whole film, for the smallest and the largest grid. Exit status 1, with
one line, where the table cannot be read.
"""
import argparse
import pathlib
import sys

from matplotlib import pyplot

FIRST_KERNEL = 2           # behind the unit and the whole film
COLOURS = ("#0072b2", "#d55e00")


def table_of(path):
    """Titles of the grids, and a name and values for each kernel."""
    rows = [[cell.strip() for cell in line.strip("|\n").split("|")]
            for line in path.read_text(encoding="utf-8").splitlines() if line.startswith("| ")]
    grids, kernels = rows[0][1:-1], rows[1 + FIRST_KERNEL:]
    return grids, [(row[0], [float(value) for value in row[1:len(grids) + 1]]) for row in kernels]


def draw(grids, kernels, picture):
    figure, axes = pyplot.subplots(figsize=(7, 3.4), constrained_layout=True)
    names = [name for name, _ in kernels][::-1]
    for shift, column, colour in ((0.2, 0, COLOURS[0]), (-0.2, len(grids) - 1, COLOURS[1])):
        values = [row[column] for _, row in kernels][::-1]
        axes.barh([place + shift for place in range(len(names))], values, height=0.38, color=colour,
                  label=f"{grids[column]} nodes")
    axes.set_yticks(range(len(names)), labels=names)
    axes.set_xlabel("convolution times")
    axes.axvline(1, color="0.4", linewidth=0.8, linestyle="--")
    axes.legend(frameon=False, loc="upper right")
    figure.savefig(picture, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    arguments = parser.parse_args()
    try:
        grids, kernels = table_of(arguments.table)
    except (OSError, ValueError, IndexError) as error:
        sys.exit(f"draw: {arguments.table}: {error}")
    draw(grids, kernels, arguments.picture)


if __name__ == "__main__":
    main()
