"""Animation of a mesh cycle: film and pressure of the contacts in mesh, the force and the motion beside them."""
import numpy
from matplotlib import animation, pyplot

from .canvas import BLUE, COLOUR_MAP, DARK, VERMILLION, PlotError, add_grid, broken, gaps

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
        missing = gaps(steps)
        behind = numpy.searchsorted(own["step"], steps["step"][missing])
        self.line.plot(broken(1e3 * own["xi"], behind), broken(1e-3 * own["force"], behind), color=BLUE)
        self.line.set(xlabel="position on the line of action [mm]", ylabel="force on the contact [kN]")
        seconds = numpy.array([times[step] for step in own["step"]])
        around = (steps["t"] >= seconds.min()) & (steps["t"] <= seconds.max())
        behind = numpy.searchsorted(steps["step"][around], steps["step"][missing])
        self.motion.plot(broken(1e3 * steps["t"][around], behind), broken(steps["H0"][around], behind), color=DARK)
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


def write_cycle(run, path, contact=None):
    """Writes the animation, GIF or MP4 by the ending of the path."""
    cycle = Cycle(run, choose(run, contact))
    if path.suffix == ".mp4" and not animation.writers.is_available("ffmpeg"):
        raise PlotError("mp4 needs ffmpeg, which is not installed; write a gif")
    movie = animation.FuncAnimation(cycle.figure, cycle.show, frames=len(cycle.films))
    movie.save(path, writer="ffmpeg" if path.suffix == ".mp4" else "pillow", fps=FRAMES_A_SECOND, dpi=80)
    pyplot.close(cycle.figure)
