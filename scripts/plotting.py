"""What scripts draw with. Where this Python lacks a package they go on with one that has all; else a line says so."""
import pathlib
import sys

from gearfilm import packages

packages.go_on_with(packages.FIGURES, pathlib.Path(sys.argv[0]).stem)
try:
    import matplotlib
    matplotlib.use("Agg")
    import numpy
    from matplotlib import pyplot

    from gearfilm.drawing import command as draw_command
    from gearfilm.drawing.canvas import (BLUE, DARK, GREEN, GREY, PALE, VERMILLION, Foreign, PlotError, add_grid, add_legend,
                                         fill, open_results, read_summary, read_table, read_text, save, write_figure)
except ImportError as missing:
    sys.exit(f"{pathlib.Path(sys.argv[0]).stem}: {missing}; install h5py, matplotlib, numpy and pillow anew")

__all__ = ["BLUE", "DARK", "GREEN", "GREY", "PALE", "VERMILLION", "Foreign", "PlotError", "add_grid", "add_legend",
           "draw_command", "fill", "numpy", "open_results", "pyplot", "read_summary", "read_table", "read_text", "save",
           "write_figure"]
