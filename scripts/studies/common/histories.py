"""Histories of periodic states: the force of a period, and how far two of them are apart."""
import h5py
import numpy

from studies.common.runs import RunError


def force_of_period(folder):
    """Times from the begin of the period [T], the total force [static forces] and the number of contacts there."""
    with h5py.File(folder / "results.h5") as results:
        history = results["history"]
        begin, end = history.attrs["periodic_from"], history.attrs["periodic_to"]
        steps = history["steps"][:]
    inside = (steps["T"] > begin * (1 + 1e-12)) & (steps["T"] <= end * (1 + 1e-12))
    if not inside.any():
        raise RunError(f"{folder} has no steps of a period")
    return steps["T"][inside] - begin, steps["force_total"][inside], steps["contacts"][inside]


def pieces(history):
    """The parts of a history between changes of the number of contacts."""
    times, forces, contacts = history
    cuts = [0, *(numpy.flatnonzero(numpy.diff(contacts)) + 1), len(times)]
    return [(times[a:b], forces[a:b]) for a, b in zip(cuts, cuts[1:])]


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
