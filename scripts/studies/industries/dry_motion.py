"""The dry pair's motion over one mesh period, integrated by hand: m x'' = w - sum w_k - c x' by Runge and Kutta.

x is the approach of the gears along the line of action. A contact carries w_k = (x/q_k)^(3/2) while x > 0, q_k from
formulas.hertz where it is; c = 2 zeta m 2 pi f_n.
"""
import bisect
import math

from studies.industries import formulas

DAMPING = 0.008                # zeta: the program's own for periodic motions
PLACES = 80                    # at which the contact is solved; between them straight lines
STEPS = 2000                   # in a mesh period


class Springs:
    """q(xi)^(-3/2) [N/m^(3/2)] on the path of contact."""

    def __init__(self, pair):
        self.pitch = 2 * math.pi * formulas.base_radii(pair)[0] / pair.teeth[0]
        ahead, behind = formulas.tip_ratios(pair)
        self.begin, self.end = -behind * self.pitch, ahead * self.pitch
        step = (self.end - self.begin) / PLACES
        self.places = [self.begin + n * step for n in range(PLACES + 1)]
        force = formulas.tooth_force(pair)
        self.values = [force * formulas.hertz(pair, place).approach ** -1.5 for place in self.places]

    def at(self, place):
        n = min(max(bisect.bisect(self.places, place) - 1, 0), PLACES - 1)
        share = (place - self.places[n]) / (self.places[n + 1] - self.places[n])
        return self.values[n] + share * (self.values[n + 1] - self.values[n])


def mesh_period(pair, x, v):
    """From just after a contact has left: x and v a mesh period later, the largest force on one contact over w."""
    springs, force, mass = Springs(pair), formulas.tooth_force(pair), formulas.equivalent_mass(pair)
    damper = 2 * DAMPING * mass * 2 * math.pi * formulas.natural_frequency(pair)
    period = 1 / formulas.mesh_frequency(pair)
    speed = springs.pitch / period
    # The eldest is a pitch before the end; another one is there from its entering on.
    entering = (2 * springs.pitch - (springs.end - springs.begin)) / speed
    largest = 0.0
    for low, high, contacts in ((0.0, entering, 1), (entering, period, 2)):
        steps = max(1, round(STEPS * (high - low) / period))
        dt = (high - low) / steps

        def soft(t):
            return [springs.at(springs.end - (n + 1) * springs.pitch + speed * t) for n in range(contacts)]

        for n in range(steps):
            t = low + n * dt
            stiff = [sum(soft(t)), sum(soft(t + 0.5 * dt)), sum(soft(t + dt))]

            def acceleration(place, velocity, spring):
                return (force - spring * max(place, 0.0) ** 1.5 - damper * velocity) / mass

            k1, l1 = v, acceleration(x, v, stiff[0])
            k2, l2 = v + 0.5 * dt * l1, acceleration(x + 0.5 * dt * k1, v + 0.5 * dt * l1, stiff[1])
            k3, l3 = v + 0.5 * dt * l2, acceleration(x + 0.5 * dt * k2, v + 0.5 * dt * l2, stiff[1])
            k4, l4 = v + dt * l3, acceleration(x + dt * k3, v + dt * l3, stiff[2])
            x += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
            v += dt / 6 * (l1 + 2 * l2 + 2 * l3 + l4)
            largest = max(largest, *(spring * max(x, 0.0) ** 1.5 / force for spring in soft(t + dt)))
    return x, v, largest


def repeated(pair, H0, V0):
    """How well a state just after a leaving repeats, and the largest force on one contact over w, by hand.

    H0 and V0 are in units of a^2/R_x and of a/u. The first number is the larger change of x and v/(2 pi f_n), over the
    Hertz approach.
    """
    contact, length = formulas.hertz(pair), formulas.hertz(pair).a ** 2 / formulas.radii(pair)[0]
    time = contact.a / formulas.entrainment(pair)
    x, v = -H0 * length, -V0 * length / time
    later, faster, largest = mesh_period(pair, x, v)
    swing = abs(faster - v) / (2 * math.pi * formulas.natural_frequency(pair))
    return max(abs(later - x), swing) / contact.approach, largest
