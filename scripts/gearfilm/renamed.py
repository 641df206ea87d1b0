#!/usr/bin/env python3
"""Stands where scripts of earlier versions stood: says by which command the figure is drawn now; exit status 1."""
import pathlib
import shlex
import sys

KINDS = {"compare_runs": "compare", "animate_march": "animation"}


def main():
    old = pathlib.Path(sys.argv[0])
    kind = KINDS.get(old.stem, old.stem.removeprefix("plot_"))
    words = shlex.join(sys.argv[1:]) or "FOLDER"
    sys.exit(f"{old.name}: this is now PYTHONPATH={old.parent} python3 -m gearfilm plot {kind} {words}")


if __name__ == "__main__":
    main()
