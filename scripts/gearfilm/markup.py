"""HTML of pages: their style, tables and pictures. What is wider than the screen scrolls by itself."""
import base64
import html

STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 62em; padding: 0 1em; color: #222; }
h1 { font-size: 1.6em; margin-bottom: 0; overflow-wrap: anywhere; }
h2 { font-size: 1.15em; border-bottom: 1px solid #ccc; margin-top: 2em; } h3 { font-size: 1em; margin-bottom: .3em; }
.wide { overflow-x: auto; } table { border-collapse: collapse; }
td, th { padding: .2em .9em .2em 0; text-align: left; vertical-align: top; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; }
td.unit { white-space: nowrap; } tr:nth-child(even) { background: #f5f7f9; } td code { background: none; padding: 0; color: #666; font-size: .85em; }
img { max-width: 100%; } pre, code { background: #f2f2f2; }
pre { padding: .6em; overflow-x: auto; } .warning { color: #a33d00; }
@media (max-width: 600px) {
  body { font-size: 14px; margin: 1em auto; padding: 0 .6em; } h1 { font-size: 1.3em; }
  td, th { padding-right: .5em; font-size: 13px; } td code { display: block; }
  td.words { min-width: 11em; overflow-wrap: anywhere; }
  img { max-width: none; width: 640px; }
}
@media print { body { margin: 0; max-width: none; } h2 { break-after: avoid; } }
"""


GENERATOR = '<meta name="generator" content="gearfilm">'  # by which a page is known as one of ours


def head(title):
    """Everything before the content of a page."""
    return ('<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            + GENERATOR + '<meta name="viewport" content="width=device-width, initial-scale=1">'
            f"<title>{html.escape(title)}</title><style>{STYLE}</style></head><body>\n")


def _has_numbers(text):
    try:
        float(text.partition(",")[0])
    except ValueError:
        return False
    return True


def table(rows, headings=()):
    """A table of texts; a cell of two texts has words, and the name that they have in the results."""
    numeric = [any(_has_numbers(row[n]) for row in rows if not isinstance(row[n], tuple)) for n in range(len(rows[0]))]
    looks = ["number" if number else "words" for number in numeric]
    if "unit" in headings:
        looks[headings.index("unit")] = "unit"

    def cell(content, look):
        if isinstance(content, tuple):
            words, name = map(html.escape, content)
            return f'<td class="words">{words} <code>{name}</code></td>'
        return f'<td class="{look}">{html.escape(content)}</td>'

    lines = ['<div class="wide"><table>']
    if headings:
        lines.append("<tr>" + "".join(f'<th class="{look}">{html.escape(heading)}</th>'
                                      for heading, look in zip(headings, looks)) + "</tr>")
    lines += ["<tr>" + "".join(map(cell, row, looks)) + "</tr>" for row in rows]
    return "\n".join([*lines, "</table></div>"])


def picture(content, words):
    """A PNG inside the page."""
    source = f"data:image/png;base64,{base64.b64encode(content).decode()}"
    return f'<div class="wide"><img alt="{html.escape(words)}" src="{source}"></div>'


def warning(text):
    return f'<p class="warning">{html.escape(text)}</p>'
