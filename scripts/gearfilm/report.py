"""One HTML page of a run: main results with errors, pictures, formulas, how to repeat it; the work of the solver last.

The page stands alone: pictures are inside it, nothing is fetched when it is opened. Names and units are the manual's.
"""
import html
import io
import shlex

import numpy

from . import defaults, markup
from .drawing import picture, usual_kinds
from .folder import ResultsError
from .quantities import INTERNAL, quantity, shown
from .verdicts import HEADINGS, verdicts

BARE = {"case", "provenance", "predictions", "search", "completed", "points", "dry", "final_grid"}
INPUTS = {"torque", "m_ge", "viscosity", "I_n", "f_n", "order"}     # left out of a list where all rows have the same
REPEATED = {"value"}                                                # said by another column
FIRST = ("load_ratio",)                                             # of the columns of a list
SAME = 1e-9                                                         # relative, of two inputs
LONGEST_LIST = 60
DIGITS = 5
RESOLUTION = 110   # of figures, dots by inch
TITLES = {"points": "Points", "periods": "Mesh periods", "events": "Contacts that enter and leave",
          "contact_losses": "Losses of contact", "spectrum_peaks": "Largest lines of the spectrum of H_0",
          "loads": "Under every load", "bifurcations": "Bifurcations", "branches": "Branches",
          "stretches": "Stretches of one stability", "attractors": "Motions that starts lead to",
          "modes": "Modes", "shaft_torques": "Torques of the drive train", "bearing_forces": "Forces on bearings",
          "gear_accelerations": "Accelerations of the gears"}
CAPTIONS = {"film": "Film: thickness over the contact, pressure and film along y = 0",
            "march": "March: motion, forces, pressure and films",
            "orbit": "Orbit: phase portrait, force over the line of action, spectrum",
            "sweep": "Sweep: response over what is varied",
            "branch": "Branches: stable ones full, unstable ones dashed",
            "static": "Turned slowly: transmission error and its swing, load shares, mesh stiffness",
            "damage": "Stresses below the films, fatigue of the flanks",
            "damage section": "Stresses below the contact at the worst moment",
            "damage path": "Stresses, temperatures and film ratio over the path of contact",
            "face": "Contact pattern",
            "train": "Drive train: tooth force, torques and forces on bearings, over time and by orders",
            "friction": "Friction: coefficient, losses and temperatures"}
NO_NUMBER = {True: "yes", False: "no", None: "none"}


def _is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _text(value, factor=1.0, digits=DIGITS):
    if isinstance(value, (bool, type(None))):
        return NO_NUMBER[value]
    if isinstance(value, int) and factor == 1.0:
        return str(value)
    return f"{factor * value:.{digits}g}" if _is_number(value) else str(value)


def _row(name, value, **beside):
    """Meaning with name, value, unit, other values in this unit by what their names end with."""
    known = quantity(name)
    meaning = known.meaning if known else ""
    numbers = value if isinstance(value, list) else [value]
    if not all(map(_is_number, numbers)):  # yes, no or a word
        return [(meaning, name), _text(value), "", *([""] * len(beside))]
    factor, unit = shown(known.unit if known else "", max(map(abs, numbers), default=0.0))
    others = [_beside(other, factor, ending) for ending, other in beside.items()]
    return [(meaning, name), ", ".join(_text(number, factor) for number in numbers), unit, *others]


def _beside(value, factor, ending):
    if value is None:
        return ""
    return _text(float(value), factor, 2 if ending == "_error" else DIGITS)


def _is_row(summary, name, value):
    derived = name.endswith(("_error", "_extrapolated")) and name.rpartition("_")[0] in summary
    numbers = isinstance(value, list) and value and all(map(_is_number, value))
    return name not in BARE and not derived and (numbers or not isinstance(value, (list, dict)))


def main_results(summary):
    """Headings, and rows of name, value, unit, error, and value that finer grids lead to, as far as there are such."""
    names = [name for name, value in summary.items() if _is_row(summary, name, value) and name not in INTERNAL]
    endings = {"error": "_error", "finer grids": "_extrapolated"}
    endings = {heading: ending for heading, ending in endings.items()
               if any(summary.get(name + ending) is not None for name in names)}
    rows = [_row(name, summary[name], **{ending: summary.get(name + ending) for ending in endings.values()})
            for name in names]
    return ["quantity", "value", "unit", *endings], rows


def internal_results(summary):
    """Rows of name, value, unit of what tells of the solver and its grid."""
    return [_row(name, value) for name, value in summary.items()
            if _is_row(summary, name, value) and name in INTERNAL]


def formulas(summary):
    """Rows of the film formulas and the like."""
    return [_row(name, value) for name, value in summary.get("predictions", {}).items() if _is_number(value)]


def _all_the_same(values):
    return len(values) > 1 and all(_is_number(value) for value in values) and \
        max(values) - min(values) <= SAME * max(map(abs, values))


def _columns(entries):
    """Names of what a table of these entries shows."""
    of_spectrum = "frequency" in entries[0]
    for name in sorted(entries[0], key=lambda name: name not in FIRST):
        values = [entry.get(name) for entry in entries]
        nested = any(isinstance(value, (list, dict)) for value in values)
        internal = name in INTERNAL and not of_spectrum
        hidden = nested or internal or name in REPEATED or (name in INPUTS and _all_the_same(values))
        if not hidden and not name.endswith("_extrapolated"):
            yield name


def _unit_of_column(name, numbers, over):
    known = quantity(name)
    unit = known.unit if known else ""
    varied = name in ("from", "to", "last_value", "born_at")
    return shown(over if varied else unit, max(map(abs, numbers), default=0.0))


