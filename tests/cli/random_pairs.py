"""Random but valid pairs of spur gears, their domain, grid and march: all parameters of a case, drawn from a seed."""
import math
import sys

import numpy

from film_equations import conditions
from program import SOURCE

sys.path.insert(0, str(SOURCE / "scripts"))
from studies.common.pairs import disc_inertia, logarithmic  # noqa: E402

CONTACT_RATIO = (1.05, 2.2)
# R_x at the ends of the path over that at the pitch point. It is zero where teeth meet on a base circle, and a contact
# there is a point on the grid of the one at the pitch point: it was refused as too thin at 0.02.
END_RADIUS = 0.25
PRESSURE = (0.4e9, 3.5e9)       # of Hertz at the pitch point [Pa]
ENTRAINMENT = (1.0, 30.0)       # at the pitch point [m/s]
# Free oscillations in a mesh period. Pairs that have more are thrown about within few time steps where a contact enters
# on a pair at rest: they can be marched, but take a minute.
OSCILLATIONS = 3.0
# Inlets, over what a flooded contact needs: with just that length films computed here are up to 6 % thinner.
LONG_INLET, SHORT_INLET = (1.5, 3.0), (0.8, 1.5)
GRIDS = (129, 257)              # nodes in x
MESH_ERROR = 0.02               # of the central film, about: those at the sides are thinner, and stay positive with it
TRIAL = {"pinion.torque": 100.0, "pinion.speed_rpm": 1000.0}


def gears(draw):
    """From a speed-up of two to a reduction of five, tips short or long, axes at the standard distance or not."""
    pinion = draw.randint(17, 45)
    teeth = {"pinion": pinion, "wheel": max(17, round(pinion * logarithmic(draw, 0.5, 5)))}
    module = logarithmic(draw, 1e-3, 8e-3)
    shift = draw.choice((0.0, draw.uniform(-0.2, 0.4)))  # of the axes, in modules; each gear takes half of it
    width = module * draw.uniform(5, 14)
    pair = {"gear.module": module, "gear.pressure_angle_deg": draw.choice((14.5, 17.5, 20, 20, 22.5, 25)),
            "gear.centre_distance": module * (0.5 * sum(teeth.values()) + shift), "gear.face_width": width}
    for gear, number in teeth.items():
        radius = 0.5 * module * number
        pair |= {f"{gear}.teeth": number,
                 f"{gear}.outer_radius": radius + module * (draw.uniform(0.75, 1.3) + 0.5 * shift),
                 f"{gear}.crowning": logarithmic(draw, 10e-6, 300e-6),
                 # Steel, or anything from bronze to a hard steel.
                 f"{gear}.youngs_modulus": draw.choice((206e9, draw.uniform(90e9, 230e9))),
                 f"{gear}.poisson_ratio": draw.uniform(0.25, 0.34),
                 # From a disc of steel with holes to one with what turns on its shaft.
                 f"{gear}.inertia": logarithmic(draw, 0.5, 30) * disc_inertia(width, radius)}
    return pair


def oil(draw, pressure):
    """At running temperature; Roelands' exponent z as mineral and synthetic oils have it, Barus' law below 1 GPa."""
    viscosity = logarithmic(draw, 0.008, 0.15)
    barus = pressure < 1e9 and draw.random() < 0.3
    return {"lubricant.viscosity": viscosity,
            "lubricant.pressure_viscosity": draw.uniform(0.5, 0.75) * (math.log(viscosity) + 9.67) / 1.96e8,
            "lubricant.viscosity_law": "barus" if barus else "roelands",
            "lubricant.density_law": draw.choice(("dowson_higginson", "dowson_higginson", "incompressible"))}


def predicted_film(derived):
    """The central film of the formula in units of a^2/R_x."""
    return derived["nijenbanning_venner_moes_h_central"] * derived["R_x"] / derived["a"] ** 2


def flooded_inlet(derived):
    """Length before the Hertz contact, in units of a, with which Hamrock and Dowson call a contact fully flooded.

    m* - 1 = 3.06 H^0.58 with H = h R_x/a^2: Journal of Lubrication Technology 99 (1977) 15-23.
    """
    return 3.06 * predicted_film(derived) ** 0.58


def mesh_error(derived, h_x):
    """About the relative error of the central film on a grid of step h_x.

    Pressure rises in the inlet over a length of H^(2/3). Errors in docs/data/verify_range.md
    are half to one and a half of this.
    """
    return h_x ** 2 / predicted_film(derived) ** (4 / 3)


