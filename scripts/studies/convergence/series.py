"""The studies: what is refined or widened, in which runs, and which quantities are compared."""
from typing import NamedTuple

from studies.common.contacts import RATIOS, SHORT_DOMAIN, case_text, finer, grid_of, grid_options
from studies.common.runs import SOURCE

TABLE_3, TABLE_2 = (SOURCE / "input" / name for name in ("barbieri2013.yaml", "wang2004.yaml"))
CONTACTS = ((20, 10, 1), (200, 10, 0.3), (200, 27, 1), (20, 5, 0.06))  # M, L, D
DOMAIN_GROUPS = ((200, 5), (200, 10), (200, 27), (800, 10), (2400, 10), (2400, 27))  # M, L
COARSEST = 33               # nodes in x of a bare contact
COARSEST_PAIR = (65, 33)    # of a pair of gears; 33 x 17 nodes lose most of its smallest film
COARSEST_TABLE_2 = (65, 65)
DOMAIN_NODES, REDUCED_DOMAIN_NODES = 129, 65  # in x, on the short domain
LONGER = 0.75               # of the length of the domain, added at the inlet
WIDER = 2                   # of the width, for stationary films
WIDER_ORBIT = 1.375         # for periodic states: 1.5125 b, a whole number of steps
ORBIT_STEP = 0.052          # dT on the coarsest grid, close to its h_x
MARCH_STEP = 0.1            # dT
MARCH_START = (-1.4853, 0.5921)  # H_0, V_0 after leaving: about the periodic state
# Below a hundredth of what the steps change.
DISCRETISATION = ("-film_discretisation", "central")  # the paper's, of second order: limits are extrapolated with it
ORBIT_TOLERANCES = ("-periodic_tolerance", 1e-6, "-periodic_film_tolerance", 1e-4, "-time_newton_tolerance", 1e-7)
MARCH_TOLERANCES = ("-time_newton_tolerance", 1e-8)


class Size(NamedTuple):
    """How much of a study is computed."""
    reduced: bool
    finest: bool


class Quantity(NamedTuple):
    """A number of a summary, and how it is printed."""
    key: str
    label: str
    panel: str           # of the figure, shared with others
    unit: str = ""
    scale: float = 1.0   # from the summary's SI value to the unit
    digits: int = 5      # after the decimal point

    def heading(self):
        return f"{self.label} [{self.unit}]" if self.unit else self.label


class Run(NamedTuple):
    """One run; `name` is that of its folder, so that studies share the runs they have in common."""
    label: str
    name: str
    step: float
    options: tuple


class Series(NamedTuple):
    """Runs of one case, refined from one to the next, or on different domains with the same step."""
    name: str
    title: str
    command: str
    case: str            # text of the case file
    step: str            # what the runs' steps are
    runs: list
    quantities: list


class Study(NamedTuple):
    title: str
    series: list
    refined: bool = True  # else the domain varies


MICROMETRES = {"unit": "µm", "scale": 1e6, "digits": 4}
BARE_FILM = [Quantity("H_central", "H_central", "film"), Quantity("H_min", "H_min", "film")]
FILM = [Quantity("h_central", "central film", "film", **MICROMETRES),
        Quantity("h_min", "smallest film", "film", **MICROMETRES)]
FORCES = [Quantity("force_ratio_max", "largest force of one contact / static force", "force"),
          Quantity("p_max", "largest pressure", "force", "GPa", 1e-9, 4)]
ORBIT = [*FORCES,
         Quantity("pitch_h_central", "central film at the pitch point", "film", **MICROMETRES),
         Quantity("pitch_h_min", "smallest film at the pitch point", "film", **MICROMETRES),
         Quantity("entry_h_central", "central film after entering", "film", **MICROMETRES),
         Quantity("entry_h_min", "smallest film after entering", "film", **MICROMETRES),
         Quantity("transmission_error_peak_to_peak", "transmission error, peak to peak", "motion", "µm", 1e6, 3),
         Quantity("H0_after_leaving", "$H_0$ after leaving", "motion"),
         Quantity("V0_after_leaving", "$V_0$ after leaving", "motion"),
         Quantity("free_frequency", "free oscillation", "motion", "Hz", digits=1),
         Quantity("floquet_modulus", "Floquet modulus", "motion")]
MARCH = [*FORCES,
         Quantity("h_min", "smallest film", "force", **MICROMETRES),
         Quantity("H0", "H_0 at the leaving", "motion"),
         Quantity("V0", "V_0 at the leaving", "motion")]


def halved_grids(coarsest, count):
    grids = [coarsest]
    while len(grids) < count:
        grids.append(finer(grids[-1]))
    return grids


def grid_label(grid):
    return f"{grid[0]} x {grid[1]}"


def grid_run(name, grid, label="", dT=None, options=()):
    """A run on a grid; its step is dT where it marches in time, else 1/(nodes in x - 1)."""
    size = f"{name}_{grid[0]}x{grid[1]}"
    if dT is None:
        return Run(label or grid_label(grid), size, 1 / (grid[0] - 1), (*grid_options(grid), *DISCRETISATION, *options))
    return Run(label or f"{grid_label(grid)}, dT = {dT:g}", f"{size}_dT{dT:g}", dT,
               (*grid_options(grid), *DISCRETISATION, "-time_dt", dT, *options))


def longer(grid):
    return grid[0] + round(LONGER * (grid[0] - 1)), grid[1]


def wider(grid, factor=WIDER):
    return grid[0], 1 + round(factor * (grid[1] - 1))


def long_inlet():
    x_min, x_max, _ = SHORT_DOMAIN
    return "-grid_x_min", round(x_min - LONGER * (x_max - x_min), 6)


