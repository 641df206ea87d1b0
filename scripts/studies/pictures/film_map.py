"""Colours of films in maps: those of the package, and a pale one where oil is thick."""
import copy

from studies.common.plotting import numpy, pyplot

from gearfilm.drawing.canvas import COLOUR_MAP  # after plotting, which says what is missing

LEVELS = numpy.linspace(1.8, 3.6, 10)  # µm
THICK = "#E6EEF3"


def film_colours():
    """A colour map that leaves films above the levels pale."""
    colours = copy.copy(pyplot.get_cmap(COLOUR_MAP))
    colours.set_over(THICK)
    return colours
