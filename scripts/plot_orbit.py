#!/usr/bin/env python3
"""Figure of a motion over its mesh periods: phase portrait, forces along the line of action, spectrum of H_0.

    scripts/plot_orbit.py FOLDER [--name orbit] [--format png pdf] [--periods N]
                 reads FOLDER/results.h5 and FOLDER/summary.json, writes FOLDER/orbit.png and FOLDER/orbit.pdf

Drawn is the periodic state found by `gearfilm periodic`, or the last N mesh periods (one by default) of `gearfilm
transient`. Exit status 1, with one line, where the results are missing or not those of these commands.
"""
from plotting import draw_command

if __name__ == "__main__":
    draw_command("orbit")
