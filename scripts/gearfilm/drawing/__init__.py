"""Figures of results: one module for each kind, drawn from the folder of a run.

    import gearfilm
    gearfilm.open(FOLDER).draw()                      # the usual figure of its command
    gearfilm.open(FOLDER).draw("orbit", periods=2)    # one of KINDS, with the options of its module

    python3 -m gearfilm plot KIND FOLDER [options]    writes FOLDER/KIND.png and .pdf
"""
import importlib
import pathlib

from ..folder import ResultsError

# Commands whose results are drawn, the usual one first.
KINDS = {"film": "steady, or a march with films", "march": "transient or periodic", "orbit": "periodic or transient",
         "poincare": "transient", "sweep": "sweep", "branch": "continuation", "static": "static",
         "friction": "transient, periodic or steady"}
USUAL = {"steady": ("film",), "transient": ("march",), "periodic": ("orbit", "march", "film"), "sweep": ("sweep",),
         "continuation": ("branch",), "static": ("static",)}


def module_of(kind):
    """What draws a kind. Raises ResultsError where there is none, or where a package that figures need is missing."""
    if kind not in KINDS:
        raise ResultsError(f"no figure '{kind}'; there are {', '.join(KINDS)}")
    try:
        return importlib.import_module(f".{kind}", __name__)
    except ImportError as missing:
        raise ResultsError(f"{missing}; figures need h5py, matplotlib, numpy, pillow") from None


def usual_kinds(command):
    """The figures that show the results of a command; none of a command whose results are a summary."""
    return USUAL.get(command, ())


def draw(folder, kind, **options):
    """A matplotlib Figure of the results in a folder."""
    return module_of(kind).draw_folder(pathlib.Path(folder), **options)


def command(kind, words=None, program=None):
    """Writes a figure as the words of a command line say; a script by the words that it was called with."""
    module = module_of(kind)
    from .canvas import command_line, write_figure  # pylint: disable=import-outside-toplevel
    parser = command_line(module.__doc__, KINDS[kind], kind)
    if program is not None:
        parser.prog = f"{program} plot {kind}"
    getattr(module, "add_options", lambda _: None)(parser)
    arguments = parser.parse_args(words)
    options = {name: value for name, value in vars(arguments).items() if name not in ("folder", "name", "format")}
    write_figure(arguments.folder, arguments.name, lambda: module.draw_folder(arguments.folder, **options),
                 arguments.format, program)
