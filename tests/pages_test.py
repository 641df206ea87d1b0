"""The pages of documents and public headers are made without a warning, and their links lead somewhere.

Environment: GEARFILM_BUILD, a configured build folder.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

SOURCE = pathlib.Path(__file__).resolve().parents[1]
BUILD = os.environ.get("GEARFILM_BUILD", str(SOURCE / "build/release"))
PAGES = SOURCE / "build/pages/html"
MATHJAX = pathlib.Path(os.environ.get("MATHJAX", "/usr/share/javascript/mathjax")) / "MathJax.js"
sys.path.insert(0, str(SOURCE / "scripts/checks"))
from documents import long_lines, misspelt, table_faults  # noqa: E402
from page_sources import label, page_source, site_pages  # noqa: E402


def read(path):
    return path.read_text(encoding="utf-8")


def anchors(path):
    return set(re.findall(r'(?:id|name)="([^"]+)"', read(path)))


def broken_links(page):
    """Links and images of a page of the site that are not there."""
    broken = []
    for target in re.findall(r'(?:href|src)="([^"]+)"', read(page)):
        if re.match(r"[a-z]+:", target):
            continue
        place, _, anchor = urllib.parse.unquote(target).partition("#")
        file = PAGES / place if place else page
        if not file.exists() or (anchor and anchor not in anchors(file)):
            broken.append(target)
    return broken


@unittest.skipUnless(shutil.which("doxygen") and shutil.which("hunspell") and MATHJAX.exists(),
                     "Doxygen, hunspell or MathJax is not installed")
class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.done = subprocess.run([SOURCE / "scripts/pages.sh", BUILD], capture_output=True, text=True, check=False,
                                  timeout=120)

    def test_no_warnings(self):
        self.assertEqual((self.done.returncode, self.done.stderr), (0, ""))

    def test_public_headers_have_pages(self):
        self.assertTrue((PAGES / "simulation_8hpp.html").exists())
        self.assertIn("dH0/dT", read(PAGES / "structgearfilm_1_1Step.html"))
        for private in ("multigrid__level", "mesh__march"):
            self.assertFalse(list(PAGES.glob(f"*{private}*")), "private headers have no pages")

    def test_every_document_has_a_page_whose_links_lead_somewhere(self):
        for name in [*(f"docs/{path.name}" for path in (SOURCE / "docs").glob("*.md")), "README.md", "CONTRIBUTING.md"]:
            with self.subTest(document=name):
                self.assertIn(name, site_pages())
                page = PAGES / f"{label(name)}.html"
                self.assertTrue(page.exists())
                self.assertGreater(len(read(page)), 4000)
                self.assertEqual(broken_links(page), [])

    def test_formulas_and_figures_are_shown(self):
        model = read(PAGES / f"{label('docs/model.md')}.html")
        self.assertGreater(model.count('class="formulaDsp"'), 20)
        self.assertNotIn("$$", model)
        self.assertIn('src="fig04_contact.png"', model)
        self.assertIn('src="mathjax/MathJax.js"', model)
        self.assertTrue((PAGES / "mathjax/jax/output/SVG/jax.js").exists())


@unittest.skipUnless(shutil.which("hunspell"), "hunspell is not installed")
class Documents(unittest.TestCase):
    """What is a fault in a page."""

    def faults(self, text):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text(f"# A page\n\n{text}\n", encoding="utf-8")
            found = [*table_faults(page, False), *long_lines(page), *misspelt(page)]
        return [re.sub(r"[;(].*", "", fault) for fault in found]

    def test_words(self):
        self.assertEqual(self.faults("The film of gearfilm, `no wrod`, $wrod$, 12e3 and [text](wrod.md)."), [])
        self.assertEqual(self.faults("A wrod."), ["3: 'wrod' is no known word"])

    def test_lines(self):
        self.assertEqual(self.faults("word " * 24 + "\n| " + "word " * 40 + "|"), [])
        self.assertEqual(self.faults("word " * 25), ["3: 125 characters"])

    def test_tables(self):
        self.assertEqual(self.faults("<!-- table no_such -->\n| a |\n<!-- end -->\n"),
                         ["1: table no_such: there is no docs/data/no_such.md"])
        self.assertEqual(self.faults("<!-- table film_errors -->\n| a |\n<!-- end -->\n"),
                         ["1: table film_errors is not docs/data/film_errors.md"])


class Sources(unittest.TestCase):
    """What becomes of a line of Markdown on its way to Doxygen."""

    def source(self, line):
        return page_source("docs/a.md", f"# A\n\n{line}\n", {"README.md", "docs/a.md", "docs/b.md"}).splitlines()[2]

    def test_links(self):
        for line, expected in (("[b](b.md)", "[b](@ref page_docs_b)"), ("[b](b.md#x-y)", "[b](@ref page_docs_b-x-y)"),
                               ("[a](#x)", "[a](@ref page_docs_a-x)"), ("[first](../README.md)", "[first](@ref index)"),
                               ("[`code`](../scripts/x.sh)", "`code`"), ("![x](figures/x.png)", "![x](x.png)"),
                               ("[out](https://example.org/)", "[out](https://example.org/)")):
            self.assertEqual(self.source(line), expected)

    def test_formulas_but_not_in_code(self):
        self.assertEqual(self.source("$a$ and `$b$`"), r"\f$a\f$ and `$b$`")
        self.assertEqual(self.source("$$ c $$"), r"\f[ c \f]")
        self.assertEqual(self.source("    echo $d $e"), "    echo $d $e")

    def test_paragraphs_in_italics_may_begin_with_code(self):
        self.assertEqual(self.source("*`a` is\nb.*"), "<em>`a` is")
        self.assertEqual(self.source("*one* word"), "*one* word")

    def test_headings_have_labels(self):
        self.assertEqual(self.source("## Two words"), "## Two words {#page_docs_a-two-words}")


if __name__ == "__main__":
    unittest.main()
