"""Figures 8 to 10: the motion from rest, the periodic state beside the long march, and the force on a contact."""
from gearfilm.drawing.march import draw_teeth, read_march
from gearfilm.drawing.orbit import draw_phases, draw_spectrum, read_orbit
from studies.common.plotting import BLUE, DARK, GREY, VERMILLION, add_grid, numpy, pyplot, read_summary
from studies.common.runs import SOURCE
from studies.paper import printed
from studies.paper.films import label_life, mark_events, mark_printed
from studies.paper.life import read_life

LONG_MARCH = SOURCE / "docs/data/table3_march160"  # kept in the repository
LONG_MARCH_PERIODS = 40  # of which it has the history
HEADROOM = 10  # above a spectrum, for its labels


def draw_start(folder):
    """Figure 8: the first mesh periods from rest at the pitch point."""
    march, summary = read_march(folder / "start/results.h5"), read_summary(folder / "start", "transient")
    figure, (films, motion) = pyplot.subplots(2, 1, sharex=True, figsize=(8, 6.5), constrained_layout=True,
                                              height_ratios=[2, 1])
    draw_teeth(films, march, "h_central", 1e6)
    films.set_ylim(0, 1e6 * (printed.FILM_IN_LOSS + 1) * printed.STEADY_CENTRAL)
    films.set_ylabel("central film of each contact [µm]")
    films.axhline(1e6 * printed.STEADY_CENTRAL, color=GREY, linewidth=0.8, linestyle="--")
    films.annotate("stationary film, paper: 2.415", (1, 1e6 * printed.STEADY_CENTRAL), ha="right",
                   xycoords=films.get_yaxis_transform(), xytext=(-3, -12), textcoords="offset points", fontsize=7)
    mark_printed(films, 1e3 * printed.FIRST_LOSS, 1e6 * printed.FILM_IN_LOSS * printed.STEADY_CENTRAL,
                 "paper: contact lost after 16.27 mm,\nfilm about 8 times the stationary one", shift=(8, -3))
    motion.plot(1e3 * march.steps["distance"], march.steps["H0"], color=DARK, linewidth=1)
    motion.set_ylabel("$H_0$ [-]")
    motion.set_xlabel("length travelled along the line of action [mm]")
    for axes in (films, motion):
        for loss in summary["contact_losses"]:
            axes.axvspan(1e3 * loss["distance"], 1e3 * loss["distance_end"], color=GREY, alpha=0.3, linewidth=0)
        axes.margins(x=0)
    films.set_title("grey: no contact carries", fontsize=9)
    add_grid(films, motion)
    return figure


def draw_steady_state(folder):
    """Figure 9: history, phase portrait and spectrum of the periodic state (left, upper) and of the long march."""
    figure, panels = pyplot.subplot_mosaic([["H0 0", "H0 1"], ["phases 0", "phases 1"], 2 * ["spectrum 0"],
                                            2 * ["spectrum 1"]], figsize=(8, 11), constrained_layout=True)
    orbits = [read_orbit(folder / "periodic", 1), read_orbit(LONG_MARCH, LONG_MARCH_PERIODS)]
    for n, (orbit, title) in enumerate(zip(orbits, ["periodic state", "march of 160 mesh periods"])):
        history, spectrum = panels[f"H0 {n}"], panels[f"spectrum {n}"]
        time = (orbit.steps["T"] - orbit.steps["T"][0]) / orbit.mesh_period
        history.plot(time, orbit.steps["H0"], color=DARK, linewidth=1.2 if orbit.periodic else 0.6)
        history.set_xlabel("time [mesh periods]")
        history.set_ylabel("$H_0$ [-]")
        history.set_title(title if orbit.periodic else f"{title}, the last {LONG_MARCH_PERIODS}", fontsize=10)
        draw_phases(panels[f"phases {n}"], orbit)
        draw_spectrum(spectrum, orbit)
        spectrum.set_ylim(top=HEADROOM * spectrum.get_ylim()[1])
        for frequency in printed.SPECTRUM:
            spectrum.axvline(1e-3 * frequency, color=VERMILLION, linewidth=1, linestyle=":", zorder=0)
        spectrum.set_title(f"{title}; dotted: the paper's 1.790, 5.217, 7.007 kHz", fontsize=9)
    add_grid(*panels.values())
    return figure


def draw_force(folder):
    """Figure 10: force on a contact over the line of action."""
    life, summary = read_life(folder / "periodic"), read_summary(folder / "periodic", "periodic")
    ratio = life.rows["force"] / summary["static_force"]
    figure, axes = pyplot.subplots(figsize=(8, 4), constrained_layout=True)
    axes.plot(1e3 * life.rows["xi"], ratio, color=BLUE, label="force on the contact")
    greatest = life.rows["xi"][numpy.argmax(ratio)]
    mark_printed(axes, 1e3 * greatest, printed.FORCE_RATIO, "paper: 1.29", shift=(-48, -4))
    axes.axhline(1, color=GREY, linewidth=0.8, label="static force of the pair")
    mark_events(axes, life, labelled=True)
    label_life(axes, "force / static force [-]")
    return figure
