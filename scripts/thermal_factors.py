#!/usr/bin/env python3
"""How much thinner films become by the heat in their inlets: computed thermal factors beside formulas.

    scripts/thermal_factors.py FOLDER [--nx 257]

Contacts in pure rolling over L_T = beta eta_0 u_m^2/k, by their speed: circular ones of steel at 1 and 2.5 GPa, and the
pitch point of the case study. Each on NX lines and on half as many: factors, what they tend to towards finer grids with
its error, the formulas of Murch and Wilson and of Gupta. A Markdown table is printed; cases and results stay in FOLDER.
About five minutes.

Environment: GEARFILM, the binary; GEARFILM_LAUNCHER, words before it. Exit status 1, with one line, where a run cannot
be made or a file not be written.
"""
import argparse
import pathlib

from runs import SOURCE, RunError, attempt, one_line_errors
from tables import heading, row

LOADINGS = (0.2, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0)        # L_T
LOADS = {"1": 80.1, "2.5": 1252.0}                     # N, by the Hertz pressure in GPa
VISCOSITY, PER_KELVIN, CONDUCTIVITY = 0.04, 0.04, 0.137
CASE_STUDY = SOURCE / "input/barbieri2013.yaml"
PITCH_SPEED = 29.7445          # of the case study: m/s at SHAFT_SPEED
SHAFT_SPEED = 15000.0          # rpm
DOMAIN = ("-grid_x_min", -4.5, "-grid_x_max", 1.5)
HEAT = ("-friction_law", "eyring", "-thermal_model", "film", "-lubricant_temperature_viscosity", PER_KELVIN)
CIRCULAR = """
case: {{kind: contact}}
contact:
  radius_x: 12.5e-3
  radius_y: 12.5e-3
  reduced_modulus: 226e9
  load: {load!r}
  entrainment_velocity: {speed!r}
lubricant: {{viscosity: 0.04, pressure_viscosity: 2.2e-8}}
"""


def speed_of(loading):
    return (loading * CONDUCTIVITY / (PER_KELVIN * VISCOSITY)) ** 0.5


def solved(case, folder, nx, ny, *options):
    run = attempt("steady", case, folder, *HEAT, "-grid_nx", nx, "-grid_ny", ny, *DOMAIN, *options)
    if run.status != 0:
        raise RunError(f"{case.name}, {nx} x {ny}: {run.message}")
    return run.summary


def cells(case, folder, nx, ny, *options):
    """Films; factor on both grids and its limit, and that of the smallest film; formulas."""
    fine = solved(case, folder, nx, ny, *options)
    coarse = solved(case, folder, (nx + 1) // 2, (ny + 1) // 2, *options)
    factors = [summary["thermal_factor"] for summary in (coarse, fine)]
    error = (factors[1] - factors[0]) / 3
    predictions = fine["predictions"]
    return (f"{1e6 * fine['h_central_isothermal']:.4f}", f"{1e6 * fine['h_central']:.4f}", f"{factors[0]:.3f}",
            f"{factors[1]:.3f}", f"{factors[1] + error:.3f} +- {abs(error):.3f}", f"{fine['thermal_factor_min']:.3f}",
            f"{predictions['murch_wilson_thermal_factor']:.3f}", f"{predictions['gupta_thermal_factor']:.3f}",
            fine["thermal_turns"])


def lines(folder, nx):
    run = folder / "run"
    for pressure, load in LOADS.items():
        for loading in LOADINGS:
            case = folder / "circular.yaml"
            case.write_text(CIRCULAR.format(speed=speed_of(loading), load=load), encoding="utf-8")
            yield row(f"circular, {pressure} GPa", loading, *cells(case, run, nx, nx, "-grid_y_half", 2.5))
    for loading in LOADINGS:
        speed = SHAFT_SPEED * speed_of(loading) / PITCH_SPEED
        yield row("pitch point", loading, *cells(CASE_STUDY, run, nx, (nx + 1) // 2, "-pinion_speed_rpm", speed))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="folder of the case files and results")
    parser.add_argument("--nx", type=int, default=257, help="lines of the finer grid (%(default)s)")
    arguments = parser.parse_args()
    with one_line_errors("thermal_factors", arguments.folder):
        arguments.folder.mkdir(parents=True, exist_ok=True)
        print(heading("contact", "L_T", "h_c cold [um]", "h_c [um]", "factor, half the lines", "factor",
                      "towards finer grids", "of h_min", "Murch-Wilson", "Gupta", "turns"))
        for line in lines(arguments.folder, arguments.nx):
            print(line, flush=True)


if __name__ == "__main__":
    main()
