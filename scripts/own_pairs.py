#!/usr/bin/env python3
"""Twelve pairs of gears of as many industries, all commands, and hand formulas beside.

    scripts/own_pairs.py FOLDER [--pairs NAME ...] [--commands NAME ...] [--time-limit 300] [--no-runs]

writes FOLDER/<pair>.yaml, runs the commands on them one after the other, and prints Markdown tables: the pairs, what
the program finds beside the formulas of scripts/industries/formulas.py with the deviation, and what became of every
command. Results and FOLDER/<pair>/<command>.json, what became of a run, stay. A run that is there is not made again;
one that is longer than the time limit [s] stops, and goes on the next time. Another program, or other pairs, need
another folder. --no-runs prints what there is. "bending" is static with teeth that bend, "dry" and "dry sweep" are
periodic and sweep without films.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it. Exit status 1, with one line, where a run cannot
be made or a file not be written.
"""
import argparse
import dataclasses
import json
import pathlib

from gearfilm import packages

packages.go_on_with(packages.TABLES, "own_pairs")
# pylint: disable=wrong-import-position
from industries import tables  # noqa: E402
from industries.cases import PAIRS, commands, parameters
from pairs import case_text
from runs import attempt, one_line_errors

STOPPED = 3                    # exit status of a run at its time limit


@dataclasses.dataclass(frozen=True)
class Outcome:
    """What became of a run, as its file has it."""
    status: object
    errors: str
    summary: dict

    @property
    def found(self):
        return self.summary if self.status == 0 and self.summary else {}


def outcome(pair, name, folder, time_limit):
    """Of a run that is made or goes on unless it has ended before; without a time limit none is."""
    place = folder / pair.name / name.replace(" ", "-")
    record = place.with_suffix(".json")
    before = Outcome(**json.loads(record.read_text(encoding="utf-8"))) if record.exists() else Outcome(None, "", {})
    if time_limit is None or before.status not in (None, STOPPED):
        return before
    command, *options = commands(pair)[name]
    if command not in ("info", "static", "steady"):
        options += ["-time_limit", time_limit]
    if before.status == STOPPED:
        options += ["-restart"]
    place.mkdir(parents=True, exist_ok=True)
    run = attempt(command, folder / f"{pair.name}.yaml", place, *options, time_limit=time_limit + 60)
    became = Outcome(run.status, run.errors, run.summary)
    record.write_text(json.dumps(dataclasses.asdict(became)), encoding="utf-8")
    return became


def outcomes(pair, names, folder, time_limit):
    (folder / f"{pair.name}.yaml").write_text(case_text(parameters(pair)), encoding="utf-8")
    return {name: outcome(pair, name, folder, time_limit) for name in names}


def main():
    names = [pair.name for pair in PAIRS]
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="folder of the case files and results")
    parser.add_argument("--pairs", nargs="+", choices=names, default=names, metavar="NAME", help=", ".join(names))
    every = list(commands(PAIRS[0]))
    parser.add_argument("--commands", nargs="+", choices=every, default=every, metavar="NAME", help=", ".join(every))
    parser.add_argument("--time-limit", type=float, default=300.0, help="of a run [s] (%(default)s)")
    parser.add_argument("--no-runs", action="store_true", help="print what there is")
    arguments = parser.parse_args()
    with one_line_errors("own_pairs", arguments.folder):
        arguments.folder.mkdir(parents=True, exist_ok=True)
        limit = None if arguments.no_runs else arguments.time_limit
        chosen = {pair: outcomes(pair, arguments.commands, arguments.folder, limit)
                  for pair in PAIRS if pair.name in arguments.pairs}
        tables.print_all(chosen, arguments.folder)


if __name__ == "__main__":
    main()
