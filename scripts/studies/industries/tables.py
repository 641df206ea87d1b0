"""Markdown tables: pairs, program beside hand formulas, what became of the commands.

A cell has the program's value, a slash, the formula's, and in brackets how far the program is from the formula.
"""
import collections
import math
import re
import textwrap

import h5py
import numpy

from studies.common.histories import periodic_steps
from studies.common.tables import heading, row
from studies.industries import formulas as hand
from studies.industries.cases import FRICTION
from studies.industries.dry_motion import repeated

WORDS = 90                     # letters of a message


def beside(program, formula, unit=1.0, digits=5, places=2):
    """Program / formula (deviation); a dash where the program has nothing."""
    if program is None:
        return "-"
    deviation = round(100 * (program / formula - 1), places) + 0.0
    return f"{program / unit:.{digits}g} / {formula / unit:.{digits}g} ({deviation:+.{places}f} %)"


def value(number, unit=1.0, digits=3):
    return "-" if number is None else f"{number / unit:.{digits}g}"


def barred(found, name, unit=1.0, digits=3):
    """A value and its error bar; values without one stand alone."""
    number, error = found.get(name), found.get(f"{name}_error")
    return value(number, unit, digits) if error is None else f"{value(number, unit, digits)} ± {value(error, unit, 1)}"


def mean(values, T):
    """Over time, by trapezoids."""
    return float(numpy.sum(0.5 * (values[1:] + values[:-1]) * numpy.diff(T)) / (T[-1] - T[0]))


def mean_force(folder):
    """Of the total force over the periodic period [N]."""
    with h5py.File(folder / "results.h5") as results:
        steps = periodic_steps(results)
    return mean(steps["force_total"], steps["T"])


def loss_of_forces(pair, folder):
    """Loss factor of the forces that contacts had in the periodic period: mean of sum w_k |xi_k| by hand."""
    with h5py.File(folder / "results.h5") as results:
        steps, contacts = periodic_steps(results), results["history/contacts"][:]
    moments = numpy.bincount(contacts["step"].astype(int), contacts["force"] * numpy.abs(contacts["xi"]))
    radii = hand.base_radii(pair)
    return (1 / radii[0] + 1 / radii[1]) * mean(moments[steps["step"].astype(int)], steps["T"]) / hand.tooth_force(pair)


def pair_row(pair, _, __):
    x = hand.shifts(pair)
    return (pair.industry, pair.module_mm, f"{pair.teeth[0]}/{pair.teeth[1]}",
            f"{x[0]:.3f}/{round(x[1], 3) + 0.0:.3f}", pair.pressure_angle_deg, pair.axes_mm,
            pair.width_mm, pair.crowning_um, pair.rpm, pair.torque,
            f"{pair.oil}: {1e3 * pair.viscosity:.3g}, {1e9 * pair.pressure_viscosity:.3g}")


def geometry_row(pair, runs, _):
    info = runs["info"].found
    return (beside(info.get("working_pressure_angle_deg"), math.degrees(hand.working_angle(pair))),
            beside(info.get("contact_ratio"), hand.contact_ratio(pair)),
            beside(info.get("load"), hand.tooth_force(pair)), beside(info.get("f_m"), hand.mesh_frequency(pair)),
            beside(info.get("m_ge"), hand.equivalent_mass(pair)))


def contact_row(pair, runs, _):
    info, hertz, fits = runs["info"].found, hand.hertz(pair), hand.brewe_hamrock(pair)
    R_x, R_y = hand.radii(pair)
    return (f"{R_y / R_x:.0f}", beside(info.get("p_hertz"), hertz.pressure, 1e9),
            beside(info.get("p_hertz"), fits[0], 1e9, 4, 1), beside(info.get("hertz_approach"), hertz.approach, 1e-6),
            beside(info.get("hertz_approach"), fits[1], 1e-6, 4, 1),
            f"{2 * info['b'] / pair.width:.2f}" if info else "-",
            beside(info.get("f_n"), hand.natural_frequency(pair)))