def wide(factor=WIDER):
    return "-grid_y_half", round(factor * SHORT_DOMAIN[2], 6)


def film_series(name, title, case, grids, quantities, options=()):
    return Series(name, title, "steady", case, "step, as part of the domain's length",
                  [grid_run(name, grid, options=options) for grid in grids], quantities)


def contact_name(M, L, D):
    return f"M{M}_L{L}_D{D}"


def contact_title(M, L, D):
    return f"M = {M}, L = {L}, D = {D}"


def steady_study(size):
    title = "Stationary films, grid halved"
    table_3, pair_grids = TABLE_3.read_text(encoding="utf-8"), halved_grids(COARSEST_PAIR, 3 if size.reduced else 5)
    contacts = [film_series(contact_name(*groups), contact_title(*groups), case_text(*groups),
                            halved_grids(grid_of(groups[2], COARSEST), 3 if size.reduced else 4), BARE_FILM)
                for groups in (CONTACTS[:1] if size.reduced else CONTACTS)]
    pitch = film_series("pitch", "Table 3 pitch, the paper's domain", table_3, pair_grids, FILM)
    if size.reduced:
        return Study(title, [*contacts, pitch])
    long_grids = [longer(grid) for grid in pair_grids[:-1]]
    return Study(title, [
        *contacts, pitch,
        film_series("pitch_long", "Table 3 pitch, long inlet", table_3, long_grids, FILM, long_inlet()),
        film_series("pitch_wide", "Table 3 pitch, long inlet and twice as wide", table_3,
                    [wider(grid) for grid in long_grids], FILM, (*long_inlet(), *wide())),
        film_series("table2_pitch", "Table 2 pitch", TABLE_2.read_text(encoding="utf-8"),
                    halved_grids(COARSEST_TABLE_2, 4), FILM)])


def orbit_series(name, title, step, runs):
    return Series(name, title, "periodic", TABLE_3.read_text(encoding="utf-8"), step, runs, ORBIT)


def orbit_run(grid, dT, name="periodic", label="", options=()):
    return grid_run(name, grid, label, dT, (*options, *ORBIT_TOLERANCES))


def grid_study(size):
    grids = halved_grids(COARSEST_PAIR, 4 if size.finest else 3)
    runs = [orbit_run(grid, ORBIT_STEP / 2 ** n) for n, grid in enumerate(grids)]
    return Study("Periodic state of Table 3, grid and time step halved together",
                 [orbit_series("periodic", "Periodic state, the paper's domain", "dT, the grid refined with it", runs),
                  orbit_series("periodic_half_step", "The step alone halved", "dT",
                               [orbit_run(grids[1], ORBIT_STEP / 4)])])


def time_study(size):
    H0, V0 = MARCH_START
    start = ("-start_place", "after_leaving", "-start_H0", H0, "-start_V0", V0, "-mesh_periods", 1)
    march = Series(
        "march", f"One mesh period from H_0 = {H0}, V_0 = {V0}, {grid_label(COARSEST_PAIR)} nodes", "transient",
        TABLE_3.read_text(encoding="utf-8"), "dT",
        [grid_run("march", COARSEST_PAIR, f"dT = {dT:g}", dT, (*start, *MARCH_TOLERANCES))
         for dT in (MARCH_STEP / 2 ** n for n in range(3 if size.reduced else 4))], MARCH)
    if size.reduced:
        return Study("Time step halved", [march])
    grid = finer(COARSEST_PAIR)
    runs = [orbit_run(grid, dT, label=f"dT = {dT:g}") for dT in (ORBIT_STEP / 2 ** n for n in range(3))]
    return Study("Time step halved", [
        orbit_series("periodic", f"Periodic state, {grid_label(grid)} nodes", "dT", runs), march])


def film_domains(name, title, case, grid):
    """Stationary film on the short domain, with the long inlet, and also twice as wide: steps unchanged."""
    long = longer(grid)
    return film_series(name, title, case, [], BARE_FILM)._replace(runs=[
        grid_run(name, grid, "short domain"),
        grid_run(f"{name}_long", long, "long inlet", options=long_inlet()),
        grid_run(f"{name}_wide", wider(long), "and wide", options=(*long_inlet(), *wide()))])


def domain_study(size):
    title = "The paper's domain for M >= 200 against longer and wider ones, same steps"
    nodes = REDUCED_DOMAIN_NODES if size.reduced else DOMAIN_NODES
    groups = [(200, 27, 0.3)] if size.reduced else [(M, L, D) for D in RATIOS for M, L in DOMAIN_GROUPS]
    films = [film_domains(contact_name(*three), contact_title(*three), case_text(*three), grid_of(three[2], nodes))
             for three in groups]
    if size.reduced:
        return Study(title, films, refined=False)
    grid, dT = finer(COARSEST_PAIR), ORBIT_STEP / 2
    orbit = orbit_series("periodic", "Periodic state of Table 3", "", [
        orbit_run(grid, dT, label="short domain"),
        orbit_run(wider(grid, WIDER_ORBIT), dT, "periodic_wide", f"half width {wide(WIDER_ORBIT)[1]:g} b",
                  wide(WIDER_ORBIT)),
        orbit_run(longer(grid), dT, "periodic_long", "long inlet", long_inlet())])
    pitch = film_domains("pitch", "Table 3 pitch", TABLE_3.read_text(encoding="utf-8"), grid)
    return Study(title, [pitch, *films, orbit], refined=False)


STUDIES = {"steady": steady_study, "grid": grid_study, "time": time_study, "domain": domain_study}
REDUCED_STUDIES = ("steady", "time", "domain")
