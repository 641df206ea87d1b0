"""Results of gearfilm as tables, pages and figures.

    python3 -m gearfilm export FOLDER [TABLE] [-o FILE]      a table as CSV; without a name the list of them
    python3 -m gearfilm report FOLDER [-o FILE]              one HTML page of a run
    python3 -m gearfilm plot KIND FOLDER [options]           a figure; plot --help lists the kinds

Exit status 1, with one line, where words or results are wrong.
"""
import argparse
import pathlib
import sys

from . import packages

if sys.argv[1:2] == ["plot"]:
    packages.go_on_with(packages.FIGURES, "gearfilm", "gearfilm")
packages.require(packages.TABLES, "gearfilm")
# pylint: disable=wrong-import-position
from . import drawing  # noqa: E402
from .command_line import Parser  # noqa: E402
from .export import export, list_tables  # noqa: E402
from .folder import ResultsError, RunFolder  # noqa: E402


def export_command(arguments):
    """Prints the list of tables, or one table."""
    run = RunFolder(arguments.folder)
    if arguments.table is None:
        list_tables(run, sys.stdout)
    elif arguments.output is None:
        export(run, arguments.table, sys.stdout)
    else:
        with arguments.output.open("w", encoding="utf-8") as stream:
            export(run, arguments.table, stream)
        print(f"table: {arguments.output}")


def report_command(arguments):
    """Writes the page."""
    packages.require(packages.FIGURES, "gearfilm")
    from .report import write_report  # pylint: disable=import-outside-toplevel
    print(f"report: {write_report(RunFolder(arguments.folder), arguments.output)}")


def plot_command(arguments):
    """Writes a figure; its own options come after the kind."""
    packages.require(packages.FIGURES, "gearfilm")
    drawing.command(arguments.kind, arguments.words)


def list_of_kinds():
    return "kinds:\n" + "\n".join(f"  {name:<10} {kind.shows}; of {kind.commands}"
                                   for name, kind in drawing.KINDS.items())


def main():
    parser = Parser(prog="python3 -m gearfilm", description=__doc__.split("\n", 1)[0])
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    for name, action, meaning in (("export", export_command, "a table as CSV; without a name the list of them"),
                                  ("report", report_command, "one HTML page of a run")):
        one = commands.add_parser(name, help=meaning, description=meaning)
        one.add_argument("folder", type=pathlib.Path, help="the -output_dir of a run")
        if name == "export":
            one.add_argument("table", nargs="?", help="for example history/steps")
        one.add_argument("-o", "--output", type=pathlib.Path, help="file to write")
        one.set_defaults(action=action)
    one = commands.add_parser("plot", help="a figure as PNG and PDF", description="a figure as PNG and PDF",
                              epilog=list_of_kinds(), formatter_class=argparse.RawDescriptionHelpFormatter)
    one.add_argument("kind", choices=drawing.KINDS, metavar="KIND", help="one of the list below")
    one.add_argument("words", nargs=argparse.REMAINDER, metavar="FOLDER [options]",
                     help="of the run; plot KIND --help lists the options")
    one.set_defaults(action=plot_command)
    arguments = parser.parse_args()
    try:
        arguments.action(arguments)
    except ResultsError as error:
        sys.exit(f"gearfilm: {error}")
    except OSError as error:
        sys.exit(f"gearfilm: cannot write: {error}")


if __name__ == "__main__":
    main()