def lists(summary, over=""):
    """Title and table of the lists of a summary whose entries have names; `over` is the unit of what is varied."""
    for title, entries in summary.items():
        if not isinstance(entries, list) or not entries or not isinstance(entries[0], dict):
            continue
        headings, columns = [], []
        for name in _columns(entries):
            values = [entry.get(name) for entry in entries[:LONGEST_LIST]]
            factor, unit = _unit_of_column(name, [value for value in values if _is_number(value)], over)
            headings.append(f"{name} [{unit}]" if unit else name)
            columns.append(["" if value is None else _text(value, factor) for value in values])
        if columns:
            note = f" (the first {LONGEST_LIST} of {len(entries)})" if len(entries) > LONGEST_LIST else ""
            yield TITLES.get(title, title) + note, markup.table(list(zip(*columns)), headings)


def convergence(run):
    """Rows of what the solvers needed, from the table of time steps."""
    if "history/steps" not in run.tables():
        return []
    steps = run.table("history/steps")
    steps = steps[steps["dT"] > 0]
    if not steps.size:
        return []
    return [("time steps", str(steps.size), "-"),
            ("Newton iterations a step", _text(float(numpy.mean(steps["newton"]))), "-"),
            ("most in a step", str(int(steps["newton"].max())), "-"),
            ("Krylov iterations a step", _text(float(numpy.mean(steps["krylov"]))), "-"),
            ("shortest step over the longest", _text(float(steps["dT"].min() / steps["dT"].max())), "-"),
            ("time of the steps", _text(float(steps["wall_time"].sum())), "s")]


def kinds(run):
    """The figures of a run with their options: those of its command, and a film where a march has stored some."""
    usual = [(kind, {}) for kind in usual_kinds(run.command) if kind != "film"]
    usual += run.damage_figures()
    if run.moves_train():
        usual.append(("train", {}))
    return [*usual, ("film", {})] if run.stores_films() else usual


def figures(run):
    """Name and PNG of every figure of the run; what is said where one cannot be drawn."""
    for kind, options in kinds(run):
        name = " ".join((kind, *options))
        try:
            yield name, picture(run.folder, kind, RESOLUTION, **options), ""
        except ResultsError as error:
            yield name, None, str(error)


def case_of(run):
    """Parameters that were given or chosen, as rows."""
    return [(name, _text(parameter.value, digits=6), parameter.unit)
            for name, parameter in sorted(run.parameters.items())]


def how_to_repeat(run):
    """A command, and the case file for it: what was given, by the file or by options."""
    name = f"{shlex.quote(str(run.summary.get('case', 'case')))}.yaml"
    return f"gearfilm {run.command} {name}", defaults.case_file(run.parameters)


def _unit_of_varied(run):
    varied = run.parameters.get(str(run.summary.get("over", "")))
    return varied.unit if varied else ""


def page(run):
    """The whole page."""
    summary, attributes, parameters = run.summary, run.attributes, run.parameters
    if not summary:
        raise ResultsError(f"{run.folder} has no summary yet; the run must have ended")
    title = f"{summary.get('case', run.folder.name)}: {run.command}"
    text = io.StringIO()

    def section(heading, content, level=2):
        if content:
            text.write(f"<h{level}>{html.escape(heading)}</h{level}>\n{content}\n")

    def rows(content, headings=()):
        return markup.table(content, headings) if content else ""

    text.write(markup.head(f"gearfilm: {title}"))
    version = html.escape(attributes.get("version", "of unknown version"))
    text.write(f"<h1>{html.escape(title)}</h1>\n<p>gearfilm {version}</p>\n")
    if not summary.get("completed", True):
        text.write(markup.warning("This run is not complete: the page shows what was computed until it ended."))
    if summary.get("stable") is False and summary["floquet_modulus"] - 1 > summary["floquet_modulus_error"]:
        text.write(markup.warning("The periodic state is unstable: no march stays on it."))
    headings, main = main_results(summary)
    section("Main results", rows(main, headings))
    section("What fails first", rows(verdicts(summary), HEADINGS))
    for kind, content, trouble in figures(run):
        section(CAPTIONS.get(kind, kind), markup.picture(content, CAPTIONS.get(kind, kind)) if content else
                markup.warning(trouble))
    section("Formulas", rows(formulas(summary), ("formula", "value", "unit")))
    for heading, content in lists(summary, _unit_of_varied(run)):
        section(heading, content)
    if parameters:
        command, case = how_to_repeat(run)
        section("How to repeat it",
                f"<pre>{html.escape(command)}</pre>\n<p>with this case file, which has what was given in a file or by "
                f"options, but for the program's defaults:</p>\n<pre>{html.escape(case)}</pre>")
    section("Internals", "<p>Of the solver, its grid and the program.</p>")
    section("Grid and solver", rows(internal_results(summary), ("quantity", "value", "unit")), 3)
    section("Time steps", rows(convergence(run), ("quantity", "value", "unit")), 3)
    made_with = [(key, value) for key, value in attributes.items() if key not in ("x_min", "x_max", "y_half")]
    section("Made with", rows([(key, str(value)) for key, value in made_with]), 3)
    section("All parameters", rows(case_of(run), ("parameter", "value", "unit")), 3)
    text.write("</body></html>\n")
    return text.getvalue()


def write_report(run, path=None):
    """Writes the page, FOLDER/report.html where no path is given; returns the path.

    Raises ResultsError where that file is there and no page of this package: one with another title by earlier ones.
    """
    own = (markup.GENERATOR, "<title>gearfilm: ")
    if path is None:
        path = run.folder / "report.html"
        if path.exists() and not any(mark in path.read_text(encoding="utf-8", errors="replace")[:1000] for mark in own):
            raise ResultsError(f"{path} is no page of gearfilm; move it, or give another file by --output")
    path.write_text(page(run), encoding="utf-8")
    return path
