"""What studies draw with. Where this Python lacks a package they go on with one that has all; else a line says so."""
import pathlib
import sys

from gearfilm import packages

STUDY = pathlib.Path(sys.argv[0]).absolute().parent.name    # scripts/studies/STUDY/run
packages.go_on_with(packages.FIGURES, STUDY)
try:
    import matplotlib
    matplotlib.use("Agg")
    import numpy
    from matplotlib import pyplot

    from gearfilm.drawing.canvas import (BLUE, DARK, GREEN, GREY, PALE, PURPLE, VERMILLION, Foreign, PlotError,
                                         add_grid, add_legend, fill, open_results, read_summary, read_table, read_text,
                                         save, write_figure)
except ImportError as missing:
    sys.exit(f"{STUDY}: {missing}; install h5py, matplotlib, numpy and pillow again")

__all__ = ["BLUE", "DARK", "GREEN", "GREY", "PALE", "PURPLE", "VERMILLION", "Foreign", "PlotError", "add_grid",
           "add_legend", "fill", "numpy", "open_results", "pyplot", "read_summary", "read_table", "read_text", "save",
           "write_figure"]
