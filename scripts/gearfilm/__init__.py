"""Results of gearfilm in Python: open the folder of a run, run the program, export tables, make a report.

    import gearfilm
    run = gearfilm.open("output/periodic")              # or gearfilm.run("input/barbieri2013.yaml", "periodic")
    run.summary["force_ratio_max"], run.parameters["grid.nx"]
    steps = run.table("history/steps")                  # structured array, SI; run.frame(...) gives a DataFrame
    film = run.film(xi=0.0)                             # the stored film nearest to a place, mm, um and GPa
    run.fields(), run.forces()                          # all films as xarray, forces [N] over positions [mm]
    run.draw().savefig("march.pdf")                     # a matplotlib figure; gearfilm.drawing has all kinds

    python3 -m gearfilm export FOLDER [TABLE]           CSV
    python3 -m gearfilm report FOLDER                   one HTML page
    python3 -m gearfilm plot KIND FOLDER                a figure, PNG and PDF
"""
import importlib

# Found when they are asked for: a Python that lacks a package can then say so (packages).
_HOMES = {"Film": "folder", "Parameter": "folder", "ResultsError": "folder", "RunFolder": "folder", "run": "running"}

__all__ = ["open", *_HOMES]  # pylint: disable=undefined-all-variable


def __getattr__(name):
    if name not in _HOMES:
        raise AttributeError(f"module 'gearfilm' has no attribute '{name}'")
    return getattr(importlib.import_module(f".{_HOMES[name]}", __name__), name)


def open(folder):  # pylint: disable=redefined-builtin
    """The results in the folder of a run."""
    return __getattr__("RunFolder")(folder)
