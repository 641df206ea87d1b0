#!/usr/bin/env bash
# Prints a header, its first comment as Doxygen's comment of the file.
#   scripts/checks/file_comments.sh HEADER
set -euo pipefail
awk '
  function end_equations() { if (equations) print "@endverbatim"; equations = 0 }
  NR == 1 && /^\/\// { comment = 1; print "/*! @file" }
  comment && !/^\/\// { end_equations(); print "*/"; comment = 0 }
  !comment { print; next }
  {
    sub(/^\/\/ ?/, "")
    gsub(/\*\//, "* /")
    # An indented line is an equation: as it stands.
    if (/^  / && !equations) { print "@verbatim"; equations = 1 }
    if (!/^  / && !/^$/) end_equations()
    print
  }
' "$1"
