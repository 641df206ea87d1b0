#!/usr/bin/env python3
"""Animation of a mesh cycle: film and pressure of the contacts in mesh, the force and the motion beside them.

    scripts/animate_march.py FOLDER [--name cycle] [--contact N] [--format gif|mp4]   mp4 needs ffmpeg

Reads the snapshots in FOLDER/results.h5 of `gearfilm periodic`, or of `transient` with -output_snapshot_interval, and
follows one contact from its first to its last snapshot. Exit status 1, with one line, where there are none.
"""
import sys

from matplotlib import animation

import gearfilm
from plotting import BLUE, COLOUR_MAP, DARK, VERMILLION, PlotError, add_grid, command_line, numpy, pyplot

FRAMES_A_SECOND = 8


def choose(run, number):
    """The films of one contact in time; of that with most snapshots where none is asked for."""
    films = [film for film in run.films() if numpy.isfinite(film.time)]
    numbers = [film.contact for film in films]
    if not numbers:
        raise PlotError(f"{run.folder} has no snapshots of a march; run with -output_snapshot_interval 0.05")
    chosen = max(set(numbers), key=numbers.count) if number is None else number
    if chosen not in numbers:
        raise PlotError(f"{run.folder} has no snapshot of contact {chosen}; it has {sorted(set(numbers))}")
    return sorted((film for film in films if film.contact == chosen), key=lambda film: film.time)


class Cycle:
    """The panels, and what changes in them from frame to frame."""

    def __init__(self, run, films):
        self.films = films
        steps, contacts = run.table("history/steps"), run.table("history/contacts")
        own = contacts[contacts["contact"] == films[0].contact]
        times = dict(zip(steps["step"], steps["t"]))
        self.figure, axes = pyplot.subplots(2, 2, figsize=(9, 6), constrained_layout=True)
        self.maps, (self.line, self.motion) = axes[0], axes[1]
        self.top = {"pressure": max(film.pressure.max() for film in films),
                    "thickness": 3 * numpy.median([numpy.median(film.thickness[film.pressure > 0.1])
                                                   for film in films if (film.pressure > 0.1).any()] or [1.0])}
        self.line.plot(1e3 * own["xi"], 1e-3 * own["force"], color=BLUE)
        self.line.set(xlabel="position on the line of action [mm]", ylabel="force on the contact [kN]")
        seconds = numpy.array([times[step] for step in own["step"]])
        around = (steps["t"] >= seconds.min()) & (steps["t"] <= seconds.max())
        self.motion.plot(1e3 * steps["t"][around], steps["H0"][around], color=DARK)
        self.motion.set(xlabel="time [ms]", ylabel="$H_0$ [-]")
        add_grid(self.line, self.motion)
        self.here = self.line.axvline(films[0].xi, color=VERMILLION)
        self.now = self.motion.axvline(1e3 * films[0].time, color=VERMILLION)

    def show(self, number):
        film = self.films[number]
        for axes, name, unit in zip(self.maps, ("pressure", "thickness"), ("GPa", "µm")):
            axes.clear()
            axes.pcolormesh(film.y, film.x, getattr(film, name), cmap=COLOUR_MAP, vmin=0, vmax=self.top[name],
                            shading="nearest")
            axes.set(xlabel="y [mm]", ylabel="x [mm]", title=f"{name}, up to {self.top[name]:.2g} {unit}")
        self.here.set_xdata([film.xi, film.xi])
        self.now.set_xdata([1e3 * film.time] * 2)


def main():
    parser = command_line(__doc__, "periodic", "cycle")
    parser.add_argument("--contact", type=int, help="its number; that with most snapshots by default")
    parser.add_argument("--format", choices=("gif", "mp4"), default="gif")
    arguments = parser.parse_args()
    path = arguments.folder / f"{arguments.name}.{arguments.format}"
    try:
        run = gearfilm.open(arguments.folder)
        cycle = Cycle(run, choose(run, arguments.contact))
        if arguments.format == "mp4" and not animation.writers.is_available("ffmpeg"):
            raise PlotError("mp4 needs ffmpeg, which is not installed; use --format gif")
        movie = animation.FuncAnimation(cycle.figure, cycle.show, frames=len(cycle.films))
        movie.save(path, writer="pillow" if arguments.format == "gif" else "ffmpeg", fps=FRAMES_A_SECOND, dpi=80)
    except (PlotError, gearfilm.ResultsError) as error:
        sys.exit(f"animate_march: {error}")
    except OSError as error:
        sys.exit(f"animate_march: cannot write {path}: {error}")
    print(f"animation: {path}")


if __name__ == "__main__":
    main()
