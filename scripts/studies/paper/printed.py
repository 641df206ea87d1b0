"""What the paper prints: Barbieri, Lubrecht, Pellicano, Tribology International 62 (2013) 37-48, SI units.

doi 10.1016/j.triboint.2013.01.017.
"""

# Its Table 3, the case study.
M, L, D, I_N = 2401.12, 27.4, 0.06, 31.13
NATURAL_FREQUENCY, MESH_FREQUENCY = 5142.0, 7000.0  # f_n, f_m
# Stationary film at the pitch point.
STEADY_CENTRAL, STEADY_SMALLEST = 2.415e-6, 2.163e-6
# From rest: length travelled until contact is first lost; central film there, in those of the stationary film.
FIRST_LOSS, FILM_IN_LOSS = 16.27e-3, 8
# Steady state: largest force of one contact over the static one, largest pressure, films.
FORCE_RATIO, LARGEST_PRESSURE = 1.29, 3.28e9
PITCH_CENTRAL, PITCH_SMALLEST = 2.495e-6, 2.127e-6
ENTRY_CENTRAL, ENTRY_SMALLEST = 2.2e-6, 1.9e-6
# Lines of its spectrum: mesh frequency, free oscillation, its mirror.
SPECTRUM = (7007.0, 5217.0, 1790.0)
# Along the line of action: where the next contact enters, where a contact leaves.
ENTERING_OF_NEXT, LEAVING = 3.5e-3, 5.76e-3
# Delays along the line of action: of D after the other contact left, of the least central pressure after D, of the
# greatest pressure after E, of F after the other contact entered.
DELAY_D, DELAY_LEAST_PRESSURE, DELAY_GREATEST_PRESSURE, DELAY_F = 1.3e-3, 1.7e-3, 1.78e-3, 2.5e-3
# Its Table 2, the comparison case: central film at the pitch point by its own solver and by the formula it quotes.
TABLE_2_SOLVER, TABLE_2_FORMULA = 0.592e-6, 0.607e-6
