"""What checks read in Markdown files (lines that are no code, links, headings with the anchors that they get), and how
they end."""
import re
import sys

FENCE = re.compile(r"\s*(```|~~~)")
CODE = re.compile(r"(`+)(?:(?!`).)*?\1")
LINK = re.compile(r"\]\(\s*<?([^()\s>]+(?:\([^()\s]*\)[^()\s>]*)?)>?(?:\s+\"[^\"]*\")?\s*\)")
HEADING = re.compile(r"(#{1,6})\s+(.*?)\s*#*$")


def prose(text):
    """Number and text of the lines that are neither in a fence nor indented code."""
    fence = None
    before_is_blank = True
    in_list = False
    for number, line in enumerate(text.splitlines(), 1):
        mark = FENCE.match(line)
        if mark and fence in (None, mark[1]):
            fence = None if fence else mark[1]
            continue
        if fence:
            continue
        if line and not line[0].isspace():
            in_list = bool(re.match(r"([-*+]|\d+[.)])\s", line))
        indented = line.startswith("    ") and before_is_blank and not in_list
        if not indented:
            yield number, line
        # Further lines of an indented block are code as well.
        before_is_blank = not line.strip() or indented


def links_of(line):
    """Targets of links and images, but for those in code."""
    return LINK.findall(CODE.sub("", line))


def anchor_of(title):
    """The anchor of a heading: small letters, digits, _ and -, blanks as -."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", title)
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


def headings(text):
    """Line number, level, title and anchor of every heading; the second of one name gets -1."""
    seen = {}
    for number, line in prose(text):
        found = HEADING.match(line)
        if not found:
            continue
        anchor = anchor_of(found[2])
        again = seen.get(anchor, 0)
        seen[anchor] = again + 1
        yield number, len(found[1]), found[2], f"{anchor}-{again}" if again else anchor


def anchors(text):
    """All anchors of a file, those that are written as HTML too."""
    return {heading[3] for heading in headings(text)} | set(re.findall(r"<a (?:id|name)=\"([^\"]+)\"", text))


def end_of_check(name, faults, all_well):
    """Prints the faults, one a line, and ends with status 1 where there are any; else prints the last line."""
    for fault in faults:
        print(f"{name}: {fault}", file=sys.stderr)
    if faults:
        sys.exit(1)
    print(all_well)
