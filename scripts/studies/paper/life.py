"""The life of a contact in the periodic state, its positions A to F, and how it differs from a quasi-static one.

Numbers only; positions are found in the history, none is typed in. Lengths in m along the line of action, zero at the
pitch point.
"""
from typing import NamedTuple

from studies.common.plotting import Foreign, PlotError, numpy, open_results, read_table

STEP_COLUMNS = ["step", "T"]
CONTACT_COLUMNS = ["step", "contact", "T", "xi", "force", "p_max", "p_central", "h_central", "h_min"]
SAME_PLACE = 1e-9  # m


class Life(NamedTuple):
    """One contact from entering to leaving: a row a position, in growing xi, and where the others came and went."""
    rows: numpy.ndarray   # of /history/contacts
    other_left: float     # xi of this contact when its elder leaves
    other_entered: float  # xi of this contact when the next one enters


class Position(NamedTuple):
    """A place in the life of a contact and the central film there."""
    xi: float
    film: float


def read_life(folder):
    """The life of a contact of the periodic state in FOLDER/results.h5.

    In one mesh period, which begins when a contact has left, the younger contact lives the begin of that life and the
    elder the rest.
    """
    path = folder / "results.h5"
    with open_results(path, "periodic", "it has no history") as results:
        steps = read_table(results, "history/steps", STEP_COLUMNS)
        contacts = read_table(results, "history/contacts", CONTACT_COLUMNS)
        ends = dict(results["history"].attrs)
    if "periodic_from" not in ends:
        raise PlotError(f"{path} is no periodic state that was found")
    tolerance = 1e-6 * (ends["periodic_to"] - ends["periodic_from"])
    within = (steps["T"] > ends["periodic_from"] + tolerance) & (steps["T"] < ends["periodic_to"] + tolerance)
    rows = contacts[numpy.isin(contacts["step"], steps["step"][within])]
    names = numpy.unique(rows["contact"])
    # The last rows are those after the leaving: of the contact that stays, which the elder's first steps follow.
    if names.size != 2:
        raise PlotError(f"{path} has {names.size} contacts in a mesh period; drawn is the life among two")
    elder, younger = (rows[rows["contact"] == name] for name in names)
    return Life(one_row_a_position(numpy.concatenate([younger, elder])), other_left=younger["xi"].max(),
                other_entered=elder["xi"][elder["T"] <= younger["T"].min()].max())


def one_row_a_position(rows):
    """Rows in growing xi; of several at one position, at an event, the last."""
    rows = rows[numpy.lexsort((rows["step"], rows["xi"]))]
    return rows[numpy.append(numpy.diff(rows["xi"]) > SAME_PLACE, True)]


def read_single_contact(folder):
    """Rows of the contact of a model of one contact, from entry to exit."""
    with open_results(folder / "results.h5", "transient", "it has no history") as results:
        contacts = read_table(results, "history/contacts", CONTACT_COLUMNS)
        if numpy.unique(contacts["contact"]).size != 1:
            raise Foreign("it has more than one contact; run it with -model quasistatic")
    return contacts


def vertex(x, y, middle):
    """Where the parabola through three points about `middle` has its extremum, and its value; at an end that point."""
    if not 0 < middle < len(x) - 1:
        return float(x[middle]), float(y[middle])
    near = slice(middle - 1, middle + 2)
    second, first, value = numpy.polyfit(x[near] - x[middle], y[near], 2)
    if second == 0:
        return float(x[middle]), float(y[middle])
    shift = -first / (2 * second)
    return float(x[middle] + shift), float(value + 0.5 * first * shift)


def extremum(rows, column, choose, begin, end):
    """Position and value of the least or greatest (choose: numpy.argmin, numpy.argmax) between two positions."""
    inside = numpy.flatnonzero((rows["xi"] >= begin) & (rows["xi"] <= end))
    if inside.size == 0:
        raise PlotError(f"the history has no step between {1e3 * begin:.3f} and {1e3 * end:.3f} mm")
    return vertex(rows["xi"], rows[column], inside[0] + choose(rows[column][inside]))


