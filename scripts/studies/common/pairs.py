"""What pairs of gears drawn at random have in common: for the catalogue and the tests."""
import math

STEEL = 7850.0                 # density [kg/m^3]


def logarithmic(draw, low, high):
    """A number whose logarithm is equally likely everywhere."""
    return math.exp(draw.uniform(math.log(low), math.log(high)))


def disc_inertia(width, radius):
    """Of a disc of steel about its axis."""
    return 0.5 * math.pi * STEEL * width * radius ** 4


def case_text(pair):
    """A case file of parameters by their dotted names."""
    return "".join(f"{name}: {value}\n" for name, value in pair.items())
