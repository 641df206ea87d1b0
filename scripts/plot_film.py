#!/usr/bin/env python3
"""Figure of a stationary film: the film over the contact, and pressure and film along its centre line y = 0.

    scripts/plot_film.py FOLDER [--name film] [--format png pdf]
                 reads FOLDER/results.h5, writes FOLDER/film.png and FOLDER/film.pdf

Exit status 1, with one line, where the results are missing or not those of `gearfilm steady`.
"""
from plotting import draw_command

if __name__ == "__main__":
    draw_command("film")
