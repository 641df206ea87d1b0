"""Figures 3, 7 and 14: load sharing, the comparison case, and the quasi-static model against the dynamic one."""
from studies.common.plotting import (BLUE, DARK, GREEN, GREY, VERMILLION, PlotError, add_grid, add_legend, pyplot,
                                     read_summary)
from studies.paper import printed
from studies.paper.films import POSITION_AXIS, label_life, mark_events, mark_printed
from studies.paper.life import read_life, read_single_contact

SHARINGS = (("table2_step", "step", BLUE, "-"), ("table2_trapezoid", "trapezoid", VERMILLION, "--"))


def draw_load_sharing(folder):
    """Figure 3: share of the static force on one contact, as the quasi-static runs of Table 2 carry it."""
    figure, axes = pyplot.subplots(figsize=(8, 3.5), constrained_layout=True)
    for run, label, colour, line in SHARINGS:
        rows = read_single_contact(folder / run)
        axes.plot(1e3 * rows["xi"], rows["force"] / read_summary(folder / run, "transient")["static_force"],
                  color=colour, linestyle=line, label=label)
    axes.set_ylim(0, 1.1)
    label_life(axes, "force / static force [-]")
    return figure


def read_stationary(folder):
    """Summaries of the stationary films in the folders FOLDER/<position in micrometres>: (xi [mm], summary)."""
    if not folder.is_dir():
        raise PlotError(f"{folder} does not exist; run scripts/studies/paper/run with --compute")
    return sorted((1e-3 * float(run.name), read_summary(run, "steady")) for run in folder.iterdir())


def draw_stationary(axes, films, name, scale):
    """Marks of stationary films at the same position and load."""
    axes.plot([xi for xi, _ in films], [scale * film[name] for _, film in films], color=DARK, marker="o",
              markersize=4, markerfacecolor="none", linestyle="none", label="stationary solution")


def draw_comparison_case(folder):
    """Figure 7: film and pressure of Table 2, quasi-static, under both load sharings."""
    figure, (films, pressures) = pyplot.subplots(2, 1, sharex=True, figsize=(8, 7), constrained_layout=True)
    for run, label, colour, line in SHARINGS:
        rows = read_single_contact(folder / run)
        xi = 1e3 * rows["xi"]
        films.plot(xi, 1e6 * rows["h_central"], color=colour, linestyle=line, label=f"{label}, central")
        films.plot(xi, 1e6 * rows["h_min"], color=colour, linestyle=line, linewidth=0.8, alpha=0.7,
                   label=f"{label}, smallest (thin)")
        pressures.plot(xi, 1e-9 * rows["p_central"], color=colour, linestyle=line, label=f"{label}, central")
        pressures.plot(xi, 1e-9 * rows["p_max"], color=colour, linestyle=line, linewidth=0.8, alpha=0.7,
                       label=f"{label}, largest (thin)")
    stationary = read_stationary(folder / "table2_stationary")
    draw_stationary(films, stationary, "h_central", 1e6)
    draw_stationary(pressures, stationary, "p_central", 1e-9)
    mark_printed(films, 0, 1e6 * printed.TABLE_2_SOLVER, "paper, solver: 0.592", shift=(6, -12))
    mark_printed(films, 0, 1e6 * printed.TABLE_2_FORMULA, "paper, formula: 0.607", shift=(6, 8))
    hertz = 1e-9 * read_summary(folder / "table2_info", "info")["p_hertz"]
    pressures.axhline(hertz, color=GREY, linewidth=0.8)
    pressures.annotate(f"Hertz, equivalent point load: {hertz:.3f}", (1, hertz), ha="right",
                       xycoords=pressures.get_yaxis_transform(), xytext=(-3, 3), textcoords="offset points", fontsize=7)
    films.set_ylabel("film [µm]")
    pressures.set_ylabel("pressure [GPa]")
    pressures.set_xlabel(POSITION_AXIS)
    add_legend(films, *films.get_legend_handles_labels())
    add_grid(films, pressures)
    return figure


def draw_contrast(folder):
    """Figure 14: films and pressures of the quasi-static model, step load sharing, against the dynamic one."""
    life, rows = read_life(folder / "periodic"), read_single_contact(folder / "quasistatic")
    figure, panels = pyplot.subplots(3, 1, sharex=True, figsize=(8, 9), constrained_layout=True)
    stationary = read_stationary(folder / "table3_stationary")
    for axes, name, scale, label in zip(panels, ("h_central", "h_min", "p_max"), (1e6, 1e6, 1e-9),
                                        ("central film [µm]", "smallest film [µm]", "largest pressure [GPa]")):
        axes.plot(1e3 * life.rows["xi"], scale * life.rows[name], color=BLUE, label="dynamic")
        axes.plot(1e3 * rows["xi"], scale * rows[name], color=VERMILLION, linestyle="--", linewidth=1.2,
                  label="quasi-static")
        draw_stationary(axes, stationary, name, scale)
        mark_events(axes, life, labelled=axes is panels[0])
        axes.set_ylabel(label)
        axes.margins(x=0.02)
    panels[2].plot(1e3 * life.rows["xi"], 1e-9 * life.rows["p_central"], color=GREEN, linewidth=0.9,
                   label="dynamic, central")
    panels[2].plot(1e3 * rows["xi"], 1e-9 * rows["p_central"], color=GREEN, linewidth=0.9, linestyle=":",
                   label="quasi-static, central")
    panels[-1].set_xlabel(POSITION_AXIS)
    add_legend(panels[0], *panels[0].get_legend_handles_labels())
    add_legend(panels[2], *panels[2].get_legend_handles_labels())
    add_grid(*panels)
    return figure
