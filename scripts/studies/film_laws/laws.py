"""How large a domain and how fine a grid the stationary film of a bare contact needs: laws in M, L, D.

They are fitted to 42 contacts, M = 20..3e5, L = 4..30, D = 5e-4..1, which the study converged_contacts
computes with them. Those of grids are for films of the fitted discretisation (docs/discretisation.md), and are those of
src/film/expected_errors.cpp. Lengths along the entrainment are in half-axes a, those across in half-axes b.
H = h_c R_x/a^2 is that of the formula of Nijenbanning, Venner and Moes, l = H^(2/3) the length over which pressure
rises in the inlet. Errors are relative.
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


def inlet_rise(contact):
    """l, over which pressure rises in the inlet."""
    return contact.H ** (2 / 3)


def central_error(contact, h_x, h_y=0.0):
    """Bound of the error of the central film on a grid of these steps."""
    return 0.12 * (h_x / inlet_rise(contact)) ** 4 + 0.25 * h_x ** 2 + 0.12 * math.sqrt(contact.kappa) * h_y ** 2


def smallest_error(contact, h_x, h_y=0.0):
    """Bound of the error of the smallest film on a grid of these steps.

    Across it is one of wide contacts, whose film is smallest in its side lobes.
    """
    along = 0.012 * contact.L ** 0.9 / (1 + 0.66 * contact.kappa)
    across = 0.4 * contact.kappa ** 4 / (contact.kappa ** 4 + 0.16 ** 4)
    return (along * h_x ** 2 + across * h_y ** 2) / inlet_rise(contact) ** 2


def step_x(contact, aim):
    """h_x with which both errors are within the aim, as far as they are of steps along."""
    rise = 0.12 / inlet_rise(contact) ** 4
    central = math.sqrt(2 * aim / (0.25 + math.sqrt(0.25 ** 2 + 4 * rise * aim)))
    return min(central, math.sqrt(aim / smallest_error(contact, 1.0)))


def tearing_step(contact):
    """h_y from which on the film of a slender contact falls to nothing at its sides."""
    return 3 * min(0.27 * contact.H ** 0.75 * contact.kappa ** -0.25, 0.57 * contact.H * contact.kappa ** -0.5,
                   1.1 * contact.H ** 0.885 * contact.kappa ** -0.49 * contact.L ** -0.61)


def step_y(contact, error=SIDE_ERROR):
    """h_y with which both errors are within one, and two thirds of the step with which films tear."""
    within = math.sqrt(error / max(central_error(contact, 0.0, 1.0), smallest_error(contact, 0.0, 1.0)))
    return min(2 / 3 * tearing_step(contact), within)


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