def domain(draw, derived):
    """A long inlet mostly, sides and outlet for three times the static load; None where GRIDS are too coarse."""
    inlet = flooded_inlet(derived) * draw.uniform(*draw.choice((LONG_INLET, LONG_INLET, LONG_INLET, SHORT_INLET)))
    x_min, x_max = -1 - max(1.0, inlet), 1.5
    for nx in GRIDS:
        if mesh_error(derived, (x_max - x_min) / (nx - 1)) < MESH_ERROR:
            return {"grid.x_min": x_min, "grid.x_max": x_max, "grid.y_half": 1.5 if derived["M"] > 200 else 2.5,
                    "grid.nx": nx, "grid.ny": 65}
    return None


def isoviscous_share(pair):
    """alpha*/alpha_B: 1/alpha* is the integral of eta_0/eta over pressure, 1/alpha_B that of Barus' law.

    Roelands' viscosity grows more slowly. A film in which it does behaves like one of Barus' law with alpha*, and its
    height goes about with the power 3/4 of that.
    """
    if pair["lubricant.viscosity_law"] == "barus":
        return 1.0
    alpha, span = pair["lubricant.pressure_viscosity"], math.log(pair["lubricant.viscosity"]) + 9.67
    p = numpy.linspace(0, 40 / alpha, 10001)
    viscosity = numpy.exp(span * ((1 + p / 1.96e8) ** (alpha * 1.96e8 / span) - 1))
    integrand = 1 / viscosity
    return 1 / (alpha * numpy.sum((integrand[1:] + integrand[:-1]) / 2 * numpy.diff(p)))


def formula_holds(pair, derived):
    """Whether the central film can be expected to be that of the formula.

    The inlet is long. The film is thinner than the deformation a^2/R_x: thicker ones are in the rigid regime, for which
    the exponents of the formula are second-hand. The oil is near one of Barus' law, which the formula knows: 0.87^(3/4)
    is 0.90.
    """
    return (-1 - pair["grid.x_min"] >= LONG_INLET[0] * flooded_inlet(derived) and predicted_film(derived) < 1
            and isoviscous_share(pair) > 0.87)


def march(draw, derived):
    """A tenth to a quarter of a mesh period from the pitch point, or with an entering or a leaving in its middle."""
    span = draw.uniform(0.1, 0.25)
    start = {"pitch": 0.0, "entry": derived["xi_entry"] + (1 - 0.5 * span) * derived["base_pitch"],
             "exit": derived["xi_exit"] - 0.5 * span * derived["base_pitch"]}[draw.choice(("pitch", "entry", "exit"))]
    # A dozen steps in a free oscillation.
    steps = max(25, math.ceil(12 * span * derived["f_n"] / derived["f_m"]))
    return {"start.place": "position", "start.position": start, "mesh_periods": span,
            "time.dt": span * derived["mesh_period_dimensionless"] / steps, "output.snapshot_interval": 1e-6}


def meshes_well(pair, derived):
    """Contact ratio, and no contact next to a base circle."""
    ends = [conditions(pair, derived, derived[f"xi_{end}"])[0] for end in ("entry", "exit")]
    return CONTACT_RATIO[0] < derived["contact_ratio"] < CONTACT_RATIO[1] and min(ends) > END_RADIUS


def random_pair(draw, derive):
    """Parameters, and what `info` derives from them; `derive` asks it, and gives None where it refuses a pair."""
    while True:
        pressure, entrainment = logarithmic(draw, *PRESSURE), logarithmic(draw, *ENTRAINMENT)
        pair = gears(draw) | oil(draw, pressure) | TRIAL
        trial = derive(pair)
        if trial is None or not meshes_well(pair, trial):
            continue
        # Pressures and half-axes of Hertz grow as the cube root of the load, velocities as the speed.
        growth = pressure / trial["p_hertz"]
        if 2 * growth * trial["b"] > pair["gear.face_width"]:
            continue  # the ellipse would end at the sides of the teeth
        pair["pinion.torque"] *= growth ** 3
        pair["pinion.speed_rpm"] *= entrainment / trial["entrainment_velocity"]
        derived = derive(pair)
        room = domain(draw, derived)
        if room is not None and derived["f_n"] < OSCILLATIONS * derived["f_m"]:
            return pair | room | march(draw, derived), derived
