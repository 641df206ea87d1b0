#!/usr/bin/env python3
"""Menu of the site: its four parts, those for developers, and the public headers.

    scripts/checks/site_menu.py LAYOUT       the layout that `doxygen -l` has written; its menu is replaced

Tasks are the pages of docs/guide in the order of its list. A title is the first heading of its page.
"""
import pathlib
import re
import sys
import xml.sax.saxutils

from markdown_text import headings, links_of
from page_sources import SOURCE, label

GUIDE = "docs/guide/"
PARTS = (("Tutorial", ("docs/tutorial.md", "docs/gallery.md")),
         ("Tasks", None),
         ("Reference", ("docs/parameters.md", "docs/results.md", "docs/constants.md", "docs/terms.md",
                        "docs/symbols.md", "docs/limits.md")),
         ("Explanation", ("docs/model.md", "docs/numerics.md", "docs/discretisation.md", "docs/verification.md",
                          "docs/performance.md")),
         ("Developers", ("docs/developer.md", "CONTRIBUTING.md", "docs/notes/README.md", "docs/examples/README.md",
                         "scripts/packaging/README.md", "CHANGELOG.md")))


def read(page):
    return (SOURCE / page).read_text(encoding="utf-8")


def tasks():
    """The list of the guide, then its pages in the order in which the list names them."""
    pages = [GUIDE + target for line in read(GUIDE + "README.md").splitlines() for target in links_of(line)
             if re.fullmatch(r"[\w-]+\.md", target)]
    return [GUIDE + "README.md", *dict.fromkeys(pages)]


def tab(kind, title, url, content=""):
    title = xml.sax.saxutils.quoteattr(title)
    head = f'<tab type="{kind}" visible="yes" url="{url}" title={title}'
    return f"{head}>{content}</tab>" if content else f"{head}/>"


def title_of(page):
    return re.sub(r"[`$\\]", "", next(heading[2] for heading in headings(read(page))))


def part(name, pages):
    pages = pages or tasks()
    return tab("usergroup", name, f"@ref {label(pages[0])}",
               "".join(tab("user", title_of(page), f"@ref {label(page)}") for page in pages))


def main():
    if len(sys.argv) != 2:
        sys.exit("site_menu: one file is needed; name the layout that doxygen -l has written")
    layout = pathlib.Path(sys.argv[1])
    try:
        text = layout.read_text(encoding="utf-8")
        menu = [tab("mainpage", "Start", ""), *(part(*one) for one in PARTS),
                tab("files", "Library", "", '<tab type="filelist" visible="yes" title=""/>'
                                            '<tab type="classlist" visible="yes" title=""/>')]
        text = re.sub(r"<navindex>.*?</navindex>", lambda _: f"<navindex>{''.join(menu)}</navindex>", text, flags=re.S)
        layout.write_text(text, encoding="utf-8")
    except OSError as error:
        sys.exit(f"site_menu: {error}; name the layout that doxygen -l has written")


if __name__ == "__main__":
    main()
