"""The table of the paper's printed numbers beside those on its grid and their limits, from the study convergence."""
import json
from typing import NamedTuple

from studies.common.plotting import PlotError, read_summary
from studies.common.tables import heading, percent, row, with_bar
from studies.paper import printed

MICROMETRE, GIGAPASCAL, MILLIMETRE = 1e-6, 1e-9, 1e-3
COLUMNS = ("quantity", "paper", "gearfilm on the paper's grid", "converged", "reason of the difference")
THE_SAME = "the same"
FILM_REASON = "none on its grid; that is {low} low"
SPECTRUM_REASON = ("the paper's lines are read off a transient; its mesh frequency comes out as 7007. The kept march has "
                   "5180, lines 70 Hz apart")


class Limits(NamedTuple):
    """What the study convergence has found: its file convergence.json."""
    studies: dict

    def quantity(self, study, series, name):
        try:
            return self.studies[study][series]["quantities"][name]
        except KeyError:
            raise PlotError(f"the study convergence has no {study}: {series}; make its studies steady, grid and domain"
                            ) from None

    def text(self, study, series, name):
        """The limit with its bar; the value of the finest run where none is in sight."""
        found = self.quantity(study, series, name)
        if found["order"] is not None and found["order"] > 0 and found["bar"]:
            return with_bar(found["limit"], found["bar"])
        finest = self.studies[study][series]["runs"][-1]["label"].partition(",")[0]
        return f"{found['values'][-1]:.4g} on {finest}, no limit in sight"

    def film(self, series, name, wide):
        """The limit on the paper's domain and on one with a long inlet, twice as wide."""
        short, long = (self.quantity("steady", one, name)["limit"] for one in (series, wide))
        return f"{self.text('steady', series, name)} ({percent(long / short - 1)}: {self.text('steady', wide, name)})"

    def periodic(self, name):
        """The limit, and where films are meant what a long inlet changes."""
        text = self.text("grid", "periodic", name)
        if "_h_" not in name:
            return text
        return f"{text} ({percent(self.quantity('domain', 'periodic', name)['changes'][-1])})"


def read_limits(folder):
    path = folder / "convergence.json"
    try:
        return Limits(json.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError):
        raise PlotError(f"{path} cannot be read; run scripts/studies/convergence/run {folder} first") from None


def low(value, limit):
    """How far below its limit."""
    return f"{100 * (1 - value / limit):.1f} %"


def film_rows(folder, limits):
    """Stationary films, then the periodic state."""
    film = read_summary(folder / "table3_stationary/0", "steady")
    for title, name, paper in (("central", "h_central", printed.STEADY_CENTRAL),
                               ("smallest", "h_min", printed.STEADY_SMALLEST)):
        value = film[name] / MICROMETRE
        yield (f"stationary film, {title} [µm]", f"{paper / MICROMETRE:.3f}", f"{value:.4f}",
               limits.film("pitch", name, "pitch_wide"),
               FILM_REASON.format(low=low(value, limits.quantity("steady", "pitch", name)["limit"])))
    state = read_summary(folder / "periodic", "periodic")
    yield ("largest force of one contact / static force", printed.FORCE_RATIO, f"{state['force_ratio_max']:.4f}",
           limits.periodic("force_ratio_max"), "none")
    yield ("largest pressure [GPa]", f"{printed.LARGEST_PRESSURE * GIGAPASCAL:.2f}",
           f"{state['p_max'] * GIGAPASCAL:.3f}", limits.periodic("p_max"),
           f"{100 * (state['p_max'] / printed.LARGEST_PRESSURE - 1):.1f} %; the crest of the ripple at B is three nodes "
           "wide")
    for title, name, paper, digits, reason in (
            ("periodic film at the pitch point, central [µm]", "pitch_h_central", printed.PITCH_CENTRAL, 3, FILM_REASON),
            ("periodic film at the pitch point, smallest [µm]", "pitch_h_min", printed.PITCH_SMALLEST, 3,
             "{off}, one node's film"),
            ("film after entering, central [µm]", "entry_h_central", printed.ENTRY_CENTRAL, 1, "none on its grid"),
            ("film after entering, smallest [µm]", "entry_h_min", printed.ENTRY_SMALLEST, 1,
             "printed with two digits")):
        value = state[name] / MICROMETRE
        yield (title, f"{paper / MICROMETRE:.{digits}f}", f"{value:.4f}", limits.periodic(name),
               reason.format(low=low(value, limits.quantity("grid", "periodic", name)["limit"]),
                             off=f"{abs(100 * (state[name] / paper - 1)):.1f} %"))


