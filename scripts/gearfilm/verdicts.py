"""What fails first: the safeties of a summary in one table, the least one first."""

DIGITS = 4
TITLES = {"pitting": "pitting: contact stress", "root_pinion": "root of the pinion's teeth",
          "root_wheel": "root of the wheel's teeth", "flash": "scuffing: flash temperature",
          "integral": "scuffing: integral temperature", "micropitting": "micropitting: film ratio"}
HEADINGS = ("of", "computed", "limit", "unit", "safety", "where")


def _text(value, factor=1.0):
    return "" if value is None else f"{factor * value:.{DIGITS}g}"


def _rating(name, rating):
    """Computed value, limit, unit and place of an entry of the table `safety`."""
    kind = next(kind for kind in ("stress", "temperature", "lambda_GF") if kind in rating)
    factor, unit = {"stress": (1e-6, "MPa"), "temperature": (1.0, "K"), "lambda_GF": (1.0, "-")}[kind]
    where = f"xi = {_text(rating['xi'], 1e3)} mm" if "xi" in rating else "over the path of contact"
    return rating["safety"], (TITLES[name], _text(rating[kind], factor), _text(rating["limit"], factor), unit,
                              _text(rating["safety"]), where)


def _flank(summary, gear):
    """The Dang Van stress of a gear; its limit depends on the depth, and so does its place."""
    safety = summary.get(f"safety_dang_van_{gear}")
    place = "dang_van" if safety is None else "safety_dang_van"
    where = "s = {} mm, {} mm deep".format(*(_text(summary[f"{place}_{axis}_{gear}"], 1e3) for axis in "sz"))
    return safety, (f"flank of the {gear}: Dang Van stress", _text(summary[f"dang_van_max_{gear}"], 1e-6), "", "MPa",
                    _text(safety), where)


def verdicts(summary):
    """Rows for HEADINGS; those without a verdict come last."""
    found = [_flank(summary, gear) for gear in ("pinion", "wheel") if summary.get(f"dang_van_max_{gear}") is not None]
    found += [_rating(name, rating) for name, rating in (summary.get("safety") or {}).items() if rating]
    return [row for _, row in sorted(found, key=lambda entry: (entry[0] is None, entry[0] or 0.0))]
