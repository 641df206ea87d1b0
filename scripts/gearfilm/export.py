"""Tables as text with commas: a line of names with units, then the rows."""
import csv

from .folder import ResultsError


def export(run, name, stream):
    """Writes one table."""
    table, units = run.table(name), run.units(name)
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow([column if units.get(column, "-") == "-" else f"{column} [{units[column]}]"
                     for column in table.dtype.names])
    for row in table.tolist():
        writer.writerow([f"{value:.12g}" if isinstance(value, float) else value for value in row])


def list_tables(run, stream):
    """The tables that there are, with their sizes."""
    names = run.tables()
    if not names:
        raise ResultsError(f"{run.folder} has no tables; its command leaves a summary alone")
    for name in names:
        table = run.table(name)
        print(f"{name}: {table.size} rows of {', '.join(table.dtype.names)}", file=stream)
