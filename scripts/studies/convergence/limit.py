"""Observed order, limit and error bar of values whose step is halved again and again."""
import itertools
import math
from typing import NamedTuple, Optional

FORMAL_ORDER = 2
TRUSTED_ORDERS = (1.3, 3.0)


class Limit(NamedTuple):
    """What a sequence converges to; None where there are too few values to tell."""
    order: Optional[float] = None
    value: Optional[float] = None
    bar: Optional[float] = None


def limit_of(values):
    """The limit of values from the coarsest to the finest step, each half of the one before; None: not solved.

    Values before a gap, and gaps at the end, do not count. The order is log2 of the ratio of the last two differences;
    there is none where these have opposite signs. Every pair has an extrapolated value of the formal order 2,
    fine + (fine - coarse)/3; the last one is the limit, and how much it differs from the one before is the error bar.
    This holds while the error falls by about four. Where the observed order is outside 1.3 to 3, or there is none, as
    with differences that do not shrink or with only two values, the values are not seen to behave so. Then the bar is
    at least the last difference, which is three times what the extrapolation added: it covers a first-order error, and
    values that scatter.
    """
    known = finest_unbroken(values)
    if len(known) < 2:
        return Limit()
    pairs = list(itertools.pairwise(known))
    extrapolated = [fine + (fine - coarse) / (2 ** FORMAL_ORDER - 1) for coarse, fine in pairs]
    bar = abs(extrapolated[-1] - extrapolated[-2]) if len(pairs) > 1 else 0.0
    order = observed_order(*known[-3:]) if len(known) > 2 else None
    if order is None or not TRUSTED_ORDERS[0] <= order <= TRUSTED_ORDERS[1]:
        bar = max(bar, abs(known[-1] - known[-2]))
    return Limit(order, extrapolated[-1], bar)


def finest_unbroken(values):
    """The values after the last gap, gaps at the end aside."""
    known = []
    for value in reversed(values):
        if value is not None:
            known.insert(0, value)
        elif known:
            break
    return known


def observed_order(coarse, middle, fine):
    first, last = middle - coarse, fine - middle
    return math.log2(first / last) if first * last > 0 else None
