"""The periodic state that the pictures show: one mesh cycle of it, which may be repeated."""
import gearfilm
from studies.common.gears import gear_pair
from studies.common.plotting import numpy

FRAMES = 40  # stored films in a mesh cycle
OPTIONS = {"output.snapshot_interval": 1 / FRAMES, "periodic.multipliers": False}


class PeriodicPair:
    """One mesh cycle, from the moment at which a contact has left to the next; mm, µm, GPa, kN."""

    def __init__(self, case, folder):
        """Reads what the folder holds of the case, and computes what it lacks."""
        info = gearfilm.run(case, "info", folder / "info").summary
        place = folder / "periodic"
        run = gearfilm.open(place) if (place / "summary.json").exists() else gearfilm.run(
            case, "periodic", place, **OPTIONS)
        self.gears = gear_pair(info)
        self.speed_rpm = run.parameters["pinion.speed_rpm"].value
        self.period = 1e3 * run.summary["mesh_period"]  # [ms]
        films = [film for film in run.films() if numpy.isfinite(film.time)]
        times = sorted({film.time for film in films})[-FRAMES:]
        self.moments = [sorted((film for film in films if film.time == time), key=lambda film: -film.xi)
                        for time in times]
        steps, contacts = run.table("history/steps"), run.table("history/contacts")
        within = steps["t"] > steps["t"][-1] - run.summary["mesh_period"] * (1 + 1e-9)
        self.time = 1e3 * (steps["t"][within] - steps["t"][-1]) + self.period
        self.transmission_error = 1e6 * steps["transmission_error"][within]
        self.static_force = 1e-3 * run.summary["static_force"]
        rows = contacts[contacts["t"] > steps["t"][-1] - run.summary["mesh_period"] * (1 + 1e-9)]
        self.force = {}  # of the contact that leads and of the one that follows: time [ms], position, force
        for order, film in enumerate(self.moments[-1]):
            own = rows[rows["contact"] == film.contact]
            time = 1e3 * (own["t"] - steps["t"][-1]) + self.period
            self.force[order] = time, 1e3 * own["xi"], 1e-3 * own["force"]

    def at_moment(self, films):
        """Time of these films from the beginning of the cycle [ms]."""
        last = self.moments[-1][0].time
        return self.period - 1e3 * (last - films[0].time)
