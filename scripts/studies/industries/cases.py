"""The twelve pairs as data: gears, oils, their case files, and the commands run on them.

Modules are those of DIN 780, addenda one module, face widths 6 to 25 modules; torques, speeds and oils are usual ones
of such machines, chosen here, not those of any product. Crowning is what a point contact needs to end on the face.
Gears are solid discs.
"""
import dataclasses
import math

from studies.industries import formulas

STEEL = (206e9, 0.3)
BRASS = (105e9, 0.34)


@dataclasses.dataclass(frozen=True)
class Pair:
    """Lengths in m but for those whose unit stands beside; crowning is that of the pinion, the wheel has none."""
    name: str
    industry: str
    module_mm: float
    teeth: tuple
    shift: float                # of the pinion; the wheel's leaves no backlash
    axes_mm: float              # working centre distance
    width_mm: float
    crowning_um: float
    rpm: float
    torque: float
    oil: str
    viscosity: float
    pressure_viscosity: float
    pressure_angle_deg: float = 20
    solids: tuple = (STEEL, STEEL)
    densities: tuple = (formulas.STEEL, formulas.STEEL)

    module = property(lambda pair: 1e-3 * pair.module_mm)
    axes = property(lambda pair: 1e-3 * pair.axes_mm)
    width = property(lambda pair: 1e-3 * pair.width_mm)
    crowning = property(lambda pair: 1e-6 * pair.crowning_um)
    pressure_angle = property(lambda pair: math.radians(pair.pressure_angle_deg))


# Oils are at the temperature of those that enter.
PAIRS = (
    Pair("headstock", "machine tool", 3, (24, 60), 0, 126, 30, 14, 1450, 120, "VG 68, 50 °C", 0.038, 2.1e-8),
    Pair("wind", "wind turbine, fast stage", 8, (27, 100), 0, 508, 200, 50, 1500, 9500,
         "VG 320, 65 °C", 0.078, 2.4e-8),
    Pair("drill", "hand drill", 0.8, (13, 47), 0.3, 24, 6, 8, 18000, 0.35, "oil of a grease, 60 °C", 0.045, 2.2e-8),
    Pair("car", "electric vehicle", 2, (25, 73), 0.25, 98.5, 28, 18, 12000, 110,
         "transmission oil, 80 °C", 0.009, 1.5e-8),
    Pair("marine", "ship", 8, (29, 86), 0, 460, 160, 32, 1800, 5000, "VG 100, 60 °C", 0.036, 2.1e-8),
    Pair("mill", "rolling mill, pinion stand", 10, (30, 30), 0, 300, 200, 60, 180, 20000,
         "VG 460, 50 °C", 0.24, 2.9e-8),
    Pair("printer", "printer, steel on brass", 0.5, (20, 60), 0, 20, 4, 3, 3000, 0.02,
         "instrument oil, 30 °C", 0.025, 1.9e-8, solids=(STEEL, BRASS),
         densities=(formulas.STEEL, formulas.BRASS)),
    Pair("turbo", "helicopter", 4, (31, 97), 0, 256, 45, 25, 9000, 700, "turbine oil, 90 °C", 0.0065, 1.3e-8,
         pressure_angle_deg=25),
    Pair("tractor", "tractor, power take-off", 5, (17, 51), 0.3, 172, 45, 25, 1000, 450,
         "VG 100, 70 °C", 0.025, 1.9e-8),
    Pair("robot", "robot joint", 1, (20, 80), 0, 50, 10, 8, 3000, 2, "oil of a grease, 50 °C", 0.08, 2.3e-8),
    Pair("railway", "railway traction", 7, (19, 87), 0.2, 371, 110, 40, 2200, 2200,
         "gear oil, 80 °C", 0.02, 1.8e-8),
    Pair("pump", "oil pump", 4, (14, 14), 0.4, 59, 25, 12, 1500, 40, "VG 46, 50 °C", 0.026, 2.0e-8),
)

FILM = ("-grid_accuracy", 0.05)
LOOK = ("-grid_accuracy", 0.2)  # for three states
DRY = ("-model", "dry")
FRICTION = 0.05                # coefficient, for the loss factor


def commands(pair):
    """Options of every command, by the name of its run."""
    near, far = 0.9 * pair.rpm, 1.1 * pair.rpm
    return {
        "info": ("info",), "static": ("static",), "bending": ("static", "-gear_tooth_compliance", "weber"),
        "steady": ("steady", *FILM), "eigen": ("eigen", *FILM),
        "dry": ("periodic", *DRY),
        "dry sweep": ("sweep", *DRY, "-sweep_from", near, "-sweep_to", far, "-sweep_points", 3),
        "continuation": ("continuation", *DRY, "-continuation_from", pair.rpm, "-continuation_to", far),
        "transient": ("transient", *FILM, "-mesh_periods", 1),
        "periodic": ("periodic", *FILM, "-friction_law", "coulomb", "-friction_coefficient", FRICTION),
        "sweep": ("sweep", *LOOK, "-sweep_from", near, "-sweep_to", far, "-sweep_points", 3, "-sweep_direction", "up",
                  "-periodic_multipliers", "no"),
    }


def parameters(pair):
    """The case by its dotted names."""
    found = {"case.name": pair.name, "pinion.speed_rpm": pair.rpm, "pinion.torque": pair.torque,
             "gear.module": pair.module, "gear.pressure_angle_deg": pair.pressure_angle_deg,
             "gear.centre_distance": pair.axes, "gear.face_width": pair.width, "lubricant.viscosity": pair.viscosity,
             "lubricant.pressure_viscosity": pair.pressure_viscosity}
    tips, inertias, shifts = formulas.tip_radii(pair), formulas.inertias(pair), formulas.shifts(pair)
    for place, gear in enumerate(("pinion", "wheel")):
        modulus, ratio = pair.solids[place]
        found |= {f"{gear}.teeth": pair.teeth[place], f"{gear}.outer_radius": tips[place],
                  f"{gear}.profile_shift": shifts[place], f"{gear}.inertia": inertias[place],
                  f"{gear}.crowning": 0.0 if place else pair.crowning, f"{gear}.youngs_modulus": modulus,
                  f"{gear}.poisson_ratio": ratio}
    return found
