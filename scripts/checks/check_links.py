#!/usr/bin/env python3
"""Links between the Markdown files: every file that is linked is there, and every heading.

    scripts/checks/check_links.py [FOLDER]      the source folder by default

Build, output and hidden folders are left out. Prints one line a broken link; exit status 1 where there is one. Links to other hosts are not followed.
"""
import argparse
import collections
import pathlib
import re
import sys
import urllib.parse

from markdown_text import anchors, end_of_check, links_of, prose

SOURCE = pathlib.Path(__file__).resolve().parents[2]
LEFT_OUT = {"build", "output"}


class Link(collections.namedtuple("Link", "path number target")):
    """One link: the file and line that it stands in, and what stands between its brackets."""


def markdown_files(folder):
    """All Markdown files below the folder that belong to the sources."""
    found = []
    for path in sorted(folder.rglob("*.md")):
        parts = path.relative_to(folder).parts
        if not (LEFT_OUT & set(parts) or any(part.startswith(".") for part in parts)):
            found.append(path)
    return found


def links_in(path):
    return [Link(path, number, target) for number, line in prose(path.read_text(encoding="utf-8"))
            for target in links_of(line)]


def fault_of(link, folder):
    """What is wrong with a link, or nothing."""
    if re.match(r"[a-z][a-z0-9+.-]*:", link.target):
        return ""
    place, _, anchor = urllib.parse.unquote(link.target).partition("#")
    file = (link.path.parent / place).resolve() if place else link.path
    if not file.exists():
        return "there is no such file"
    if not file.is_relative_to(folder):
        return "it leaves the source folder"
    if not anchor:
        return ""
    if file.suffix != ".md":
        return "only Markdown files have headings to link to"
    known = anchors(file.read_text(encoding="utf-8"))
    return "" if anchor in known else f"{file.name} has no such heading"


def broken_links(folder):
    """One line for every broken link, and the number of links."""
    links = [link for path in markdown_files(folder) for link in links_in(path)]
    faults = [(link, fault_of(link, folder)) for link in links]
    return [f"{link.path.relative_to(folder)}:{link.number}: ({link.target}): {fault}; correct it, or the heading"
            for link, fault in faults if fault], len(links)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("folder", type=pathlib.Path, nargs="?", default=SOURCE, help="folder with the Markdown files")
    folder = parser.parse_args().folder.resolve()
    if not markdown_files(folder):
        sys.exit(f"check_links: {folder} has no Markdown files; name the source folder")
    broken, count = broken_links(folder)
    end_of_check("check_links", broken, f"{count} links lead somewhere")


if __name__ == "__main__":
    main()
