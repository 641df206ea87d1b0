"""Gear pairs as drawn from a catalogue: case files from a seed.

Standard modules, 17 to 100 teeth, 20 deg, axes at the standard distance, addenda of
one module, faces ten modules wide, crowned by 5 to 30 um, of steel, as solid discs; 100 to 12000 rpm, Hertz pressures
of 0.6 to 2 GPa at the pitch point; mineral oils ISO VG 32 to 460 at 40 to 100 deg C. Pair N of a seed does not depend
on those before it. A case says nothing of domain, grid, or steps.
"""
import math
import pathlib
import random
import tempfile

from studies.common import oils
from studies.common.pairs import case_text, disc_inertia, logarithmic
from studies.common.runs import attempt

SEED = 1
MODULES = (1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8)     # mm
TEETH = (17, 100)
LARGEST_RATIO = 6
FACE_WIDTH = 10                # modules
CROWNING = (5e-6, 30e-6)       # of the pair [m]
# What of it the pinion has.
SHARES = (1.0, 0.0, 0.5)
SPEED = (100.0, 12000.0)       # of the pinion [rpm]
PRESSURE = (0.6e9, 2e9)        # of Hertz at the pitch point [Pa]
CELSIUS = (40.0, 100.0)        # of the oil
FASTEST = 100.0                # pitch line [m/s]
WIDEST_CONTACT = 0.45          # half-axis b under the static load over the face width
TRIAL_TORQUE = 100.0           # N m


def gears(draw):
    """Geometry and material."""
    module = 1e-3 * draw.choice(MODULES)
    pinion = round(logarithmic(draw, *TEETH))
    wheel = round(logarithmic(draw, pinion, min(TEETH[1], LARGEST_RATIO * pinion)))
    width = FACE_WIDTH * module
    crowning, share = logarithmic(draw, *CROWNING), draw.choice(SHARES)
    pair = {"gear.module": module, "gear.pressure_angle_deg": 20.0,
            "gear.centre_distance": 0.5 * module * (pinion + wheel), "gear.face_width": width}
    for gear, teeth, part in (("pinion", pinion, share), ("wheel", wheel, 1 - share)):
        radius = 0.5 * module * teeth
        pair |= {f"{gear}.teeth": teeth, f"{gear}.outer_radius": radius + module, f"{gear}.crowning": part * crowning,
                 f"{gear}.youngs_modulus": 206e9, f"{gear}.poisson_ratio": 0.3,
                 f"{gear}.inertia": disc_inertia(width, radius)}
    return pair


def oil(draw):
    viscosity = oils.viscosity(draw.choice(sorted(oils.VISCOSITY_AT_100)), draw.uniform(*CELSIUS))
    return {"lubricant.viscosity": viscosity, "lubricant.pressure_viscosity": oils.pressure_viscosity(viscosity)}


def pitch_line_velocity(pair):
    return math.pi / 30 * pair["pinion.speed_rpm"] * 0.5 * pair["gear.module"] * pair["pinion.teeth"]


def trial_contact(pair, derive):
    """Largest pressure and half-axis b of the ellipse under the trial torque; None where the pair is refused."""
    torque = TRIAL_TORQUE
    derived = derive(pair)
    # Films over the whole face have no ellipse: that of a lighter load, grown as Hertz's.
    while derived is not None and derived["b"] == 0.5 * pair["gear.face_width"]:
        torque /= 10
        derived = derive(pair | {"pinion.torque": torque})
    if derived is None:
        return None
    growth = (TRIAL_TORQUE / torque) ** (1 / 3)
    return growth * derived["p_hertz"], growth * derived["b"]


def catalogue_pair(draw, derive):
    """Parameters, and what `info` derives from them; `derive` asks it, and gives None where it refuses a pair."""
    while True:
        pair = gears(draw) | oil(draw) | {"pinion.speed_rpm": logarithmic(draw, *SPEED), "pinion.torque": TRIAL_TORQUE}
        pressure = draw.uniform(*PRESSURE)
        if pitch_line_velocity(pair) > FASTEST:
            continue
        trial = trial_contact(pair, derive)
        if trial is None:
            continue
        # Pressures and half-axes of Hertz grow as the cube root of the load.
        trial_pressure, trial_b = trial
        growth = pressure / trial_pressure
        if growth * trial_b > WIDEST_CONTACT * pair["gear.face_width"]:
            continue
        pair["pinion.torque"] *= growth ** 3
        derived = derive(pair)
        if derived is not None:
            return pair, derived


def derive_in(folder):
    """`info` in a folder, as catalogue_pair needs it."""
    def derive(pair):
        case = folder / "case.yaml"
        case.write_text(case_text(pair), encoding="utf-8")
        run = attempt("info", case, folder)
        return run.summary if run.status == 0 else None

    return derive


def write_pair(folder, seed, number):
    """The case file of a pair, and what `info` derives from it."""
    with tempfile.TemporaryDirectory() as scratch:
        pair, derived = catalogue_pair(random.Random(f"{seed}:{number}"), derive_in(pathlib.Path(scratch)))
    folder.mkdir(parents=True, exist_ok=True)
    case = folder / f"{seed}-{number}.yaml"
    case.write_text(case_text(pair), encoding="utf-8")
    return case, derived


def add_arguments(parser):
    parser.add_argument("folder", type=pathlib.Path, help="folder of the case files")
    parser.add_argument("--pairs", type=int, default=40, help="how many (%(default)s)")
    parser.add_argument("--first", type=int, default=0, help="number of the first (%(default)s)")
    parser.add_argument("--seed", type=int, default=SEED, help="(%(default)s)")
