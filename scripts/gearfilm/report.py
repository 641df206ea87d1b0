"""One HTML page of a run: main figures with errors beside formulas, figures, convergence, timing, how to repeat it.

The page stands alone: figures are inside it, nothing is fetched when it is opened.
"""
import base64
import html
import io
import shlex

import numpy

from .drawing import draw, usual_kinds
from .folder import ResultsError

UNITS = (("h_", 1e6, "µm"), ("transmission_error", 1e6, "µm"), ("te_", 1e6, "µm"), ("p_", 1e-9, "GPa"))
BARE = {"case", "provenance", "predictions", "search", "points", "periods", "events", "loads", "branches", "stretches"}
STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 62em; padding: 0 1em; color: #222; }
h1 { font-size: 1.6em; margin-bottom: 0; } h2 { font-size: 1.15em; border-bottom: 1px solid #ccc; margin-top: 2em; }
table { border-collapse: collapse; } td, th { padding: .2em .9em .2em 0; text-align: left; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; } tr:nth-child(even) { background: #f5f7f9; }
img { max-width: 100%; } code { background: #f2f2f2; padding: .1em .3em; } .warning { color: #a33d00; }
@media print { body { margin: 0; max-width: none; } h2 { break-after: avoid; } }
"""


def _number(value):
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def _scaled(name):
    for beginning, factor, unit in UNITS:
        if name.startswith(beginning) or f"_{beginning}" in name:
            return factor, unit
    return 1.0, ""


def _rows(rows, headings):
    lines = ["<table><tr>" + "".join(f"<th>{html.escape(heading)}</th>" for heading in headings) + "</tr>"]
    for row in rows:
        cells = "".join(f'<td class="{"text" if n == 0 else "number"}">{html.escape(str(cell))}</td>'
                        for n, cell in enumerate(row))
        lines.append(f"<tr>{cells}</tr>")
    return "\n".join([*lines, "</table>"])


def main_figures(summary):
    """Rows of name, value, error, towards finer grids, unit."""
    rows = []
    for name, value in summary.items():
        derived = name.endswith("_error") or name.endswith("_extrapolated")
        if name in BARE or isinstance(value, (list, dict)) or (derived and name.rpartition("_")[0] in summary):
            continue
        if isinstance(value, bool) or value is None or isinstance(value, str):
            rows.append((name, {True: "yes", False: "no", None: "none"}.get(value, value), "", "", ""))
            continue
        factor, unit = _scaled(name)
        beside = [summary.get(name + ending) for ending in ("_error", "_extrapolated")]
        rows.append((name, _number(factor * value),
                     *("" if other is None else _number(float(f"{factor * other:.4g}")) for other in beside), unit))
    return rows


def formulas(summary):
    """Rows of the film formulas and the like."""
    rows = []
    for name, value in summary.get("predictions", {}).items():
        if isinstance(value, (int, float)):
            factor, unit = _scaled(name)
            rows.append((name, _number(factor * value), unit))
    return rows


def lists(summary):
    """The lists of a summary whose entries have names: one table each."""
    for name, entries in summary.items():
        if not isinstance(entries, list) or not entries or not isinstance(entries[0], dict):
            continue
        columns = [key for key, value in entries[0].items() if not isinstance(value, (list, dict))][:12]
        shown = entries[:60]
        rows = [[_number(entry.get(key, "")) for key in columns] for entry in shown]
        note = f" (the first {len(shown)} of {len(entries)})" if len(shown) < len(entries) else ""
        yield f"{name}{note}", _rows(rows, columns)


def convergence(run):
    """What the solvers needed, from the table of time steps."""
    if "history/steps" not in run.tables():
        return []
    steps = run.table("history/steps")
    steps = steps[steps["dT"] > 0]
    if not steps.size:
        return []
    return [("time steps", steps.size), ("Newton iterations a step", _number(float(numpy.mean(steps["newton"])))),
            ("most in a step", int(steps["newton"].max())),
            ("Krylov iterations a step", _number(float(numpy.mean(steps["krylov"])))),
            ("shortest step over the longest", _number(float(steps["dT"].min() / steps["dT"].max()))),
            ("time of the steps [s]", _number(float(steps["wall_time"].sum())))]


def figures(run):
    """Name and PNG of every figure of the run; what is said where one cannot be drawn."""
    for kind in usual_kinds(run.command):
        try:
            drawn = draw(run.folder, kind)
        except ResultsError as error:
            yield kind, None, str(error)
            continue
        content = io.BytesIO()
        drawn.savefig(content, dpi=110, format="png")
        yield kind, content.getvalue(), ""


def case_of(run):
    """Parameters that were given or chosen, as rows."""
    return [(name, _number(parameter.value), parameter.unit) for name, parameter in sorted(run.parameters.items())]


def how_to_repeat(run):
    """A command line with every parameter, for a file with none."""
    options = [f"-{name.replace('.', '_')} {shlex.quote(_number(parameter.value))}"
               for name, parameter in sorted(run.parameters.items()) if name not in ("case.name", "case.kind")]
    return f"gearfilm {run.command} CASE.yaml " + " ".join(options)


def page(run):
    """The whole page."""
    summary, attributes = run.summary, run.attributes
    if not summary:
        raise ResultsError(f"{run.folder} has no summary yet; the run must have ended")
    name = html.escape(str(summary.get("case", run.folder.name)))
    text = io.StringIO()

    def section(title, content):
        if content:
            text.write(f"<h2>{html.escape(title)}</h2>\n{content}\n")

    completed = summary.get("completed", True)
    text.write(f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>gearfilm: {name}</title>'
               f"<style>{STYLE}</style></head><body>\n<h1>{name}: {html.escape(run.command)}</h1>\n"
               f"<p>gearfilm {html.escape(attributes.get('version', 'of unknown version'))}</p>\n")
    if not completed:
        text.write('<p class="warning">This run is not complete: figures are of what was computed until it ended.</p>\n')
    if summary.get("stable") is False:
        text.write('<p class="warning">The periodic state is unstable: no march stays on it.</p>\n')
    section("Main figures", _rows(main_figures(summary), ("figure", "value", "error", "towards finer grids", "unit")))
    known = formulas(summary)
    section("Formulas", _rows(known, ("formula", "value", "unit")) if known else "")
    for kind, picture, trouble in figures(run):
        image = "" if picture is None else \
            f'<img alt="{kind}" src="data:image/png;base64,{base64.b64encode(picture).decode()}">'
        section(f"Figure ({kind})", image or f'<p class="warning">{html.escape(trouble)}</p>')
    needed = convergence(run)
    section("Convergence and time", _rows(needed, ("", "")) if needed else "")
    for title, table in lists(summary):
        section(title, table)
    made_with = [(key, value) for key, value in attributes.items() if key not in ("x_min", "x_max", "y_half")]
    section("Made with", _rows(made_with, ("", "")))
    used = case_of(run)
    if used:
        section("How to repeat it", f"<p><code>{html.escape(how_to_repeat(run))}</code></p>")
        section("Parameters", _rows(used, ("parameter", "value", "unit")))
    text.write("</body></html>\n")
    return text.getvalue()


def write_report(run, path=None):
    """Writes the page, FOLDER/report.html where no path is given; returns the path."""
    path = path or run.folder / "report.html"
    path.write_text(page(run), encoding="utf-8")
    return path
