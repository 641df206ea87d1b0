#!/usr/bin/env python3
"""Figure of a continuation: branches of periodic states, stable ones full, unstable ones dashed, bifurcations marked.

    scripts/plot_branch.py FOLDER [--name branch] [--format png pdf] [--marches MARCHED ...]
                 reads FOLDER/results.h5, writes FOLDER/branch.png and FOLDER/branch.pdf; with a dot for every mesh
                 period of marches: of a sweep with sweep.kind marches, or of transients, run-ups among them

Exit status 1, with one line, where the results are missing or not those of `gearfilm continuation`.
"""
from plotting import draw_command

if __name__ == "__main__":
    draw_command("branch")
