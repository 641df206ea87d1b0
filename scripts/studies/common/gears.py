"""The gears of a pair where they mesh, at true scale, from the geometry of `gearfilm info`."""
from typing import NamedTuple

from studies.common.plotting import BLUE, VERMILLION, PlotError, numpy
from studies.common.sketching import BODY_SHADE, polar

# Of teeth, what is no part of the model.
ROOT_CLEARANCE = 0.085  # of the base pitch
FILLET = 0.09           # of the base pitch, above the root circle
BACKLASH = 0.02         # of the pitch on the working pitch circle
POINTS, FILLET_POINTS = 40, 10  # of a flank, of a fillet
NEEDED = {"working_pressure_angle_deg", "base_radius_pinion", "base_radius_wheel", "base_pitch", "xi_entry", "xi_exit"}


class Gear(NamedTuple):
    """One gear; lengths in mm, the pitch point at the origin."""
    centre: numpy.ndarray
    base: float       # radii of circles
    tip: float
    root: float
    working: float
    teeth: int
    angle: float      # of the radius to the point at which the line of action touches the base circle
    curvature: float  # of the flank at the pitch point, a radius

    def outline(self, turned, teeth):
        """That many teeth on either side of the one in contact, whose radius of curvature is `turned` longer there."""
        radius, angle = self._tooth(self.angle - (self.curvature + turned) / self.base)
        turns = 2 * numpy.pi / self.teeth * numpy.arange(-teeth, teeth + 1)
        return polar(self.centre, numpy.tile(radius, turns.size), numpy.add.outer(turns, angle).ravel())

    def _tooth(self, begin):
        """Radii and angles around one pitch: flank, tip, back, root; the involute leaves its circle at `begin`.

        A thread unwound from the base circle by the angle `roll` ends on the involute, at a right angle to it.
        """
        pitch = 2 * numpy.pi / self.teeth
        low = self.root + FILLET * pitch * self.base
        radius = numpy.linspace(low, self.tip, POINTS)
        roll = numpy.sqrt(numpy.maximum((radius / self.base) ** 2 - 1, 0))
        flank = begin + roll - numpy.arctan(roll)
        middle = numpy.interp(self.working, radius, flank) + 0.25 * (1 - BACKLASH) * pitch
        # Below it a parabola, which begins as the flank ends and ends on the root circle.
        depth = low - self.root
        ahead = depth * (flank[1] - flank[0]) / (radius[1] - radius[0])
        part = numpy.linspace(0, 1, FILLET_POINTS)
        fillet_radius = self.root + depth * (1 - part) ** 2
        fillet_angle = 2 * part * (1 - part) * ahead + part ** 2 * (ahead + depth / self.root)
        back = 2 * middle - flank[::-1]
        return (numpy.concatenate([radius, radius[::-1], fillet_radius, fillet_radius[::-1]]),
                numpy.concatenate([flank, back, back[-1] + fillet_angle, flank[0] + pitch - fillet_angle[::-1]]))


class GearPair(NamedTuple):
    """The pinion below, which drives to the right, and the wheel above; lengths in mm."""
    pinion: Gear
    wheel: Gear
    direction: numpy.ndarray  # unit vector in which contacts travel
    pressure_angle: float
    base_pitch: float
    entry: float              # position on the line of action
    exit: float

    def at(self, xi):
        """Where a position on the line of action lies."""
        return numpy.multiply.outer(xi, self.direction)

    def curvatures(self, xi):
        """R_1x and R_2x: from the base circles to the contact."""
        return self.pinion.curvature + xi, self.wheel.curvature - xi


def need_gears(summary):
    """Refuses a summary of `gearfilm info` without the geometry of gears."""
    if not NEEDED <= set(summary):
        raise PlotError(f"case {summary.get('case', '')} is not that of a gear pair")


def gear_pair(summary):
    """Of `gearfilm info`. Teeth end at the tip circles, which bound the path of contact."""
    need_gears(summary)
    alpha, pitch = numpy.radians(summary["working_pressure_angle_deg"]), 1e3 * summary["base_pitch"]
    base = 1e3 * numpy.array([summary["base_radius_pinion"], summary["base_radius_wheel"]])
    entry, leaving = 1e3 * summary["xi_entry"], 1e3 * summary["xi_exit"]
    tip = numpy.hypot(base, base * numpy.tan(alpha) + [leaving, -entry])
    working = base / numpy.cos(alpha)
    root = working.sum() - tip[::-1] - ROOT_CLEARANCE * pitch
    gears = [Gear(numpy.array([0.0, side * working[n]]), base[n], tip[n], root[n], working[n],
                  round(2 * numpy.pi * base[n] / pitch), alpha - 0.5 * side * numpy.pi, base[n] * numpy.tan(alpha))
             for n, side in ((0, -1), (1, 1))]
    return GearPair(*gears, numpy.array([numpy.cos(alpha), numpy.sin(alpha)]), alpha, pitch, entry, leaving)


class DrawnGears:
    """Both gears in axes, and how they turn; so many teeth are drawn on either side of the one in contact."""

    def __init__(self, axes, pair, teeth=5):
        self.bodies = [(gear, side, min(teeth, gear.teeth // 2),
                        axes.fill([0], [0], facecolor=colour, alpha=BODY_SHADE, linewidth=0)[0],
                        axes.plot([], [], color=colour, linewidth=1.4)[0])
                       for gear, side, colour in ((pair.pinion, 1, BLUE), (pair.wheel, -1, VERMILLION))]

    def turn(self, xi):
        """Puts a pair of flanks into contact at a position [mm]."""
        for gear, side, teeth, body, line in self.bodies:
            outline = gear.outline(side * xi, teeth)
            body.set_xy(numpy.concatenate([outline, [gear.centre]]))
            line.set_data(*outline.T)
