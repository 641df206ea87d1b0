#!/usr/bin/env python3
"""Writes the documents as Doxygen reads them: labels of headings, formulas, links between pages.

    scripts/checks/page_sources.py FOLDER       for scripts/pages.sh; one file a page, README.md the first one

A link to a file that is no page of the site becomes its text.
"""
import pathlib
import posixpath
import re
import sys

from markdown_text import CODE, headings, prose

SOURCE = pathlib.Path(__file__).resolve().parents[2]
FIRST = "README.md"
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^()\s]+)\)")


def site_pages():
    """Files that are pages of the site, from the source folder on; tables in docs/data are parts of pages."""
    paths = [SOURCE / FIRST, SOURCE / "CONTRIBUTING.md", SOURCE / "CHANGELOG.md",
             SOURCE / "scripts/packaging/README.md", *sorted((SOURCE / "docs").rglob("*.md"))]
    return [path.relative_to(SOURCE).as_posix() for path in paths if path.parent != SOURCE / "docs/data"]


def label(page, anchor=""):
    """The name of a page, or of a heading in it, for Doxygen. It calls the first page index."""
    name = "index" if page == FIRST else "page_" + re.sub(r"\W", "_", page[:-len(".md")])
    return f"{name}-{anchor}" if anchor else name


def linked(found, page, pages):
    """A link or an image as Doxygen knows it."""
    image, text, target = found.groups()
    if image:
        return f"![{text}]({posixpath.basename(target)})"
    if re.match(r"[a-z]+:", target):
        return found[0]
    place, _, anchor = target.partition("#")
    other = posixpath.normpath(posixpath.join(posixpath.dirname(page), place)) if place else page
    # Doxygen shows the marks of code in such a link as text.
    return f"[{text.replace('`', '')}](@ref {label(other, anchor)})" if other in pages else text


def with_formulas(line, display):
    """The line with Doxygen's marks of formulas, and whether a displayed one goes on behind it."""
    parts = line.split("$$")
    for number, part in enumerate(parts):
        if (number % 2 == 0) != display:
            parts[number] = re.sub(r"\$([^$]+)\$", r"\\f$\1\\f$", part)
    text = parts[0]
    for part in parts[1:]:
        text += (r"\f]" if display else r"\f[") + part
        display = not display
    return text, display


def outside_code(line, change):
    """The line with everything changed but code."""
    pieces, at = [], 0
    for code in CODE.finditer(line):
        pieces += [change(line[at:code.start()]), code[0]]
        at = code.end()
    return "".join([*pieces, change(line[at:])])


def with_emphasis(text):
    """The text with paragraphs in italics marked so that Doxygen sees it where they begin or end with code."""
    return re.sub(r"(?<=\n\n)\*(?=\S)([^*]+)\*(?=\n\n|\n*\Z)", r"<em>\1</em>", text)


def page_source(page, text, pages):
    text = with_emphasis(text)
    lines = text.splitlines()
    titles = {number: (level, title, anchor) for number, level, title, anchor in headings(text)}
    display = False
    first = True
    for number, line in prose(text):
        # Links first: their text may have code in it.
        line = LINK.sub(lambda found: linked(found, page, pages), line)
        if number in titles:
            level, _, anchor = titles[number]
            line = line.replace("`", "")  # Doxygen shows the marks of code in a heading as text
            of_page = level == 1 and first
            if not of_page or page != FIRST:
                line = f"{line} {{#{label(page, '' if of_page else anchor)}}}"
            first = False
        if display or "$$" in line:
            line, display = with_formulas(line, display)
        else:
            line = outside_code(line, lambda part: with_formulas(part, False)[0])
        lines[number - 1] = line
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) != 2:
        sys.exit("page_sources: one folder is needed; name where the pages go")
    folder = pathlib.Path(sys.argv[1])
    pages = site_pages()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for page in pages:
            text = page_source(page, (SOURCE / page).read_text(encoding="utf-8"), set(pages))
            name = FIRST if page == FIRST else f"{label(page)}.md"
            (folder / name).write_text(text, encoding="utf-8")
    except OSError as error:
        sys.exit(f"page_sources: {error}; name a folder that can be written")


if __name__ == "__main__":
    main()