def teeth_row(pair, runs, _):
    rigid, bending = runs["static"].found, runs["bending"].found
    single, factor = hand.iso_single(pair)
    mesh = single * factor * (0.75 * hand.contact_ratio(pair) + 0.25)
    error, swing = hand.static_error(pair)
    return (beside(rigid.get("te_mean"), error, 1e-6, 4), beside(rigid.get("te_peak_to_peak"), swing, 1e-6, 4),
            beside(rigid.get("iso_stiffness_single"), single, 1e6, 4), f"{factor:.3f}",
            beside(bending.get("mesh_stiffness_pitch"), single * factor, 1e6, 4, 0),
            beside(bending.get("mesh_stiffness_mean"), mesh, 1e6, 4, 0),
            value(bending.get("te_peak_to_peak"), 1e-6), value(bending.get("entry_penetration"), 1e-6))


def film_row(pair, runs, _):
    info, film = runs["info"].found, runs["steady"].found
    thick, other = hand.hamrock_dowson(pair), hand.nijenbanning(pair)
    limit = film.get("h_central_extrapolated")
    return (beside(info.get("hamrock_dowson_h_central"), thick, 1e-6, 4),
            beside(info.get("nijenbanning_venner_moes_h_central"), other, 1e-6, 4),
            barred(film, "h_central", 1e-6), barred(film, "h_min", 1e-6), value(limit, 1e-6),
            *(f"{100 * (limit / formula - 1):+.1f} %" if limit else "-" for formula in (thick, other)))


def motion_row(pair, runs, folder):
    modes, orbit = runs["eigen"].found, runs["periodic"].found
    force = hand.tooth_force(pair)
    swing = f"{hand.natural_frequency(pair) / hand.mesh_frequency(pair):.1f}"
    modes = (beside(modes.get("f_n"), hand.natural_frequency(pair)), barred(modes, "film_frequency", 1, 5),
             barred(modes, "film_damping_ratio", 0.01, 2))
    if not orbit:
        return (swing, *modes, *6 * ["-"])
    loss = orbit["power_sliding"] / (FRICTION * pair.torque * pair.rpm * math.pi / 30)
    return (swing, *modes, beside(mean_force(folder / pair.name / "periodic"), force),
            barred(orbit, "force_ratio_max"), barred(orbit, "h_min", 1e-6), "yes" if orbit["stable"] else "no",
            beside(orbit["loss_factor"], hand.ohlendorf(pair), 1, 4),
            beside(loss, loss_of_forces(pair, folder / pair.name / "periodic"), 1, 4))


def middle(found):
    """Of a sweep's points that at the pair's own speed, on the way up."""
    points = sorted((point for point in found.get("points", []) if point["direction"] == "up"),
                    key=lambda point: point["value"])
    return points[1] if len(points) == 3 else {}


def branch_cells(pair, runs, folder):
    """The largest force where a continuation begins, and what it found."""
    branch = runs["continuation"].found
    if not branch:
        return "-", "-"
    with h5py.File(folder / pair.name / "continuation/results.h5") as results:
        begun = float(results["continuation"][0]["force_ratio_max"])
    kinds = collections.Counter(point["kind"] for point in branch["bifurcations"])
    found = ", ".join(f"{number} {kind}" for kind, number in sorted(kinds.items()))
    return value(begun, 1, 4), f"{branch['points']} points, {found or 'nothing'}"


def speed_row(pair, runs, folder):
    dry, orbit = runs["dry"].found, runs["periodic"].found
    if not dry:
        return 9 * ["-"]
    change, largest = repeated(pair, dry["H0_after_leaving"], dry["V0_after_leaving"])
    return (beside(mean_force(folder / pair.name / "dry"), hand.tooth_force(pair)), f"{change:.0e}",
            beside(dry["force_ratio_max"], largest, 1, 4), "yes" if dry["stable"] else "no",
            value(middle(runs["dry sweep"].found).get("force_ratio_max"), 1, 4), *branch_cells(pair, runs, folder),
            value(orbit.get("force_ratio_max"), 1, 4), value(middle(runs["sweep"].found).get("force_ratio_max"), 1, 4))


