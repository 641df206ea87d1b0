#!/usr/bin/env python3
"""Figure of a march: motion, forces and films over the length travelled, or over time where contacts are held.

    scripts/plot_march.py FOLDER [--name march] [--format png pdf]
                 reads FOLDER/results.h5, writes FOLDER/march.png and FOLDER/march.pdf

Exit status 1, with one line, where the results are missing or not those of `gearfilm transient` or `periodic`.
"""
from plotting import draw_command

if __name__ == "__main__":
    draw_command("march")
