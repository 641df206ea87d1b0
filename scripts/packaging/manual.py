#!/usr/bin/env python3
"""The manual page, or the completion for bash, of a gearfilm program, from what its -help says.

    scripts/packaging/manual.py man GEARFILM | man -l -
    source <(scripts/packaging/manual.py completion GEARFILM)
"""
import re
import subprocess
import sys

DESCRIPTION = """

Description
gearfilm computes the lubricant films between the teeth of a spur-gear pair, and the vibration of the pair that they
carry, on any number of processes.
A case file describes the pair, or one bare contact, in SI units.
Results are written into a folder, that of -output_dir."""

BEHIND_PARAMETERS = """
Other options
  -help  print commands and parameters
  -version  print the version

Those of PETSc and SLEPc are passed on to them.

Exit status
  0  done
  1  wrong input; nothing is written
  2  not solved, or results that cannot be written
  3  stopped by a signal or the time limit; -restart goes on
"""

# From plain text to roff with its macros "man", one after the other: characters that mean something there; lines set in
# by two blanks, terms with what stands behind them or, after more blanks, below; lines set in farther; headings.
TYPESETTING = [(r"\\", r"\\e"), ("-", r"\\-"), ("'", r"\\(aq"), (r"\^", r"\\(ha"), ("~", r"\\(ti"),
               (r"\n  (\S+)  +", r"\n.TP\n\\fB\1\\fR\n"), (r"\n  (\S+) ", r"\n.TP\n\\fB\1\\fR "), (r"\n +", r"\n"),
               (r"\n\n(\w+( \w+)?)\n", r"\n.SH \1\n"), (r"\n\n(\w+( \w+)?) (\(for .*\))", r"\n.SS \1\n\3"),
               (r"\n\n", r"\n.PP\n")]

# It needs nothing but bash itself, from version 4 on. $current is the word under the cursor, $previous the one before
# it, $command empty where none is given yet. A word behind an option is its value.
COMPLETION = """# Completion of gearfilm for bash.
_gearfilm() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} command='' n
  for ((n = 1; n < COMP_CWORD; n++)); do
    if [[ -z $command && ${{COMP_WORDS[n]}} != -* && ${{COMP_WORDS[n-1]}} != -* ]]; then command=${{COMP_WORDS[n]}}; fi
  done
  COMPREPLY=()
  if [[ $current == -* ]]; then _gearfilm_words '{options}'; return; fi
  case $previous in
{choices}    {files}) _gearfilm_files '!*'; return ;;
    {numbers}) return ;;
  esac
  case $command in
    '') _gearfilm_words '{commands}' ;;
    {without_case}) ;;
    *) _gearfilm_files '!*.yaml' '!*.yml' ;;
  esac
}}
_gearfilm_words() {{
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current")
}}
# Folders, and the files that each pattern leaves; it takes out what does not match behind "!".
_gearfilm_files() {{
  local pattern
  mapfile -t COMPREPLY < <(compgen -d -- "$current"; for pattern; do compgen -f -X "$pattern" -- "$current"; done)
  compopt -o filenames 2>/dev/null || true
}}
complete -F _gearfilm gearfilm
"""


def manual_page(text):
    version = text.split(maxsplit=2)[1]
    usage, commands = text.index("\n  "), text.index("\n\nCommands")
    page = ("\n\nName\ngearfilm - lubricant films and vibration of spur-gear pairs\n\nSynopsis" + text[usage:commands]
            + DESCRIPTION + text[commands:] + BEHIND_PARAMETERS)
    for plain, roff in TYPESETTING:
        page = re.sub(plain, roff, page)
    return f'.TH GEARFILM 1 "" "gearfilm {version}" "User Commands"{page}'


def completion(text):
    commands = re.findall(r"^  ([a-z]+)  +(.*)$", text, re.MULTILINE)
    values = re.findall(r"^  (-\w+) <(.*?)>  \(", text, re.MULTILINE)
    choices = {option: allowed[len("one of "):].split(", ") for option, allowed in values if allowed.startswith("one of ")}
    files = [option for option, allowed in values if allowed == "a word"]
    return COMPLETION.format(
        options=" ".join(["-help", "-version", *(option for option, _ in values)]),
        choices="".join(f"    {option}) _gearfilm_words '{' '.join(words)}'; return ;;\n" for option, words in choices.items()),
        files=" | ".join(files),
        numbers=" | ".join(option for option, _ in values if option not in choices and option not in files),
        commands=" ".join(name for name, _ in commands),
        without_case=" | ".join(name for name, meaning in commands if meaning.endswith("(needs no case)")))


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in ("man", "completion"):
        sys.exit("manual.py: give 'man' or 'completion', and the program gearfilm")
    text = subprocess.run([sys.argv[2], "-help"], capture_output=True, text=True, check=True, timeout=60).stdout
    sys.stdout.write(manual_page(text) if sys.argv[1] == "man" else completion(text))


if __name__ == "__main__":
    main()
