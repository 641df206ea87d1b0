"""Mineral oils of the ISO classes, viscosity and pressure-viscosity coefficient from temperature.

All of it is assumption: a viscosity index of about 95, Walther's law between 40 and 100 deg C, Wooster's rule, one
density.
"""
import math

# Kinematic viscosity at 100 deg C [mm^2/s] of a class, whose number is that at 40 deg C.
VISCOSITY_AT_100 = {32: 5.4, 46: 6.8, 68: 8.7, 100: 11.2, 150: 14.7, 220: 19.0, 320: 24.0, 460: 30.5}
DENSITY = 870.0                # kg/m^3
ZERO_CELSIUS = 273.15          # K


def kinematic_viscosity(grade, celsius):
    """In m^2/s, by Walther's law (ASTM D341): log log(nu + 0.7 mm^2/s) falls linearly with the log of temperature."""
    def walther(viscosity):
        return math.log10(math.log10(viscosity + 0.7))

    def warmth(temperature):
        return math.log10(ZERO_CELSIUS + temperature)

    at_40, at_100 = walther(grade), walther(VISCOSITY_AT_100[grade])
    share = (warmth(celsius) - warmth(40)) / (warmth(100) - warmth(40))
    return 1e-6 * (10 ** 10 ** (at_40 + share * (at_100 - at_40)) - 0.7)


def viscosity(grade, celsius):
    """In Pa s."""
    return DENSITY * kinematic_viscosity(grade, celsius)


def pressure_viscosity(viscosity_pas):
    """In 1/Pa, by Wooster's rule."""
    return (0.6 + 0.965 * math.log10(1e3 * viscosity_pas)) * 1e-8
