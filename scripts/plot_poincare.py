#!/usr/bin/env python3
"""Figure of a march's recurrence: its motion once a mesh period, just after a contact has left.

    scripts/plot_poincare.py FOLDER [--name poincare] [--format png pdf]
                 reads FOLDER/results.h5, writes FOLDER/poincare.png and FOLDER/poincare.pdf

Exit status 1, with one line, where the results are missing or not those of `gearfilm transient`.
"""
from plotting import draw_command

if __name__ == "__main__":
    draw_command("poincare")
