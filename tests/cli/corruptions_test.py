"""Random corruptions of the valid cases: each is refused in one clear line, or gives plausible results.

Mutant n follows from the number n alone. Environment: GEARFILM_MUTANTS, how many (200); GEARFILM_MUTANTS_FROM, the
number of the first (0). One that failed again: GEARFILM_MUTANTS=1 GEARFILM_MUTANTS_FROM=n.
"""
import concurrent.futures
import json
import math
import os
import pathlib
import random
import re
import subprocess
import tempfile
import unittest

from program import INPUT, PROGRAM, Run, names_below

COUNT = int(os.environ.get("GEARFILM_MUTANTS", "200"))
FIRST = int(os.environ.get("GEARFILM_MUTANTS_FROM", "0"))
SECONDS = 20
CASES = [path.read_bytes() for path in sorted(INPUT.glob("*.yaml"))]
KEYS = re.findall(r"^\| `([\w.]+)`", subprocess.run([PROGRAM, "parameters"], capture_output=True, text=True, check=True,
                                                   timeout=SECONDS).stdout, re.MULTILINE)
NUMBER = re.compile(rb"(?<=: )[-+.\de]+(?= *$)", re.MULTILINE)
WORDS = [b"nan", b"-nan", b"inf", b".inf", b"1e400", b"-1e400", b"1e-400", b"1e300", b"1e-300", b"1e-310", b"0", b"-0",
         b"-1", b"1", b"2", b"0x10", b"1,5", b"1_0", b"true", b"yes", b"no", b"~", b"''", b"null", b"28.5", b"20 mm",
         b"9" * 40, b"3e", b"e3", b"+-3", b"--3", b"[1]", b"{a: 1}", b"*a", b"&a 1", b"!!int 1", b"|", b">", b"'", b'"',
         b"%", b"@", b"`", b"contact", b"gear_pair", b"table", b"line_equivalent", b"barus", b"quasistatic",
         b"position", b"\xff", b"\x00"]
# Positive in every result.
POSITIVE = ["a", "b", "p_hertz", "hertz_approach", "M", "L", "D", "kappa", "load", "R_x", "R_y", "E_prime",
            "entrainment_velocity", "hamrock_dowson_h_central", "nijenbanning_venner_moes_h_central"]


def change_number(text, dice, change):
    numbers = list(NUMBER.finditer(text))
    if not numbers:
        return text
    number = dice.choice(numbers)
    return text[:number.start()] + change(number.group()) + text[number.end():]


def change_lines(text, change):
    lines = text.split(b"\n")
    change(lines)
    return b"\n".join(lines)


def flip_byte(text, dice):
    n = dice.randrange(len(text))
    return text[:n] + bytes([text[n] ^ 1 << dice.randrange(8)]) + text[n + 1:]


def insert_bytes(text, dice):
    n = dice.randrange(len(text))
    inserted = dice.choice([dice.randbytes(dice.randint(1, 4)), dice.choice(WORDS), b"\n", b"\t", b": ", b"  ", b"- "])
    return text[:n] + inserted + text[n:]


def cut_end(text, dice):
    return text[:dice.randrange(len(text))]


def cut_middle(text, dice):
    n = dice.randrange(len(text))
    return text[:n] + text[n + dice.randint(1, 40):]


def delete_line(text, dice):
    return change_lines(text, lambda lines: lines.pop(dice.randrange(len(lines))))


def repeat_line(text, dice):
    return change_lines(text, lambda lines: lines.insert(dice.randrange(len(lines)), dice.choice(lines)))


def swap_lines(text, dice):
    def swap(lines):
        m, n = dice.randrange(len(lines)), dice.randrange(len(lines))
        lines[m], lines[n] = lines[n], lines[m]
    return change_lines(text, swap)


def swap_values(text, dice):
    """The number of one key for another."""
    other = dice.choice(NUMBER.findall(text) or [b"1"])
    return change_number(text, dice, lambda _: other)


def scale_number(text, dice):
    return change_number(text, dice, lambda number: number + b"e%d" % dice.choice([-9, -6, -3, -2, -1, 1, 2, 3, 6, 9])
                         if b"e" not in number else b"%g" % (float(number) * 10.0 ** dice.randint(-9, 9)))


