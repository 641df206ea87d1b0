"""Command lines made to run for a moment: on a coarse grid, with few periods and wide tolerances."""

# The thinnest films, those of slow gears, need more lines along x than other short tests have.
GRID = {"-grid_nx": "129", "-grid_ny": "33"}
MARCH = GRID | {"-time_dt": "0.05"}
SEARCH = MARCH | {"-periodic_tolerance": "0.1", "-periodic_film_tolerance": "0.9", "-periodic_multipliers": "no"}
SHORT = {"info": {}, "static": {"-static_positions": "40"}, "steady": GRID, "eigen": GRID,
         "transient": MARCH | {"-mesh_periods": "0.2"}, "periodic": SEARCH,
         "sweep": SEARCH | {"-sweep_points": "2"}, "continuation": {"-continuation_largest_step": "0.2"}}


def shortened(words):
    """The same command, case and options, but for the options that make it short."""
    command, case, *options = words
    together = dict(zip(options[::2], options[1::2])) | SHORT[command]
    return [command, case, *(word for option in together.items() for word in option)]
