#!/usr/bin/env python3
"""Figure of a film: the film over the contact, and pressure and film along its centre line y = 0.

    scripts/plot_film.py FOLDER [--name film] [--format png pdf] [--at XI]
                 reads FOLDER/results.h5, writes FOLDER/film.png and FOLDER/film.pdf; of a march that stores films it
                 draws the one nearest to XI (in mm from the pitch point; default 0)

Exit status 1, with one line, where the results are missing or have no film.
"""
from plotting import draw_command

if __name__ == "__main__":
    draw_command("film")
