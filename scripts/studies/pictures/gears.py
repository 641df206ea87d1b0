"""The gears of a pair where they mesh, at true scale: involute flanks, the line of action, the contacts on it."""
from typing import NamedTuple

import numpy

from gearfilm.drawing.canvas import BLUE, DARK, GREY, VERMILLION
from sketch import TINT

# Of teeth, what is no part of the model.
ROOT_CLEARANCE = 0.085  # of the base pitch
FILLET = 0.09           # of the base pitch, above the root circle
BACKLASH = 0.02         # of the pitch on the working pitch circle
POINTS = 40             # of a flank
TEETH_DRAWN = 5         # on either side


def polar(radius, angle):
    return numpy.stack([radius * numpy.cos(angle), radius * numpy.sin(angle)], axis=-1)


class Gear(NamedTuple):
    """One gear; lengths in mm, the pitch point at the origin."""
    centre: numpy.ndarray
    base: float
    tip: float
    root: float
    working: float  # radius of the working pitch circle
    teeth: int
    angle: float    # of the radius to the point at which the line of action touches the base circle
    curvature: float  # of the flank at the pitch point, a radius

    def outline(self, turned):
        """Teeth near the pitch point, with the radius of curvature `turned` longer there than at the pitch point."""
        step = 2 * numpy.pi / self.teeth
        radius, angle = self._tooth(self.angle - (self.curvature + turned) / self.base)
        turns = step * numpy.arange(-TEETH_DRAWN, TEETH_DRAWN + 1)
        return self.centre + polar(numpy.tile(radius, turns.size), numpy.add.outer(turns, angle).ravel())

    def _tooth(self, begin):
        """Radii and angles around one pitch: flank, tip, back, root; the involute leaves its circle at `begin`."""
        low = self.root + FILLET * 2 * numpy.pi * self.base / self.teeth
        radius = numpy.linspace(low, self.tip, POINTS)
        roll = numpy.sqrt(numpy.maximum((radius / self.base) ** 2 - 1, 0))
        flank = begin + roll - numpy.arctan(roll)
        pitch = 2 * numpy.pi / self.teeth
        middle = numpy.interp(self.working, radius, flank) + 0.25 * (1 - BACKLASH) * pitch
        quarter = numpy.linspace(0, 0.5 * numpy.pi, 10)
        fillet_radius = low - (low - self.root) * numpy.sin(quarter)
        fillet_angle = (low - self.root) / self.root * (1 - numpy.cos(quarter))
        back = 2 * middle - flank[::-1]
        ahead, behind = back[-1] + fillet_angle, flank[0] + pitch - fillet_angle[::-1]
        return (numpy.concatenate([radius, radius[::-1], fillet_radius, fillet_radius[::-1]]),
                numpy.concatenate([flank, back, ahead, behind]))


class GearPair(NamedTuple):
    """The pinion below, which drives, and the wheel above."""
    pinion: Gear
    wheel: Gear
    direction: numpy.ndarray  # in which contacts travel
    entry: float              # position on the line of action [mm]
    exit: float

    def at(self, xi):
        """Where a position on the line of action lies."""
        return numpy.multiply.outer(xi, self.direction)


def gear_pair(summary):
    """Of `gearfilm info`. Teeth end at the tip circles, which bound the path of contact."""
    alpha, pitch = numpy.radians(summary["working_pressure_angle_deg"]), 1e3 * summary["base_pitch"]
    base = 1e3 * numpy.array([summary["base_radius_pinion"], summary["base_radius_wheel"]])
    entry, leaving = 1e3 * summary["xi_entry"], 1e3 * summary["xi_exit"]
    tip = numpy.hypot(base, base * numpy.tan(alpha) + [leaving, -entry])
    working = base / numpy.cos(alpha)
    root = working.sum() - tip[::-1] - ROOT_CLEARANCE * pitch
    gears = [Gear(numpy.array([0.0, side * working[n]]), base[n], tip[n], root[n], working[n],
                  round(2 * numpy.pi * base[n] / pitch), alpha - 0.5 * side * numpy.pi, base[n] * numpy.tan(alpha))
             for n, side in ((0, -1), (1, 1))]
    return GearPair(*gears, numpy.array([numpy.cos(alpha), numpy.sin(alpha)]), entry, leaving)


class DrawnPair:
    """Both gears in axes at true scale, and how they turn."""

    def __init__(self, axes, pair, middle, half):
        self.pair = pair
        axes.set_aspect("equal")
        axes.set_xlim(middle[0] - half[0], middle[0] + half[0])
        axes.set_ylim(middle[1] - half[1], middle[1] + half[1])
        self.bodies = [(gear, side, axes.fill([0], [0], facecolor=colour, alpha=TINT, linewidth=0)[0],
                        axes.plot([], [], color=colour, linewidth=1.4)[0])
                       for gear, side, colour in ((pair.pinion, 1, BLUE), (pair.wheel, -1, VERMILLION))]
        reach = numpy.array([pair.entry - 3, pair.exit + 3])
        axes.plot(*pair.at(reach).T, color=GREY, linewidth=1, linestyle="--", zorder=3)
        axes.plot(*pair.at(numpy.array([pair.entry, pair.exit])).T, color=DARK, linewidth=1.6, zorder=3)

    def turn(self, xi):
        """Puts a pair of flanks into contact at a position [mm]."""
        for gear, side, body, line in self.bodies:
            outline = gear.outline(side * xi)
            body.set_xy(numpy.concatenate([outline, [gear.centre]]))
            line.set_data(*outline.T)
