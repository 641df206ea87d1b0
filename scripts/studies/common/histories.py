"""Histories of periodic states: the force of a period, and how far two of them are apart."""
import h5py
import numpy

from studies.common.runs import RunError


def periodic_steps(results):
    """The steps of the periodic period. A row without a step is the state just after a contact came or went."""
    span, steps = results["history"].attrs, results["history/steps"][:]
    begin, end = span["periodic_from"], span["periodic_to"]
    return steps[(steps["T"] >= begin * (1 - 1e-12)) & (steps["T"] <= end * (1 + 1e-12))]


def force_of_period(folder):
    """Times [T], the total force and the number of contacts at the steps of the period."""
    with h5py.File(folder / "results.h5") as results:
        steps = periodic_steps(results)
        begin = results["history"].attrs["periodic_from"]
    return steps["T"] - begin, steps["force_total"], steps["contacts"]


def pieces(history):
    """The parts of a history between events: there the number of contacts changes, or two rows have one time."""
    times, forces, contacts = history
    events = (numpy.diff(contacts) != 0) | (numpy.diff(times) == 0)
    cuts = [0, *(numpy.flatnonzero(events) + 1), len(times)]
    return [(times[a:b], forces[a:b]) for a, b in zip(cuts, cuts[1:]) if b - a > 1]


def cubic(times, values, wanted):
    """Values at the wanted times by the cubic through the four times about each."""
    first = numpy.clip(numpy.searchsorted(times, wanted) - 2, 0, len(times) - 4)
    nodes = first[:, None] + numpy.arange(4)
    result = numpy.zeros(len(wanted))
    for k in range(4):
        weight = numpy.ones(len(wanted))
        for j in range(4):
            if j != k:
                weight *= (wanted - times[nodes[:, j]]) / (times[nodes[:, k]] - times[nodes[:, j]])
        result += weight * values[nodes[:, k]]
    return result


def force_difference(folder, finer):
    """Root mean square of what the forces of two periodic states differ by over the largest; at the steps of the first
    between those of the second, with as many contacts."""
    own, other = pieces(force_of_period(folder)), pieces(force_of_period(finer))
    if len(own) != len(other):
        raise RunError(f"contacts come and go {len(own)} times in a period of {folder}, {len(other)} times in {finer}")
    differences = []
    for (times, forces), (finer_times, finer_forces) in zip(own, other):
        if len(finer_times) < 4:
            continue
        inside = (times >= finer_times[0]) & (times <= finer_times[-1])
        differences.append(forces[inside] - cubic(finer_times, finer_forces, times[inside]))
    largest = max(forces.max() for _, forces in other)
    return numpy.sqrt(numpy.mean(numpy.concatenate(differences) ** 2)) / largest
