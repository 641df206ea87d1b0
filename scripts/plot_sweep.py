#!/usr/bin/env python3
"""Figure of a sweep: its periodic states on the way up and down, its marches as dots, or its basins.

    scripts/plot_sweep.py FOLDER [--name sweep] [--format png pdf]
                 reads FOLDER/results.h5, writes FOLDER/sweep.png and FOLDER/sweep.pdf

Exit status 1, with one line, where the results are missing or not those of `gearfilm sweep`.
"""
from plotting import draw_command

if __name__ == "__main__":
    draw_command("sweep")
