"""How large a domain and how fine a grid the stationary film of a bare contact needs: laws in M, L, D.

They are fitted to the contacts of docs/data/converged_contacts.csv, which converged_contacts.py computes with them.
M = 20..3e5, L = 4..30, D = 5e-4..1. Lengths along the entrainment are in half-axes a, those across in half-axes b.
H = h_c R_x/a^2 is that of the formula of Nijenbanning, Venner and Moes. Errors are relative.
"""
import dataclasses
import math

OUTLET = 1.25                  # smallest x_max: films change by less than 0.001 % with a larger one
SIDE = 1.05                    # smallest y_half
INLET_ERROR = 0.003            # of the central film
SIDE_ERROR = 0.01              # of the smallest film, of a grid too coarse across
HALVINGS = 2                   # a grid can be made coarser, at least
COARSEST = 33                  # nodes along below which it is not halved again
FEWEST_ACROSS = 17             # nodes


@dataclasses.dataclass(frozen=True)
class Groups:
    """What the laws know of a contact."""
    L: float
    kappa: float
    H: float


@dataclasses.dataclass(frozen=True)
class Domain:
    """Edges of the domain."""
    x_min: float
    x_max: float
    y_half: float


def groups(derived):
    """Of what `info` says of a contact."""
    film = derived["nijenbanning_venner_moes_h_central"]
    return Groups(derived["L"], derived["kappa"], film * derived["R_x"] / derived["a"] ** 2)


def inlet(contact, error=INLET_ERROR):
    """Length x before the Hertz contact with which the central film is too thin by an error.

    The error falls with the square of x, the gap growing with its power 3/2, and faster where x is not short against
    the contact's width: error = 0.328 L^0.285 H^1.15/(x^2 (1 + 0.707 kappa x)).
    """
    slender = math.sqrt(0.328 * contact.L ** 0.285 * contact.H ** 1.15 / error)
    x = slender
    for _ in range(60):  # each brings it nearer by half at least
        x = slender / math.sqrt(1 + 0.707 * contact.kappa * x)
    return x


def side(contact):
    """y_half with which the central and the smallest film are too thin by about 0.3 %."""
    return max(SIDE, 1 + 5.5 * contact.kappa * contact.H ** 0.58)


def central_error(contact, h_x):
    """Of the central film on a grid of step h_x: pressure rises in the inlet over a length of H^(2/3)."""
    return 0.395 * contact.L ** 0.416 * h_x ** 2 / contact.H ** (4 / 3)


def smallest_error(contact, h_x):
    """Of the smallest film on a grid of step h_x: 1 to 1.5 times what it is."""
    return 0.15 * contact.L ** 0.955 / (1 + 0.66 * contact.kappa) * h_x ** 2 / contact.H ** (4 / 3)


def step_x(contact, aim):
    """h_x with which both errors are within the aim."""
    return math.sqrt(aim / max(central_error(contact, 1.0), smallest_error(contact, 1.0)))


def step_y(contact, error=SIDE_ERROR):
    """h_y with which the smallest film is wrong by less than an error; the central one is by a quarter of that.

    In slender contacts there is a cliff: just above the limit the film at the sides falls to nothing, just below it is
    right. In wide ones, whose film is smallest in its side lobes, the error is one of second order,
    1.3 kappa h_y^2/H^(4/3) at most.
    """
    cliff = min(0.27 * contact.H ** 0.75 * contact.kappa ** -0.25, 0.57 * contact.H * contact.kappa ** -0.5)
    lobes = math.sqrt(error / (1.3 * contact.kappa)) * contact.H ** (2 / 3)
    return min(cliff, lobes)


def cells_x(least):
    """At least so many, 2^k m: k is HALVINGS, and more as long as the coarsest grid has COARSEST nodes."""
    power = 2 ** max(HALVINGS, math.floor(math.log2(least / (COARSEST - 1))))
    return power * math.ceil(least / power)


def cells_y(least):
    """At least so many, and FEWEST_ACROSS nodes."""
    return max(FEWEST_ACROSS - 1, 4 * math.ceil(least / 4 - 1e-9))


def grid(contact, aim, error=INLET_ERROR):
    """Domain and nodes along and across with which the errors of both films are about an aim.

    X = 0 is a node, on the grids of half as many as well: the program gives the film of the nearest one as the central.
    """
    step = step_x(contact, aim)
    blocks = 2 ** HALVINGS
    outlet = blocks * math.ceil(OUTLET / step / blocks)
    along = cells_x(outlet + math.ceil((1 + inlet(contact, error)) / step))
    y_half = side(contact)
    return Domain((outlet - along) * step, outlet * step, y_half), along + 1, cells_y(2 * y_half / step_y(contact)) + 1
