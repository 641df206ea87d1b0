#!/usr/bin/env python3
"""How large the rooms of the program are, and which rooms they include: Markdown tables.

    scripts/checks/code_size.py

Lines of code are those of src that are neither empty nor comments alone. A function reaches from
the line that opens it to the one that closes it, as clang-format indents them; lambdas count to the function around
them. Includes are counted by the room of the file included, in the order of src/CMakeLists.txt, in which data flows.
"""
import pathlib
import re

SOURCE = pathlib.Path(__file__).resolve().parents[2]
ROOMS = re.findall(r"^gearfilm_room\((\w+)", (SOURCE / "src/CMakeLists.txt").read_text(encoding="utf-8"), re.M)
INCLUDE = re.compile(r'^#include "(?:gearfilm/)?(\w+)/')
NO_FUNCTION = re.compile(r"\s*(?:class|struct|enum|namespace|union|extern|if|for|while|switch|else|do|try|catch|return)\b")


def files_of(room):
    return sorted((SOURCE / "src" / room).glob("*.[ch]pp"))


def is_code(line):
    return bool(line.strip()) and not line.lstrip().startswith("//")


def longest_function(lines):
    """Length, and the first line, of the longest one at the indentation of namespaces and of members."""
    longest = (0, "")
    for indentation in ("", "  "):
        begin = head = None
        for number, line in enumerate(lines):
            text = line[len(indentation):]
            if not line.startswith(indentation) or text[:1] in ("", " ", "#", "/"):
                continue
            if begin is not None and text.startswith("}"):
                longest = max(longest, (number - begin + 1, head))
                begin = None
            elif begin is None and re.search(r"\).*\{$", line) and not NO_FUNCTION.match(text):
                begin, head = number, text.strip()
    return longest


def name_in(head):
    return (re.search(r"([\w:~]+)\(|$", head).group(1) or head).lstrip(":")


def main():
    print("| room | files | lines of code | longest function, lines | includes from |\n|---|---|---|---|---|")
    total = 0
    for room in ROOMS:
        code, longest, includes = 0, (0, ""), {}
        for path in files_of(room):
            lines = path.read_text(encoding="utf-8").splitlines()
            code += sum(map(is_code, lines))
            longest = max(longest, longest_function(lines))
            for found in filter(None, map(INCLUDE.match, lines)):
                includes[found.group(1)] = includes.get(found.group(1), 0) + 1
        total += code
        others = ", ".join(f"{name} {includes[name]}" for name in ROOMS if name in includes and name != room)
        print(f"| `{room}` | {len(files_of(room))} | {code} | `{name_in(longest[1])}`, {longest[0]} | {others} |")
    print(f"| all | | {total} | | |")


if __name__ == "__main__":
    main()
