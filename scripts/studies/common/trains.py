"""The case study in a drive train: inertias of its gears in the place of the equivalent mass, and their masses, which
are those of tests/reference/drivetrain.json.
"""
import json
import re

from .runs import SOURCE

REFERENCE = json.loads((SOURCE / "tests/reference/drivetrain.json").read_text(encoding="utf-8"))
CASE_STUDY = REFERENCE["table3"]["input"]
MASSES = ["-pinion_mass", CASE_STUDY["m"][0], "-wheel_mass", CASE_STUDY["m"][1]]


def with_inertias(case, pinion, wheel):
    """The text of a case with these inertias [kg m^2] in the place of its equivalent mass."""
    text = re.sub(r"^  equivalent_mass.*\n", "", case.read_text(encoding="utf-8"), flags=re.MULTILINE)
    for gear, inertia in (("pinion", pinion), ("wheel", wheel)):
        text = text.replace(f"{gear}:\n", f"{gear}:\n  inertia: {inertia!r}\n")
    return text


RELIEF = with_inertias(SOURCE / "input/barbieri2013_relief.yaml", *CASE_STUDY["I"])


def bearings(stiffness):
    """Options of both gears, with their masses, on bearings of a stiffness [N/m]."""
    return [*MASSES, "-pinion_bearing_stiffness", stiffness, "-wheel_bearing_stiffness", stiffness]
