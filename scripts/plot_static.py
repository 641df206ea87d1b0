#!/usr/bin/env python3
"""Figure of the dry pair turned slowly: transmission error, load shares and mesh stiffness under several loads.

    scripts/plot_static.py FOLDER [--name static] [--format png pdf]
                 reads FOLDER/results.h5, writes FOLDER/static.png and FOLDER/static.pdf

Exit status 1, with one line, where the results are missing or not those of `gearfilm static`.
"""
from plotting import draw_command

if __name__ == "__main__":
    draw_command("static")
