"""Bare contacts of steel, R_x = 12.5 mm, given by their Moes groups: case files, domains, film formulas.

Load and velocity follow from M and L, R_y from D. The oil is the same in all unless given.
"""
from studies.common.tables import percent

RATIOS = (1, 0.3, 0.06)        # D = R_x/R_y
RADIUS_X = 12.5e-3             # m
REDUCED_MODULUS = 226e9        # Pa
VISCOSITY = 0.04               # Pa s
PRESSURE_VISCOSITY = 2.2e-8    # 1/Pa
LONG_DOMAIN = (-4.5, 1.5, 3.0)         # x_min, x_max [a], half the width [b]
SHORT_DOMAIN = (-2.083, 1.25, 1.1)     # the paper's
SHORT_FROM = 200               # smallest M on the short domain
FORMULAS = (("hamrock_dowson_h_central", "h_central"), ("hamrock_dowson_h_min", "h_min"),
            ("nijenbanning_venner_moes_h_central", "h_central"))
FORMULA_HEADING = ("H-D central", "H-D smallest", "N-V-M central")


def domain_of(M):
    """Not left to the program: at M = 200 round-off would choose."""
    return LONG_DOMAIN if M < SHORT_FROM else SHORT_DOMAIN


def case_text(M, L, D, viscosity=VISCOSITY, pressure_viscosity=PRESSURE_VISCOSITY, own_domain=False):
    """A case file with these groups: U = 2 eta_0 u_m/(E' R_x) = (L/(alpha E'))^4, w = M E' R_x^2 U^(3/4).

    With own_domain the program chooses the domain.
    """
    U = (L / (pressure_viscosity * REDUCED_MODULUS)) ** 4
    x_min, x_max, y_half = domain_of(M)
    domain = "" if own_domain else f"grid: {{x_min: {x_min!r}, x_max: {x_max!r}, y_half: {y_half!r}}}\n"
    return f"""
case: {{kind: contact}}
contact:
  radius_x: {RADIUS_X!r}
  radius_y: {RADIUS_X / D!r}
  reduced_modulus: {REDUCED_MODULUS!r}
  load: {M * REDUCED_MODULUS * RADIUS_X ** 2 * U ** 0.75!r}
  entrainment_velocity: {U * REDUCED_MODULUS * RADIUS_X / (2 * viscosity)!r}
lubricant: {{viscosity: {viscosity!r}, pressure_viscosity: {pressure_viscosity!r}}}
{domain}"""


def grid_of(D, nx):
    """Nodes in x and y, square for a circular contact."""
    return (nx, nx) if D == 1 else (nx, (nx + 1) // 2)


def finer(grid):
    return 2 * grid[0] - 1, 2 * grid[1] - 1


def grid_options(grid):
    return "-grid_nx", grid[0], "-grid_ny", grid[1]


def formula_cells(film):
    """Deviations of the film formulas from a computed film, as FORMULA_HEADING names them."""
    return [percent(film["predictions"][formula] / film[height] - 1) for formula, height in FORMULAS]
