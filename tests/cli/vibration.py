"""Marches, periodic states and sweeps on a coarse grid, their tables, and the fit of a free oscillation."""
import sys

import h5py
import numpy

from films import BARBIERI, summary_in
from program import SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "scripts"))
from studies.common.trains import with_inertias  # noqa: E402

# Coarse, but with positive films throughout the periodic states of the case study at 15000 and 16000 rpm.
COARSE = ["-grid_nx", 65, "-grid_ny", 33]
MARCH = [*COARSE, "-time_dt", 0.05]
# A search ends when H0 and V0 change by less than 1e-4 over a mesh period (periodic.tolerance). The orbit is away by
# about that over |1 - multiplier|, here 0.7 to 1.4; two searches may lie on either side of it. The force ratio changes
# by about as much as H0.
SAME_ORBIT = 4e-4


def barbieri_with_inertias(pinion, wheel):
    """Text of the case study with the inertias of both gears in the place of the equivalent mass."""
    return with_inertias(BARBIERI, pinion, wheel)


def table_in(folder, name):
    with h5py.File(folder / "results.h5") as results:
        return results[name][:]


def free_oscillation(time, value, frequency):
    """Frequency, damping ratio and rest position of exp(-d t) cos(w t - phase) + rest by linear prediction.

    Equally spaced samples y obey y(t + 2 s) = p y(t + s) + q y(t) + r, where z^2 = p z + q at z = exp((-d + i w) s).
    The stride s is an eighth of a period of the frequency expected.
    """
    step = time[1] - time[0]
    numpy.testing.assert_allclose(numpy.diff(time), step, rtol=1e-9)
    stride = round(1 / (8 * frequency * step))
    rows = numpy.stack([value[stride:-stride], value[:-2 * stride], numpy.ones(len(value) - 2 * stride)], axis=1)
    p, q, r = numpy.linalg.lstsq(rows, value[2 * stride:], rcond=None)[0]
    roots = numpy.roots([1, -p, -q])
    rate = numpy.log(roots[roots.imag.argmax()]) / (stride * step)
    return rate.imag / (2 * numpy.pi), -rate.real / abs(rate), r / (1 - p - q)


class VibrationTest(ProgramTest):
    def eigen(self, *options, case=BARBIERI, processes=1):
        self.run_well("eigen", case, *COARSE, "-output_dir", "eigen", *options, processes=processes)
        return summary_in(self.folder / "eigen")

    def ring_down(self, frequency, *options):
        """A free oscillation of five mesh periods at the pitch point, as free_oscillation() fits its last four.

        The films need 1e-5 s, a tenth of a mesh period, to forget how they started.
        """
        self.run_well("transient", BARBIERI, *COARSE, "-geometry", "held", "-mesh_periods", 5, "-output_dir", "ringing",
                      *options)
        steps = table_in(self.folder / "ringing", "history/steps")
        last = steps[(steps["dT"] > 0) & (steps["t"] > 0.2 * steps["t"][-1])]
        return free_oscillation(last["t"], last["H0"], frequency)
