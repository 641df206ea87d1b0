#!/usr/bin/env python3
"""Documents as text: spelling, lengths of lines, tables that studies wrote, number of words.

    scripts/checks/documents.py [--update]

Spelling is that of hunspell's British dictionary and of docs/words.txt, one word a line; code, formulas, links and
words with digits are left out. Lines of prose have at most 120 characters. Between `<!-- table NAME -->` and `<!-- end -->` stands
docs/data/NAME.md but for its first line, which says the version and the machine; --update writes it there. README,
guide, model, numerics, verification, performance and limits have at most 30,000 words, tables of studies left out.

Prints one line a fault; exit status 1 where there is one, or where hunspell is missing.
"""
import argparse
import pathlib
import re
import subprocess
import sys

from markdown_text import CODE, end_of_check, prose

SOURCE = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = SOURCE / "docs"
WORDS = DOCUMENTS / "words.txt"
PRINTED = {"parameters.md", "constants.md", "results.md"}  # by the program, whose lines may be longer
LONGEST_LINE = 120
MOST_WORDS = 30000
TABLE = re.compile(r"<!-- table ([\w-]+) -->\n(.*?)<!-- end -->\n", re.S)


def pages():
    top = [SOURCE / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")]
    found = [*top, *sorted(DOCUMENTS.rglob("*.md")), *sorted((SOURCE / "scripts").rglob("README.md"))]
    return [page for page in found if page.parent != DOCUMENTS / "data"]


def counted(page):
    """Whether the page is one of those whose words are limited."""
    names = {"README.md", "model.md", "numerics.md", "verification.md", "performance.md", "limits.md"}
    return page.parent.name == "guide" or page.parent in (SOURCE, DOCUMENTS) and page.name in names


def plain(text):
    """Prose without code, formulas, addresses and marks: by line number."""
    numbers, lines = zip(*prose(text))
    joined = "\n".join(CODE.sub(" ", line) for line in lines)
    joined = re.sub(r"\$\$.*?\$\$|\$[^$]*\$|<!--.*?-->", lambda found: "\n" * found[0].count("\n"), joined, flags=re.S)
    for number, line in zip(numbers, joined.split("\n")):
        line = re.sub(r"\]\([^)]*\)", "] ", line)
        line = re.sub(r"<[^>]*>|https?://\S+|\w*\d\w*", " ", line)
        yield number, re.sub(r"(?<=\w)['’]s\b", "", line)


def misspelt(page):
    lines = list(plain(page.read_text(encoding="utf-8")))
    text = "\n".join(line for _, line in lines)
    found = subprocess.run(["hunspell", "-d", "en_GB", "-i", "utf-8", "-p", str(WORDS), "-l"], input=text, text=True,
                           capture_output=True, check=True).stdout.split()
    for word in sorted(set(found)):
        number = next((number for number, line in lines if re.search(rf"(?<!\w){re.escape(word)}(?!\w)", line)), 0)
        yield f"{number}: '{word}' is no known word; correct it, or add it to docs/words.txt"


def long_lines(page):
    for number, line in prose(page.read_text(encoding="utf-8")):
        free = line.lstrip().startswith(("|", "!", "<", "$$")) or page.name in PRINTED
        if len(line) > LONGEST_LINE and not free and len(re.sub(r"\]\([^)]*\)", "]", line)) > LONGEST_LINE:
            yield f"{number}: {len(line)} characters; wrap the line at {LONGEST_LINE}"


def table_faults(page, update):
    """Tables in the page that are not those of the studies; written again where asked for."""
    text = page.read_text(encoding="utf-8")
    faults = []

    def written(found):
        file = DOCUMENTS / "data" / f"{found[1]}.md"
        if not file.exists():
            faults.append(f"1: table {found[1]}: there is no docs/data/{found[1]}.md; run the study that writes it")
            return found[0]
        content = file.read_text(encoding="utf-8").split("\n", 1)[1]
        if content.strip() == found[2].strip():
            return found[0]
        if not update:
            faults.append(f"1: table {found[1]} is not docs/data/{found[1]}.md; scripts/checks/documents.py --update")
        return f"<!-- table {found[1]} -->\n{content.strip()}\n<!-- end -->\n"

    new = TABLE.sub(written, text)
    if update and new != text:
        page.write_text(new, encoding="utf-8")
    return faults


def words_of(page):
    text = TABLE.sub("", page.read_text(encoding="utf-8"))
    return len(text.split())


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--update", action="store_true", help="write the tables of studies into the pages")
    update = parser.parse_args().update
    documents, faults = pages(), []
    try:
        for page in documents:
            found = [*table_faults(page, update), *long_lines(page)]
            if page.name not in PRINTED:
                found += misspelt(page)
            faults += [f"{page.relative_to(SOURCE)}:{fault}" for fault in found]
    except (OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"documents: {error}; install hunspell and hunspell-en-gb")
    words = sum(words_of(page) for page in documents if counted(page))
    if words > MOST_WORDS:
        faults.append(f"README, guide, model, numerics, verification, performance and limits have {words} words, more "
                      f"than {MOST_WORDS}; shorten them")
    end_of_check("documents", faults, f"{len(documents)} pages, {words} words in those that are limited")


if __name__ == "__main__":
    main()
