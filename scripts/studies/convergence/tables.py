"""What the runs of a study say: limits or changes, as Markdown tables and as numbers for a file."""
from typing import NamedTuple

from studies.common.contacts import FORMULA_HEADING, formula_cells
from studies.common.tables import heading, percent, row, with_bar
from studies.convergence.limit import limit_of
from studies.convergence.series import Series

NOT_SOLVED = "not solved"
REFINED_REMARK = """
Order: log2 of the ratio of the last two differences; none where they have opposite signs. Limit: extrapolated with
order 2. Its bar: what the finest run changed in it; where the order is not from 1.3 to 3, at least the last difference.
"""


class Solved(NamedTuple):
    """A series with the summaries of its runs, None where not solved."""
    series: Series
    summaries: list

    def values(self, quantity):
        """Of all runs, in the unit of the quantity; None where there is none."""
        found = [summary.get(quantity.key) if summary else None for summary in self.summaries]
        return [None if value is None else quantity.scale * value for value in found]

    def changes(self, quantity):
        """From the first run to each of the others, relative; None where one was not solved."""
        first, *others = self.values(quantity)
        return [None if None in (first, other) else other / first - 1 for other in others]


class ChangeRow(NamedTuple):
    """A row of a table of changes, with the cells before and after them."""
    name: str
    changes: list
    before: list = []
    after: list = []


class Changes(NamedTuple):
    """A table of changes."""
    title: str
    columns: list
    rows: list
    digits: int
    name: str            # heading of the rows' names
    before: tuple = ()   # headings of further columns
    after: tuple = ()


def value_cell(value, digits):
    return NOT_SOLVED if value is None else f"{value:.{digits}f}"


def limit_cells(limit, digits):
    """Order, and limit with its bar; no limit where the differences do not shrink."""
    order = "none" if limit.order is None else f"{limit.order:.2f}"
    if limit.value is None or limit.order is not None and limit.order <= 0:
        return order, "none in sight" if limit.value is not None else ""
    return order, with_bar(limit.value, limit.bar) if limit.bar > 0 else f"{limit.value:.{digits}f} ± 0"


def limit_lines(solved):
    """A table of one series: a row a quantity, its values from run to run, order and limit."""
    yield heading("quantity", *(run.label for run in solved.series.runs), "order", "limit")
    for quantity in solved.series.quantities:
        values = solved.values(quantity)
        yield row(quantity.heading(), *(value_cell(value, quantity.digits) for value in values),
                  *limit_cells(limit_of(values), quantity.digits))


def film_changes(films):
    """One table of stationary films, a row a contact; with the film formulas against the film of the last run."""
    first = films[0].series
    columns = [f"{quantity.label}: {run.label}" for quantity in first.quantities for run in first.runs[1:]]
    rows = [ChangeRow(film.series.title,
                      [change for quantity in first.quantities for change in film.changes(quantity)],
                      after=formula_cells(film.summaries[-1]) if film.summaries[-1] else [""] * len(FORMULA_HEADING))
            for film in films]
    return Changes("Stationary films", columns, rows, digits=1, name="case", after=FORMULA_HEADING)


def state_changes(solved):
    """A table of one series, a row a quantity."""
    first, *others = [run.label for run in solved.series.runs]
    rows = [ChangeRow(quantity.heading(), solved.changes(quantity),
                      before=[value_cell(solved.values(quantity)[0], quantity.digits)])
            for quantity in solved.series.quantities]
    return Changes(solved.series.title, others, rows, digits=2, name="quantity", before=(first,))


def all_changes(solved):
    films = [one for one in solved if one.series.command == "steady"]
    return [film_changes(films), *(state_changes(one) for one in solved if one not in films)]


def change_lines(changes):
    yield heading(changes.name, *changes.before, *changes.columns, *changes.after)
    for line in changes.rows:
        cells = [NOT_SOLVED if change is None else percent(change, changes.digits) for change in line.changes]
        yield row(line.name, *line.before, *cells, *line.after)


def markdown(study, solved):
    """All tables of a study."""
    if study.refined:
        tables = [(one.series.title, limit_lines(one)) for one in solved]
    else:
        tables = [(changes.title, change_lines(changes)) for changes in all_changes(solved)]
    parts = [f"# {study.title}\n", REFINED_REMARK if study.refined else ""]
    for title, lines in tables:
        parts.append("\n".join(["", f"## {title}", "", *lines, ""]))
    return "".join(parts)


def film_lines(solved):
    """One table of all series of films, two rows each: values on the coarsest and the finest grid, order and limit."""
    yield heading("contact", "film", "coarsest grid", "", "finest grid", "", "order", "limit")
    for one in solved:
        runs = one.series.runs
        for number, quantity in enumerate(one.series.quantities):
            values = one.values(quantity)
            first = number == 0
            yield row(one.series.title if first else "", quantity.heading(), runs[0].label if first else "",
                      value_cell(values[0], quantity.digits), runs[-1].label if first else "",
                      value_cell(values[-1], quantity.digits), *limit_cells(limit_of(values), quantity.digits))


def orbit_lines(solved):
    """The table of a periodic state whose grid is refined; in the last column that with the step alone halved."""
    refined, halved = solved
    first, *lines = limit_lines(refined)
    columns, rule = first.split("\n")
    yield f"{columns} {halved.series.runs[0].label} |\n{rule}---|"
    for line, quantity in zip(lines, refined.series.quantities):
        yield f"{line} {value_cell(halved.values(quantity)[0], quantity.digits)} |"


CONDENSED = {"steady": ("convergence_films", film_lines), "grid": ("convergence_periodic", orbit_lines)}


def published(name, study, solved):
    """Name and text of what goes to docs/data: one table where the study has a condensed one, else all of them."""
    if name not in CONDENSED:
        return f"convergence_{name}", markdown(study, solved)
    place, lines = CONDENSED[name]
    return place, "\n".join(lines(solved))


def numbers(study, solved):
    """All values of a study with order, limit and bar, or with the changes."""
    def result(one, quantity):
        values = one.values(quantity)
        compared = limit_of(values)._asdict() if study.refined else {"changes": one.changes(quantity)}
        if study.refined:
            compared["limit"] = compared.pop("value")
        return {"unit": quantity.unit, "values": values, **compared}

    return {one.series.name: {"title": one.series.title,
                              "runs": [{"label": run.label, "name": run.name, "step": run.step, "solved": bool(summary)}
                                       for run, summary in zip(one.series.runs, one.summaries)],
                              "quantities": {quantity.key: result(one, quantity)
                                             for quantity in one.series.quantities}}
            for one in solved}
