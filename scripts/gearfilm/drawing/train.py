"""Loads of a drive train in motion: tooth force, torques of shafts and forces on bearings, over time and by orders.

Drawn is the periodic state found by `gearfilm periodic`, or the last mesh periods of `gearfilm transient`. Orders are
those of the pinion's shaft, their amplitudes of a periodic state, or of a march with output.spectrum_periods.
"""
from typing import NamedTuple, Optional

import numpy
from matplotlib import pyplot

from .canvas import (BLUE, DARK, GREEN, GREY, PURPLE, VERMILLION, PlotError, add_grid, add_legend, add_periods,
                     open_results, read_summary, read_table, require_periods)

COMMANDS = "transient or periodic"
CYCLE = [BLUE, VERMILLION, GREEN, PURPLE, DARK, GREY]
DECADES = 4          # of amplitudes that are drawn
SAME_TIME = 1e-6     # in mesh periods


class TrainMotion(NamedTuple):
    """Rows of one span, at the same steps."""
    periods: numpy.ndarray              # time in mesh periods from the begin of the span
    steps: numpy.ndarray
    train: numpy.ndarray
    orders: Optional[numpy.ndarray]

    @property
    def torques(self):
        return [name for name in self.train.dtype.names if name.startswith(("shaft_", "ground_"))]

    @property
    def bearings(self):
        return [name[:-2] for name in self.train.dtype.names if name.startswith("bearing_") and name.endswith("_x")]


def read_motion(folder, periods):
    path = folder / "results.h5"
    with open_results(path, COMMANDS, "it has no history") as results:
        if "history/train" not in results:
            raise PlotError(f"{path} has no drive train; give one (motor, load, bearings or train.file)")
        steps = read_table(results, "history/steps", ["T", "t", "force_total"])
        train = read_table(results, "history/train", ["step", "t"])
        orders = read_table(results, "orders", ["order", "transmission_error"]) if "orders" in results else None
        ends = dict(results["history"].attrs)
    if not steps["T"].any():
        raise PlotError(f"{path} has no time step yet")
    mesh_period = read_summary(folder, COMMANDS)["mesh_period"] * steps["T"][-1] / steps["t"][-1]
    begin = ends.get("periodic_from", max(0.0, steps["T"][-1] - periods * mesh_period))
    time = (steps["T"] - begin) / mesh_period
    last = (ends.get("periodic_to", steps["T"][-1]) - begin) / mesh_period
    within = (time >= -SAME_TIME) & (time <= last + SAME_TIME)
    return TrainMotion(time[within], steps[within], train[within], orders)


def curves(motion):
    """Label, unit's factor, and of each line its name, values and the columns of its orders, panel by panel."""
    train = motion.train
    yield "force of the teeth [kN]", 1e-3, [("teeth", motion.steps["force_total"], [])]
    if motion.torques:
        yield "torques less their means [N m]", 1.0, [
            (name.partition("_")[2].replace("_", "-"), train[name] - train[name].mean(), [name])
            for name in motion.torques]
    if motion.bearings:
        yield "forces on bearings [kN]", 1e-3, [
            (name.partition("_")[2], numpy.hypot(train[name + "_x"], train[name + "_y"]), [name + "_x", name + "_y"])
            for name in motion.bearings]


def draw_orders(axes, orders, lines, scale):
    """Amplitudes of the lines, up to where they can be seen; of a bearing that of both directions together."""
    largest, highest = 0.0, orders["order"][0]
    for colour, (name, _, columns) in zip(CYCLE, lines):
        amplitude = scale * numpy.sqrt(sum(orders[column] ** 2 for column in columns))
        axes.plot(orders["order"], amplitude, color=colour, marker=".", linestyle="none", markersize=5, label=name)
        axes.vlines(orders["order"], 0, amplitude, color=colour, linewidth=0.8)
        largest = max(largest, amplitude.max())
        highest = max(highest, orders["order"][amplitude > 10.0 ** -DECADES * amplitude.max()].max(initial=0))
    if largest > 0:
        axes.set_yscale("log")
        axes.set_ylim(10.0 ** -DECADES * largest, 3 * largest)
    return highest


def draw(motion):
    panels = list(curves(motion))
    columns = 1 if motion.orders is None else 2
    figure, axes = pyplot.subplots(len(panels), columns, sharex="col", squeeze=False,
                                   figsize=(4.6 * columns, 0.6 + 2.3 * len(panels)), constrained_layout=True)
    for row, (label, scale, lines) in zip(axes, panels):
        for colour, (name, values, _) in zip(CYCLE, lines):
            row[0].plot(motion.periods, scale * values, color=colour, linewidth=1.0, label=name)
        row[0].set_ylabel(label, fontsize=9)
        row[0].margins(x=0)
        if len(lines) > 1:
            add_legend(row[0], *row[0].get_legend_handles_labels())
    axes[-1, 0].set_xlabel("time [mesh periods]")
    if columns == 2:
        error = [("error", None, ["transmission_error"])]
        highest = 0.0
        for row, (label, scale, lines) in zip(axes, panels):
            teeth = lines[0][0] == "teeth"
            seen = draw_orders(row[1], motion.orders, error if teeth else lines, 1e6 if teeth else scale)
            highest = max(highest, seen)
            unit = label.partition("[")[2]
            row[1].set_ylabel("transmission error [µm]" if teeth else f"amplitudes [{unit}", fontsize=9)
        axes[-1, 1].set_xlim(0, 1.05 * highest)
        axes[-1, 1].set_xlabel("order of the pinion's shaft [-]")
    add_grid(*axes.flat)
    return figure


def add_options(parser):
    add_periods(parser)


def draw_folder(folder, periods=1):
    """Draws `gearfilm periodic`, or the last mesh periods of `transient`, of a case with a drive train."""
    require_periods(periods)
    return draw(read_motion(folder, periods))
