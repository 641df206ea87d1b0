"""Figures of results: one module for each kind, drawn from the folder of a run.

    import gearfilm
    gearfilm.open(FOLDER).draw()                      # the usual figure of its command
    gearfilm.open(FOLDER).draw("orbit", periods=2)    # one of KINDS, with the options of its module

    python3 -m gearfilm plot KIND FOLDER [options]    writes FOLDER/KIND.png and .pdf
"""
import importlib
import io
import pathlib
from typing import NamedTuple

from ..command_line import Parser
from ..folder import ResultsError


class Kind(NamedTuple):
    """One kind of figure."""
    commands: str               # whose results are drawn
    shows: str


KINDS = {
    "film": Kind("steady, or a march with films", "the film over the contact, and pressure and film along y = 0"),
    "face": Kind("steady, periodic or transient", "pressure and film over the face, line load, contact pattern"),
    "march": Kind("transient or periodic", "motion, forces and films over the length travelled"),
    "orbit": Kind("periodic or transient", "phase portrait, force over the line of action, spectrum"),
    "sweep": Kind("sweep", "response of a sweep, its marches as dots, or its basins"),
    "branch": Kind("continuation", "branches of periodic states with their bifurcations"),
    "poincare": Kind("transient", "motion once a mesh period"),
    "static": Kind("static", "transmission error, load shares and mesh stiffness"),
    "friction": Kind("transient, periodic or steady", "friction coefficient, losses and temperatures"),
    "mixed": Kind("sweep, periodic, transient or steady", "load, friction and wear of asperities; Stribeck curve"),
    "wear": Kind("wear", "depth that the flanks have lost, over roll angle and face"),
    "damage": Kind("periodic, transient or steady", "stresses below films, fatigue of flanks, ratings"),
    "campbell": Kind("info or eigen, of a drive train", "natural frequencies over the speed, met by the mesh"),
    "train": Kind("periodic or transient, of a drive train", "tooth force, torques, forces on bearings, their orders"),
    "modes": Kind("info or eigen, of a drive train", "shapes of the modes"),
    "compare": Kind("sweep or periodic", "up to four runs side by side, each given as LABEL=FOLDER"),
    "animation": Kind("periodic, or a transient with films", "film, pressure, force and motion over a mesh cycle"),
}
# Commands whose results are drawn, the usual kind first.
USUAL = {"steady": ("film",), "transient": ("march",), "periodic": ("orbit", "march", "film"), "sweep": ("sweep",),
         "continuation": ("branch",), "static": ("static",), "wear": ("wear",)}


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
    module = module_of(kind)
    if not hasattr(module, "draw_folder"):
        raise ResultsError(f"'{kind}' is no figure of one run; python3 -m gearfilm plot {kind} writes it")
    return module.draw_folder(pathlib.Path(folder), **options)


def picture(folder, kind, resolution, **options):
    """The PNG of such a figure, of so many dots by inch."""
    figure, content = draw(folder, kind, **options), io.BytesIO()
    figure.savefig(content, dpi=resolution, format="png")
    importlib.import_module("matplotlib.pyplot").close(figure)
    return content.getvalue()


def command(kind, words):
    """Writes a figure as the words of a command line say."""
    module = module_of(kind)
    importlib.import_module("matplotlib").use("Agg")    # files alone: no window is opened
    canvas = importlib.import_module(".canvas", __name__)
    meaning, _, more = module.__doc__.partition("\n")
    parser = Parser(prog=f"python3 -m gearfilm plot {kind}", description=meaning, epilog=more.strip())
    if hasattr(module, "command"):
        module.command(parser, words)
        return
    parser.add_argument("folder", type=pathlib.Path, help=f"folder with the results of gearfilm {KINDS[kind].commands}")
    canvas.add_output(parser, kind)
    getattr(module, "add_options", lambda _: None)(parser)
    arguments = parser.parse_args(words)
    options = {name: value for name, value in vars(arguments).items() if name not in ("folder", "name", "format")}
    canvas.write_figure(arguments.folder, arguments.name, lambda: module.draw_folder(arguments.folder, **options),
                        arguments.format)
