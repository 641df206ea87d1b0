"""Markdown tables: their lines, and where these go: the screen, a file of the study, docs/data.

A study publishes tables as docs/data/NAME.md. Its first line is a comment with the version of the program, the date
and the processor; the pages of the documents include what follows.
"""
import contextlib
import datetime
import math
import pathlib
import platform
import re
import subprocess
import sys

from studies.common.runs import PROGRAM, SOURCE, RunError

DATA = SOURCE / "docs/data"


def row(*cells):
    return f"| {' | '.join(map(str, cells))} |"


def heading(*columns):
    return f"{row(*columns)}\n|{'---|' * len(columns)}"


def percent(change, digits=1):
    return f"{round(100 * change, digits) + 0.0:+.{digits}f} %"  # + 0.0: no "-0.0"


def with_bar(value, bar, figures=2):
    """Value and error bar, with that many figures of the bar."""
    digits = max(0, figures - 1 - math.floor(math.log10(bar)))
    return f"{value:.{digits}f} ± {bar:.{digits}f}"


def version():
    """That of the program."""
    try:
        return subprocess.run([PROGRAM, "-version"], capture_output=True, text=True, check=True).stdout.split()[1]
    except (OSError, subprocess.CalledProcessError, IndexError):
        raise RunError(f"{PROGRAM} does not say its version; set GEARFILM or run scripts/setup.sh") from None


def processor():
    """The model of the processor, as Linux names it."""
    try:
        named = re.search(r"^model name\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.M)
    except OSError:
        named = None
    return named[1].strip() if named else platform.machine()


def publish(name, text):
    """Writes docs/data/NAME.md. The page that includes it has headings of its own: those of the text become bold."""
    path = DATA / f"{name}.md"
    source = f"<!-- gearfilm {version()}, {datetime.date.today()}, {processor()} -->"
    tables = re.sub(r"^#+ (.*)$", r"**\1**", text.strip(), flags=re.M)
    path.write_text(f"{source}\n{tables}\n", encoding="utf-8")
    print(f"published: {path}", file=sys.stderr)


def chosen(parser, names, known, what):
    """The names that a command line gives, all that are known where it gives none; an unknown one ends it."""
    for name in names:
        if name not in known:
            parser.error(f"no {what} '{name}'; choose of {', '.join(known)}")
    return names or tuple(known)


def add_publish(parser):
    parser.add_argument("--publish", action="store_true", help="write the tables to docs/data too")


@contextlib.contextmanager
def sheet(name, published, path=None):
    """A function that prints lines as they come and writes them to the file of the path, if there is one.

    At the end the lines are published under the name, if they are to be.
    """
    lines = []
    with contextlib.ExitStack() as stack:
        file = stack.enter_context(path.open("w", encoding="utf-8")) if path else None

        def say(line):
            lines.append(line)
            print(line, flush=True)
            if file:
                print(line, file=file, flush=True)

        yield say
    if published:
        publish(name, "\n".join(lines))