def find_positions(life):
    """The paper's positions A to F, by the central film over the life of a contact.

    A: it has just entered. E: the greatest central film. D: the least between the elder's leaving and E. C: the
    greatest before D. B: the least between A and C, where a ripple of small film passes the middle. F: it leaves.
    """
    rows = life.rows
    first, last = (Position(float(row["xi"]), float(row["h_central"])) for row in (rows[0], rows[-1]))
    E = Position(*extremum(rows, "h_central", numpy.argmax, life.other_left, last.xi))
    D = Position(*extremum(rows, "h_central", numpy.argmin, life.other_left, E.xi))
    C = Position(*extremum(rows, "h_central", numpy.argmax, first.xi, D.xi))
    B = Position(*extremum(rows, "h_central", numpy.argmin, first.xi, C.xi))
    return {"A": first, "B": B, "C": C, "D": D, "E": E, "F": last}


def find_delays(life, positions):
    """Lengths along the line of action for which the paper prints a value, in the order of printed.py."""
    D, E, F = (positions[name].xi for name in "DEF")
    least, _ = extremum(life.rows, "p_central", numpy.argmin, D, E)
    greatest, _ = extremum(life.rows, "p_max", numpy.argmax, E, F)
    return {"D after the other contact left": D - life.other_left,
            "least central pressure after D": least - D,
            "greatest pressure after E": greatest - E,
            "F after the other contact entered": F - life.other_entered}


class Contrast(NamedTuple):
    """The dynamic model against the quasi-static one along the line of action."""
    spike_quasistatic: float  # greatest pressure, over Hertz's under the same force at the pitch point
    spike_dynamic: float
    least_pressure_at: float  # m, of the dynamic central pressure while one contact carries
    film_ratio_access: float  # dynamic over quasi-static central film, mean over xi < 0
    film_ratio_recess: float  # over xi > 0


def spike(rows, static_force, hertz_pressure):
    """p_max/(p_h (F/F*)^(1/3)), greatest over the rows."""
    return float((rows["p_max"] / (hertz_pressure * numpy.cbrt(rows["force"] / static_force))).max())


def compare(life, quasistatic, static_force, hertz_pressure):
    """Contrast of the periodic state and the rows of the quasi-static model."""
    dynamic, others = life.rows, one_row_a_position(quasistatic)
    ratio = dynamic["h_central"] / numpy.interp(dynamic["xi"], others["xi"], others["h_central"])
    least, _ = extremum(dynamic, "p_central", numpy.argmin, life.other_left, life.other_entered)
    return Contrast(spike(quasistatic, static_force, hertz_pressure), spike(dynamic, static_force, hertz_pressure),
                    least, float(ratio[dynamic["xi"] < 0].mean()), float(ratio[dynamic["xi"] > 0].mean()))


class Fields(NamedTuple):
    """Stored fields of a contact in growing xi [m]: pressures [Pa] and films [m] as (position, x, y)."""
    xi: numpy.ndarray
    x: numpy.ndarray
    y: numpy.ndarray
    pressures: numpy.ndarray
    films: numpy.ndarray

    def nearest(self, xi):
        """Number of the fields nearest to a position."""
        return int(abs(self.xi - xi).argmin())


def read_fields(folder):
    path = folder / "results.h5"
    with open_results(path, "periodic", "it has no snapshots; set output.snapshot_interval") as results:
        contacts = sorted((contact for snapshot in results["snapshots"].values() for contact in snapshot.values()),
                          key=lambda contact: contact.attrs["xi"])
        if not contacts:
            raise Foreign("it has no snapshots; set output.snapshot_interval")
        return Fields(numpy.array([contact.attrs["xi"] for contact in contacts]), results["mesh/x"][:],
                      results["mesh/y"][:], numpy.array([contact["P"][:] for contact in contacts]),
                      numpy.array([contact["H"][:] for contact in contacts]))
