"""Markdown tables, for the scripts that print them."""


def row(*cells):
    return f"| {' | '.join(map(str, cells))} |"


def heading(*columns):
    return f"{row(*columns)}\n|{'---|' * len(columns)}"


def percent(change, digits=1):
    return f"{round(100 * change, digits) + 0.0:+.{digits}f} %"  # + 0.0: no "-0.0"