TABLES = (
    ("The pairs", {"info"}, pair_row,
     ("industry", "m [mm]", "z", "x", "α [deg]", "a_w [mm]", "b [mm]", "crowning [µm]", "rpm", "T [N m]",
      "oil: η [mPa s], α_B [1/GPa]")),
    ("Geometry, program / hand", {"info"}, geometry_row,
     ("α_w [deg]", "ε", "tooth force [N]", "f_m [Hz]", "m_ge [kg]")),
    ("Hertz contact, program / hand", {"info"}, contact_row,
     ("R_y/R_x", "p_h [GPa]", "p_h, Brewe and Hamrock", "approach [µm]", "approach, Brewe and Hamrock", "ellipse/face",
      "f_n [Hz]")),
    ("Teeth, program / hand", {"static", "bending"}, teeth_row,
     ("rigid: mean TE [µm]", "rigid: TE peak to peak [µm]", "c' b of ISO [N/µm]", "C_B, light load",
      "bending, at the pitch point / ISO c' b with these", "bending, mean / c_γ b", "TE peak to peak, bending [µm]",
      "entry meets [µm]")),
    ("Films", {"info", "steady"}, film_row,
     ("Hamrock and Dowson, program / hand [µm]", "Nijenbanning and others, program / hand [µm]", "central film [µm]",
      "smallest film [µm]", "central, extrapolated", "over Hamrock and Dowson", "over Nijenbanning and others")),
    ("Motion on films", {"eigen", "periodic"}, motion_row,
     ("f_n/f_m", "f_n of `eigen`, program / hand [Hz]", "on films [Hz]", "damping [%]", "mean force / static [N]",
      "largest force/static", "smallest film [µm]", "stable", "loss factor of Ohlendorf",
      "of the forces in motion")),
    ("Dry pair and speeds", {"dry", "dry sweep", "continuation", "periodic", "sweep"}, speed_row,
     ("dry: mean force / static [N]", "repeats by hand within", "largest force/static, program / hand", "stable",
      "largest of `sweep` there", "where `continuation` begins",
      "it finds", "on films: largest force/static", "of `sweep` there")),
)


def word(run):
    """What became of a run."""
    if run.status == 0:
        return "warns" if run.errors else "ok"
    return {None: "-", 2: "not solved", 3: "time"}.get(run.status, f"status {run.status}")


def command_row(runs):
    return [word(run) for run in runs.values()]


def message(line):
    """First words of a line without its numbers, by which lines are alike."""
    words = re.sub(r"-?\d[\d.e+-]*", "n", line.removeprefix("gearfilm: "))
    return textwrap.shorten(words, WORDS, placeholder=" ...")


def say_messages(chosen, say):
    """Every kind of message, by command, with the pairs that have it."""
    found = collections.defaultdict(list)
    for pair, runs in chosen.items():
        for name, run in runs.items():
            for kind in dict.fromkeys(map(message, run.errors.strip().splitlines())):
                found[name, kind].append(pair.name)
    for (name, kind), pairs in found.items():
        say(f"- `{name}`, {'all' if len(pairs) == len(chosen) > 1 else ', '.join(pairs)}: {kind}")


def say_all(chosen, folder, say):
    """The tables whose runs there are."""
    names = list(next(iter(chosen.values())))
    for title, needed, cells, columns in TABLES:
        if needed <= set(names):
            say(f"\n**{title}**\n\n{heading('pair', *columns)}")
            for pair, runs in chosen.items():
                say(row(pair.name, *cells(pair, runs, folder)))
    say(f"\n**Commands**\n\n{heading('pair', *names)}")
    for pair, runs in chosen.items():
        say(row(pair.name, *command_row(runs)))
    say("")
    say_messages(chosen, say)
