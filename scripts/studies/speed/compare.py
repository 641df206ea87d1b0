#!/usr/bin/env python3
"""Two measurements of `gearfilm bench` beside each other, in convolution times of their own runs.

    scripts/studies/speed/compare.py BEFORE AFTER      folders with the summary.json of gearfilm bench

Exit status 1, with one line, where a summary is missing or not that of bench.
"""
import argparse
import json
import pathlib
import sys


class CompareError(Exception):
    """Something that keeps the table from being made; the text is for the user."""


def read_units(folder):
    """Units of every kernel on every grid, and of a contact-step: {(grid, kernel): convolution times}."""
    path = folder / "summary.json"
    try:
        summary = json.loads(path.read_text(encoding="utf-8"))
        units = {(f"{grid['nx']} x {grid['ny']}", row["kernel"]): row["convolutions"]
                 for grid in summary["grids"] for row in grid["rows"]}
    except OSError as error:
        raise CompareError(f"{path} cannot be read: {error.strerror}; run gearfilm bench first") from None
    except (ValueError, KeyError, TypeError):
        raise CompareError(f"{path} is not a summary of gearfilm bench") from None
    if "contact_step_convolutions" in summary:
        units["mesh period", "contact-step"] = summary["contact_step_convolutions"]
    return units


def table_lines(before, after):
    """One line a measurement that both have."""
    common = [key for key in before if key in after]
    if not common:
        raise CompareError("the two measurements have no kernel in common")
    form = "{:<12} | {:<28} | {:>9} | {:>9} | {:>7}"
    yield form.format("grid", "kernel", "before", "after", "ratio")
    for grid, kernel in common:
        old, new = before[grid, kernel], after[grid, kernel]
        yield form.format(grid, kernel, f"{old:.3g}", f"{new:.3g}", f"{new / old:.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    for name in ("before", "after"):
        parser.add_argument(name, type=pathlib.Path, help="folder of gearfilm bench")
    arguments = parser.parse_args()
    try:
        lines = list(table_lines(read_units(arguments.before), read_units(arguments.after)))
    except CompareError as error:
        sys.exit(f"compare: {error}")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
