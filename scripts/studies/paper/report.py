#!/usr/bin/env python3
"""Closing table of the demonstration: what gearfilm computed beside what the paper prints.

    scripts/studies/paper/report.py FOLDER

reads FOLDER/info, FOLDER/steady and FOLDER/transient, the results of these commands.

The paper is Barbieri, Lubrecht, Pellicano, Tribology International 62 (2013) 37-48,
doi 10.1016/j.triboint.2013.01.017. Exit status 1, with one line, where results are missing or not gearfilm's.
"""
import argparse
import json
import math
import pathlib
import sys
from typing import NamedTuple

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
# pylint: disable=wrong-import-position
from studies.paper import printed  # noqa: E402


class Row(NamedTuple):
    """A quantity: its key in a summary ("list.0.name" for nested ones), its value in the paper, how both are printed."""
    label: str
    key: str
    paper: float
    unit: str = ""
    scale: float = 1.0  # from the summary's SI value to the unit
    digits: int = 3     # after the decimal point


class Section(NamedTuple):
    """The rows that come from one run."""
    folder: str
    title: str
    rows: list


SECTIONS = [
    Section("info", "The pair at the pitch point", [
        Row("load group M", "M", printed.M, digits=2),
        Row("lubricant group L", "L", printed.L, digits=2),
        Row("radius ratio D", "D", printed.D, digits=4),
        Row("dimensionless inertia I_n", "I_n", printed.I_N, digits=2),
        Row("natural frequency f_n", "f_n", printed.NATURAL_FREQUENCY, "Hz", digits=0),
        Row("mesh frequency f_m", "f_m", printed.MESH_FREQUENCY, "Hz", digits=0),
    ]),
    Section("steady", "Stationary film at the pitch point", [
        Row("central film h_central", "h_central", printed.STEADY_CENTRAL, "um", 1e6),
        Row("smallest film h_min", "h_min", printed.STEADY_SMALLEST, "um", 1e6),
    ]),
    Section("transient", "First two mesh periods, from rest", [
        Row("first loss of contact after", "contact_losses.0.distance", printed.FIRST_LOSS, "mm", 1e3, digits=2),
    ]),
]


class ReportError(Exception):
    """Something that keeps the table from being made; the text is for the user."""


def read_summary(path):
    try:
        summary = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise ReportError(f"{path} does not exist; run scripts/demo.sh first") from None
    except OSError as error:
        raise ReportError(f"{path} cannot be read: {error.strerror}") from None
    except ValueError:
        raise ReportError(f"{path} is not a summary of gearfilm: no JSON") from None
    if not isinstance(summary, dict):
        raise ReportError(f"{path} is not a summary of gearfilm: no named values")
    return summary


def value_of(summary, key, path):
    value = summary
    for name in key.split("."):
        try:
            value = value[int(name)] if isinstance(value, list) else value.get(name)
        except (IndexError, ValueError, AttributeError):
            value = None
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise ReportError(f"{path} is not a summary of this run: it has no number '{key}'")
    return value


def table_lines(folder):
    form = "{:<34} | {:>10} | {:>10} | {:>9}"
    yield form.format("quantity", "gearfilm", "paper", "deviation")
    for section in SECTIONS:
        path = folder / section.folder / "summary.json"
        summary = read_summary(path)
        grid = f", {summary['nx']} x {summary['ny']} nodes" if "nx" in summary and "ny" in summary else ""
        yield section.title + grid
        for row in section.rows:
            value = value_of(summary, row.key, path)
            deviation = round(100 * (value / row.paper - 1), 2) + 0.0  # + 0.0: no "-0.00"
            label = f"  {row.label}" + (f" [{row.unit}]" if row.unit else "")
            yield form.format(label, f"{row.scale * value:.{row.digits}f}", f"{row.scale * row.paper:.{row.digits}f}",
                              f"{deviation:+.2f} %")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="folder with the results of scripts/demo.sh")
    folder = parser.parse_args().folder
    try:
        lines = list(table_lines(folder))
    except ReportError as error:
        sys.exit(f"report: {error}")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
