#!/usr/bin/env python3
"""Animation of a mesh cycle: film and pressure of the contacts in mesh, the force and the motion beside them.

    scripts/animate_march.py FOLDER [--name cycle] [--contact N] [--format gif|mp4]   mp4 needs ffmpeg

Reads the snapshots in FOLDER/results.h5 of `gearfilm periodic`, or of `transient` with -output_snapshot_interval, and
follows one contact from its first to its last snapshot. Exit status 1, with one line, where there are none.
"""
import argparse
import pathlib
import sys

import plotting  # noqa: F401  pylint: disable=unused-import  (first: it says what is missing)
import gearfilm
from gearfilm.drawing.cycle import write_cycle


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="folder with results.h5 of gearfilm periodic or transient")
    parser.add_argument("--name", default="cycle", help="file name of the animation, without ending")
    parser.add_argument("--contact", type=int, help="its number; that with most snapshots by default")
    parser.add_argument("--format", choices=("gif", "mp4"), default="gif")
    arguments = parser.parse_args()
    path = arguments.folder / f"{arguments.name}.{arguments.format}"
    try:
        write_cycle(gearfilm.open(arguments.folder), path, arguments.contact)
    except gearfilm.ResultsError as error:
        sys.exit(f"animate_march: {error}")
    except OSError as error:
        sys.exit(f"animate_march: cannot write {path}: {error}")
    print(f"animation: {path}")


if __name__ == "__main__":
    main()
