#!/usr/bin/env python3
"""Figure of friction and heat: coefficient, losses and temperatures over the line of action, and along one contact.

    scripts/plot_friction.py FOLDER [--name friction] [--format png pdf] [--at XI]
                 reads FOLDER/results.h5 of a march or a periodic state with friction, writes FOLDER/friction.png and
                 .pdf; the temperatures along y = 0 are those of the stored contact nearest to XI (in mm; default 2).
                 Of a film at rest with heat (`steady`): temperatures along y = 0, and across the film there

Exit status 1, with one line, where the results are missing or have no friction.
"""
from plotting import draw_command

if __name__ == "__main__":
    draw_command("friction")