def spectrum_rows(folder, limits):
    mesh, free, mirror = printed.SPECTRUM
    state = read_summary(folder / "periodic", "periodic")
    exact = read_summary(folder / "info", "info")["f_m"]
    finest = limits.quantity("grid", "periodic", "free_frequency")["values"][-1]
    grid = limits.studies["grid"]["periodic"]["runs"][-1]["label"].partition(",")[0]
    yield ("spectrum: free oscillation [Hz]", f"{free:.0f}", f"{state['free_frequency']:.0f}", f"{finest:.0f} on {grid}",
           SPECTRUM_REASON)
    yield ("spectrum: its mirror [Hz]", f"{mirror:.0f}", f"{exact - state['free_frequency']:.0f}",
           f"{exact - finest:.0f} on {grid}", f"{THE_SAME}: f_m less the free oscillation")
    yield "spectrum: mesh frequency [Hz]", f"{mesh:.0f}", f"{exact:.0f}", "exact", THE_SAME


def start_rows(folder):
    loss = read_summary(folder / "start", "transient")["contact_losses"][0]
    film = read_summary(folder / "table3_stationary/0", "steady")["h_central"]
    yield ("from rest: contact first lost after [mm]", f"{printed.FIRST_LOSS / MILLIMETRE:.2f}",
           f"{loss['distance'] / MILLIMETRE:.2f}", "",
           "0.2 mm are seven time steps; the paper's criterion of loss is not printed")
    yield ("from rest: film in that loss / stationary film", f"about {printed.FILM_IN_LOSS}",
           f"{loss['largest_h_central'] / film:.1f}", "",
           "the paper does not say where; the film at the edge is thicker than the central one")


def comparison_rows(folder, limits):
    """Of Table 2."""
    own = f"{read_summary(folder / 'table2_stationary/0', 'steady')['h_central'] / MICROMETRE:.4f}"
    found = limits.quantity("steady", "table2_pitch", "h_central")["limit"] * MICROMETRE
    limit = limits.text("steady", "table2_pitch", "h_central")
    yield ("Table 2, central film by its solver [µm]", f"{printed.TABLE_2_SOLVER / MICROMETRE:.3f}", own, limit,
           "oil inferred from the formula's value; the paper's grid is coarser (its solver is "
           f"{low(printed.TABLE_2_SOLVER, printed.TABLE_2_FORMULA)} below the formula, as in Table 3)")
    yield ("Table 2, central film by formula [µm]", f"{printed.TABLE_2_FORMULA / MICROMETRE:.3f}", own, limit,
           f"{abs(100 * (found / printed.TABLE_2_FORMULA - 1)):.1f} %")


def pair_rows(info):
    groups = f"{info['M']:.2f}, {info['L']:.2f}, {info['D']:.4f}, {info['I_n']:.2f}"
    yield ("M, L, D, I_n", f"{printed.M}, {printed.L}, {printed.D}, {printed.I_N}", groups, "exact",
           "face width, mass and oil are inferred from them")
    yield ("f_n [Hz]", f"{printed.NATURAL_FREQUENCY:.0f}", f"{info['f_n']:.1f}", "exact",
           "mass from I_n, which is printed with four digits")
    yield "f_m [Hz]", f"{printed.MESH_FREQUENCY:.0f}", f"{info['f_m']:.0f}", "exact", ""


def table_lines(folder, limits):
    info = read_summary(folder / "info", "info")
    entering, leaving = info["xi_entry"] + info["base_pitch"], info["xi_exit"]
    places = ("the next contact enters, a contact leaves [mm]",
              f"{printed.ENTERING_OF_NEXT / MILLIMETRE:g}, {printed.LEAVING / MILLIMETRE:g}",
              f"{entering / MILLIMETRE:.3f}, {leaving / MILLIMETRE:.3f}", "exact",
              "geometry of Table 3; the paper rounds, or has other tip radii")
    yield heading(*COLUMNS)
    for cells in (*pair_rows(info), *film_rows(folder, limits), *spectrum_rows(folder, limits), *start_rows(folder),
                  places, *comparison_rows(folder, limits)):
        yield row(*cells)