def shift_number(text, dice):
    """A little: the pair hardly fits together."""
    return change_number(text, dice, lambda number: b"%g" % (float(number) * dice.uniform(0.5, 2)))


def negate_number(text, dice):
    return change_number(text, dice, lambda number: b"-" + number)


def replace_number(text, dice):
    return change_number(text, dice, lambda _: dice.choice(WORDS))


def add_key(text, dice):
    return text + b"%s: %s\n" % (dice.choice(KEYS).encode(), random_value(dice))


def random_value(dice):
    return dice.choice([dice.choice(WORDS), b"%g" % (dice.choice([-1, 1]) * 10 ** dice.uniform(-12, 12)),
                        b"%d" % dice.randint(-5, 300)])


MUTATIONS = [flip_byte, insert_bytes, cut_end, cut_middle, delete_line, repeat_line, swap_lines, swap_values,
             negate_number, add_key, *4 * [scale_number, shift_number, replace_number]]


def mutant(number):
    """Content of a case file, and options."""
    dice = random.Random(number)
    text = dice.choice(CASES)
    for _ in range(dice.choice([0, 1, 1, 1, 1, 2, 3])):
        try:
            text = dice.choice(MUTATIONS)(text, dice) or b"\n"
        except ValueError:  # an earlier mutation left no number there
            pass
    options = []
    for key in dice.sample(KEYS, dice.choice([0, 0, 0, 1, 2])):
        value = random_value(dice).replace(b"\x00", b"")
        options += ["-" + key.replace(".", "_"), os.fsdecode(value)]
    return text, options


def faults(number):
    """What is wrong with the program's answer to a mutant; empty where all is well."""
    text, options = mutant(number)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "case.yaml").write_bytes(text)
        try:
            run = Run(["info", "case.yaml", *options], 1, folder, SECONDS)
        except (subprocess.TimeoutExpired, UnicodeDecodeError) as error:
            return repr(error)
        lines = run.stderr.splitlines()
        if run.status == 1:
            refused = len(lines) == 1 and lines[0].startswith("gearfilm: wrong input: ") and len(lines[0]) < 1500
            return "" if refused and not run.stdout and names_below(folder) == ["case.yaml"] else f"not one line: {run}"
        if run.status != 0 or not all(line.startswith("gearfilm: warning: ") for line in lines):
            return f"neither done nor refused: {run}"
        summaries = list(folder.rglob("summary.json"))
        if len(summaries) != 1:
            return f"{len(summaries)} summaries: {run}"
        return implausible(json.loads(summaries[0].read_text(encoding="utf-8")), lines)


def implausible(summary, warnings):
    numbers = {name: value for name, value in summary.items() if isinstance(value, (int, float))}
    # Along a whole face there is neither an ellipse's formula nor, without crowning, a radius; D is zero then.
    of_face = {"R_y", "D"} | {name for name in POSITIVE if name.startswith(("hamrock", "nijenbanning"))}
    needed = set(POSITIVE) - of_face if "moes_line_h_central" in numbers else set(POSITIVE)
    for name, value in numbers.items():
        if not math.isfinite(value) or value < 0 and name in POSITIVE or value == 0 and name in needed:
            return f"{name} = {value}"
    if not needed <= set(numbers):
        return f"results are missing: {sorted(numbers)}"
    if not summary.get("contact_ratio", 1) >= 1:
        return f"contact ratio {summary['contact_ratio']}"
    if summary["p_hertz"] > 0.1 * summary["E_prime"]:
        return f"Hertz pressure {summary['p_hertz']} Pa"
    if not warnings and not 0.05e9 <= summary["p_hertz"] <= 4e9:
        return f"no warning of the Hertz pressure {summary['p_hertz']} Pa"
    return ""


class Corruptions(unittest.TestCase):
    def test_every_mutant_is_refused_or_plausible(self):
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            numbers = range(FIRST, FIRST + COUNT)
            for number, fault in zip(numbers, pool.map(faults, numbers)):
                with self.subTest(mutant=number):
                    text, options = mutant(number)
                    self.assertEqual(fault, "", f"\noptions {options}, case file:\n{text.decode(errors='replace')}")


if __name__ == "__main__":
    unittest.main()
