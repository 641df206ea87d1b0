"""What scripts draw with; a package that is missing is said here, in one line."""
import pathlib
import sys

try:
    import matplotlib
    matplotlib.use("Agg")
    import numpy
    from matplotlib import pyplot

    from gearfilm.drawing import command as draw_command
    from gearfilm.drawing.canvas import (BLUE, DARK, GREEN, GREY, PALE, VERMILLION, Foreign, PlotError, add_grid, add_legend,
                                         fill, open_results, read_summary, read_table, read_text, save, write_figure)
except ImportError as missing:
    sys.exit(f"{pathlib.Path(sys.argv[0]).stem}: {missing}; needs h5py, matplotlib, numpy, pillow (as /usr/bin/python3 has "
             "after scripts/setup.sh)")

__all__ = ["BLUE", "DARK", "GREEN", "GREY", "PALE", "VERMILLION", "Foreign", "PlotError", "add_grid", "add_legend",
           "draw_command", "fill", "numpy", "open_results", "pyplot", "read_summary", "read_table", "read_text", "save",
           "write_figure"]
