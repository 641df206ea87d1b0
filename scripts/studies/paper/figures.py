"""The figures of the paper: the runs that each needs, what draws it, and the numbers beside the printed ones."""
import json
import pathlib
from typing import Callable, NamedTuple

from studies.common.plotting import pyplot, read_summary, save
from studies.common.runs import SOURCE, RunError, gearfilm
from studies.paper import films, models, motion, printed
from studies.paper.contact_drawing import draw_contact
from studies.paper.flow_charts import draw_mesh_cycle, draw_solution
from studies.paper.life import compare, find_delays, find_positions, read_life, read_single_contact
from studies.paper.line_drawing import draw_line_of_action
from studies.paper.pair_drawing import draw_pair

TABLE_3, TABLE_2 = SOURCE / "input/barbieri2013.yaml", SOURCE / "input/wang2004.yaml"
# The start from rest: the force on one contact passes 1.33 of the static one, where the ellipse leaves |y| <= 1.1 b.
WIDE = ("-grid_nx", 145, "-grid_ny", 81, "-grid_x_min", -2.25, "-grid_x_max", 1.5, "-grid_y_half", 1.4)
STEP = ("-time_dt", 0.026)


class Run(NamedTuple):
    """One run of gearfilm; its results are in FOLDER/<name>."""
    command: str
    case: pathlib.Path
    options: tuple = ()


def stationary_runs(case, name, alone, among_two):
    """Stationary films at positions [µm] with one pair in contact and with two, under the step load sharing."""
    return {f"{name}/{xi}": Run("steady", case, ("-steady_position", 1e-6 * xi, "-steady_load_ratio", share))
            for positions, share in ((alone, 1), (among_two, 0.5)) for xi in positions}


RUNS = {
    "info": Run("info", TABLE_3),
    "periodic": Run("periodic", TABLE_3, (*STEP, "-output_snapshot_interval", 0.01)),
    "start": Run("transient", TABLE_3, (*WIDE, *STEP, "-mesh_periods", 12)),
    "quasistatic": Run("transient", TABLE_3, (*STEP, "-model", "quasistatic")),
    "table2_info": Run("info", TABLE_2),
    "table2_step": Run("transient", TABLE_2, ("-model", "quasistatic")),
    "table2_trapezoid": Run("transient", TABLE_2, ("-model", "quasistatic", "-load_sharing_kind", "trapezoid")),
    # Outside the length that oil needs to pass after a jump of the load.
    **stationary_runs(TABLE_2, "table2_stationary", (-500, 0, 500, 1000, 1500), (-3000, -2200, 2700, 3500)),
    **stationary_runs(TABLE_3, "table3_stationary", (0, 1000, 2000, 3000), (-4200, -3500, 5700)),
}


class Figure(NamedTuple):
    """One figure: its file name, what draws it, and the begins of the names of the runs that this reads."""
    name: str
    draw: Callable
    runs: tuple


def drawing(name, draw):
    """A drawing of the geometry that `gearfilm info` tells."""
    return Figure(name, lambda folder: draw(read_summary(folder / "info", "info")), ("info",))


FIGURES = {
    1: drawing("pair", draw_pair),
    2: drawing("line_of_action", draw_line_of_action),
    4: drawing("contact", draw_contact),
    5: drawing("mesh_cycle", draw_mesh_cycle),
    6: drawing("solution", draw_solution),
    3: Figure("load_sharing", models.draw_load_sharing, ("table2_step", "table2_trapezoid")),
    7: Figure("comparison_case", models.draw_comparison_case, ("table2",)),
    8: Figure("start", motion.draw_start, ("start",)),
    9: Figure("steady_state", motion.draw_steady_state, ("periodic",)),
    10: Figure("force", motion.draw_force, ("periodic",)),
    11: Figure("pressures", films.draw_pressures, ("periodic",)),
    12: Figure("films", films.draw_films, ("periodic",)),
    13: Figure("maps", films.draw_maps, ("periodic", "info")),
    14: Figure("models", models.draw_contrast, ("periodic", "quasistatic", "table3_stationary", "info")),
}
NUMBERS_FROM = {12, 14}  # the figures whose runs the printed numbers are taken from


def compute(folder, figures):
    """Makes the runs of the figures that have no summary yet."""
    wanted = tuple(begin for figure in figures for begin in figure.runs)
    for name, run in RUNS.items():
        if not name.startswith(wanted) or (folder / name / "summary.json").exists():
            continue
        print(f"paper: gearfilm {run.command}, {name}", flush=True)
        if gearfilm(run.command, run.case, folder / name, *run.options) is None:
            raise RunError(f"the run {name} was not solved")


def find_numbers(folder):
    """Positions, delays and contrast as named numbers, SI."""
    life = read_life(folder / "periodic")
    positions = find_positions(life)
    contrast = compare(life, read_single_contact(folder / "quasistatic"),
                       read_summary(folder / "periodic", "periodic")["static_force"],
                       read_summary(folder / "info", "info")["p_hertz"])
    return {"positions": {name: {"xi": position.xi, "h_central": position.film}
                          for name, position in positions.items()},
            "delays": find_delays(life, positions), "contrast": contrast._asdict()}


def print_numbers(numbers):
    print("\nPositions in the life of a contact")
    for name, position in numbers["positions"].items():
        print(f"  {name}  xi {1e3 * position['xi']:7.3f} mm   central film {1e6 * position['h_central']:.4f} um")
    print("Delays along the line of action                gearfilm     paper")
    papers = (printed.DELAY_D, printed.DELAY_LEAST_PRESSURE, printed.DELAY_GREATEST_PRESSURE, printed.DELAY_F)
    for (name, delay), paper in zip(numbers["delays"].items(), papers):
        print(f"  {name:<41} {1e3 * delay:8.2f} mm {1e3 * paper:6.2f} mm")
    contrast = numbers["contrast"]
    print("Dynamic against quasi-static model")
    print(f"  greatest pressure over Hertz's for the force: {contrast['spike_dynamic']:.2f} dynamic, "
          f"{contrast['spike_quasistatic']:.2f} quasi-static")
    print(f"  least central pressure of the dynamic model at xi = {1e3 * contrast['least_pressure_at']:.2f} mm")
    print(f"  central film, dynamic over quasi-static: {contrast['film_ratio_access']:.3f} in access, "
          f"{contrast['film_ratio_recess']:.3f} in recess")


def make(folder, numbers_wanted):
    """Draws the wanted figures; with those of the paper's positions and models, their numbers too."""
    place = folder / "figures"
    place.mkdir(exist_ok=True)
    for number in numbers_wanted:
        figure = FIGURES[number]
        drawn = figure.draw(folder)
        save(drawn, [place / f"fig{number:02d}_{figure.name}.{ending}" for ending in ("png", "pdf")])
        pyplot.close(drawn)
    if NUMBERS_FROM <= set(numbers_wanted):
        numbers = find_numbers(folder)
        (place / "numbers.json").write_text(json.dumps(numbers, indent=1) + "\n", encoding="utf-8")
        print_numbers(numbers)
