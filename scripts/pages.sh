#!/usr/bin/env bash
# Makes the pages of the documents and of the public headers with Doxygen, into build/pages/html; a warning is an error.
# Before that, links, spelling, lines and tables of the documents are checked.
#   scripts/pages.sh [BUILD]       a configured build folder, build/release by default
# Formulas need no network: the site has its own copy of what it needs of MathJax 2, Debian's or the one that MATHJAX
# names.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release}
mathjax=${MATHJAX:-/usr/share/javascript/mathjax}
command -v doxygen >/dev/null && command -v hunspell >/dev/null && [ -f "$mathjax/MathJax.js" ] ||
  scripts/support/install.sh doxygen hunspell hunspell-en-gb libjs-mathjax
[ -f "$build/CMakeCache.txt" ] || cmake --preset release >/dev/null

python=${PYTHON:-/usr/bin/python3}
"$python" -B scripts/checks/check_links.py
"$python" -B scripts/checks/documents.py
# The headers that are installed, and nothing else, are public.
rm -rf build/pages
cmake --install "$build" --prefix "$PWD/build/pages/headers" --component headers >/dev/null
headers=build/pages/headers/include
documents=build/pages/documents
"$python" -B scripts/checks/page_sources.py "$documents"
doxygen -l build/pages/layout.xml
"$python" -B scripts/checks/site_menu.py build/pages/layout.xml
version=$(sed -n 's/^project(gearfilm VERSION \([^ ]*\).*/\1/p' CMakeLists.txt)
{
  cat docs/Doxyfile
  echo "PROJECT_NUMBER = $version"
  echo "INPUT = $headers $documents"
  echo "USE_MDFILE_AS_MAINPAGE = $documents/README.md"
  echo "STRIP_FROM_PATH = $headers"
  echo "STRIP_FROM_INC_PATH = $headers"
  echo "LAYOUT_FILE = build/pages/layout.xml"
  echo "OUTPUT_DIRECTORY = build/pages"
} | doxygen -
site=$PWD/build/pages/html/mathjax
mkdir "$site"
(cd "$mathjax" && cp -rL --parents MathJax.js extensions jax/element jax/input/TeX \
  jax/output/SVG/{jax.js,config.js,autoload,fonts/TeX} "$site")
echo "pages: build/pages/html/index.html"
