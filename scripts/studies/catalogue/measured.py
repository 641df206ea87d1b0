"""One line of a table for each pair of the catalogue and command: what it took, its films and their errors."""
from studies.common.runs import attempt, domain_options
from studies.common.tables import percent

PAIR = ("pair", "M", "L", "D", "p_h [GPa]")
STEADY = ("status", "s", "grid", "h_central [um]", "h_min [um]", "extrapolated", "error", "twice as fine", "s",
          "deviation", "inside", "message")
PERIODIC = ("status", "s", "mesh periods", "Newton iterations a step", "message")
GRID_TOTALS = ("steps", "newton_iterations")


def micrometres(length):
    return "" if length is None else f"{1e6 * length:.5g}"


def pair_cells(number, derived):
    return (number, f"{derived['M']:.0f}", f"{derived['L']:.1f}", f"{derived['D']:.2g}",
            f"{1e-9 * derived['p_hertz']:.2f}")


def steady_cells(case, folder, time_limit):
    """Cells of a table line, and what became of the run in a word."""
    run = attempt("steady", case, folder, time_limit=time_limit)
    if run.status != 0:
        return (run.status, f"{run.seconds:.1f}", *9 * [""], run.message), f"status {run.status}"
    film = run.summary
    nodes = 2 * film["nx"] - 1, 2 * film["ny"] - 1
    finer = attempt("steady", case, folder / "finer", "-grid_nx", nodes[0], "-grid_ny", nodes[1],
                    *domain_options(folder), time_limit=time_limit)
    error, deviation, inside, fine = film.get("h_central_error"), "", "", None
    if finer.status == 0:
        fine = finer.summary["h_central"]
        deviation = percent(fine / film["h_central"] - 1, 2)
        if error is not None:
            inside = "yes" if abs(fine - film["h_central"]) <= error else "no"
    word = {"yes": "inside", "no": "outside"}.get(inside, "no error given" if fine else "finer grid not solved")
    return (run.status, f"{run.seconds:.1f}", f"{film['nx']} x {film['ny']}", micrometres(film["h_central"]),
            micrometres(film["h_min"]), micrometres(film.get("h_central_extrapolated")), micrometres(error),
            micrometres(fine), f"{finer.seconds:.1f}", deviation, inside, finer.message), word


def periodic_cells(case, folder, time_limit):
    """Cells of a table line, and what became of the run in a word."""
    run = attempt("periodic", case, folder, time_limit=time_limit)
    summary = run.summary if run.status in (0, 2, 3) and run.summary else {}
    # Where no periodic state was found, the summary is that of the periods marched.
    periods = summary.get("periods", [summary] if summary else [])
    steps, iterations = (sum(period.get(name, 0) for period in periods) for name in GRID_TOTALS)
    cells = (run.status, f"{run.seconds:.1f}", summary.get("periods_used", len(periods) or ""),
             f"{iterations / steps:.1f}" if steps else "", "" if run.status == 0 else run.message)
    return cells, f"status {run.status}"


COMMANDS = {"steady": (STEADY, steady_cells), "periodic": (PERIODIC, periodic_cells)}
