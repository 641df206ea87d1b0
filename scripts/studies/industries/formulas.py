"""Textbook formulas of a pair of spur gears: none of them is taken from the program.

A pair is a Pair of industries/cases.py. Geometry by the angles of the tip circles (Niemann and Winter,
Maschinenelemente II); Hertz contacts from K. L. Johnson, Contact Mechanics, (4.24) and (4.26), with Gauss' mean for the
elliptic integrals, and by the fits of Brewe and Hamrock 1977; films by Hamrock and Dowson 1977 and by Nijenbanning,
Venner and Moes 1994; tooth stiffness by ISO 6336-1, method B; loss factor by Ohlendorf. Everything in SI.
"""
import dataclasses
import math

STEEL = 7850.0                 # kg/m^3
BRASS = 8500.0


def involute(angle):
    return math.tan(angle) - angle


def shifted_sum(pair):
    """x_1 + x_2 that leave no backlash at the working centre distance."""
    alpha, working = pair.pressure_angle, working_angle(pair)
    return (involute(working) - involute(alpha)) * sum(pair.teeth) / (2 * math.tan(alpha))


def shifts(pair):
    return pair.shift, shifted_sum(pair) - pair.shift


def tip_radii(pair):
    """Addenda of one module and the shift, less what both shifts are more than the axes are apart."""
    x = shifts(pair)
    standard = 0.5 * pair.module * sum(pair.teeth)
    shortening = sum(x) * pair.module - (pair.axes - standard)
    return [0.5 * pair.module * z + pair.module * (1 + shift) - shortening for z, shift in zip(pair.teeth, x)]


def working_angle(pair):
    return math.acos(0.5 * pair.module * sum(pair.teeth) * math.cos(pair.pressure_angle) / pair.axes)


def base_radii(pair):
    return [0.5 * pair.module * z * math.cos(pair.pressure_angle) for z in pair.teeth]


def tip_ratios(pair):
    """Contact ratios of the addenda of pinion and wheel, z/(2 pi) (tan alpha_a - tan alpha_w)."""
    return [z / (2 * math.pi) * (math.tan(math.acos(base / tip)) - math.tan(working_angle(pair)))
            for z, base, tip in zip(pair.teeth, base_radii(pair), tip_radii(pair))]


def contact_ratio(pair):
    return sum(tip_ratios(pair))


def tooth_force(pair):
    """From the tangential force on the working pitch circle."""
    pitch_radius = pair.axes * pair.teeth[0] / sum(pair.teeth)
    return pair.torque / pitch_radius / math.cos(working_angle(pair))


def mesh_frequency(pair):
    return pair.teeth[0] * pair.rpm / 60


def radii(pair, place=0.0):
    """Reduced, along the rolling and along the face, at a place on the line of action, from the pitch point."""
    sine, count = math.sin(working_angle(pair)), sum(pair.teeth)
    flanks = [pair.axes * z / count * sine + way * place for z, way in zip(pair.teeth, (1, -1))]
    return flanks[0] * flanks[1] / sum(flanks), pair.width ** 2 / (8 * pair.crowning)


def plane_modulus(pair):
    """Johnson's E*; E' of the film formulas is twice this."""
    return 1 / sum((1 - nu ** 2) / modulus for modulus, nu in pair.solids)


def elliptic(modulus):
    """K and E of the first and second kind, by the arithmetic-geometric mean."""
    a, g, c, weight, total = 1.0, math.sqrt(1 - modulus ** 2), modulus, 0.5, 0.5 * modulus ** 2
    while abs(c) > 1e-15:
        a, g, c = 0.5 * (a + g), math.sqrt(a * g), 0.5 * (a - g)
        weight *= 2
        total += weight * c * c
    K = math.pi / (2 * a)
    return K, K * (1 - total)


@dataclasses.dataclass(frozen=True)
class Hertz:
    """Half-axes along the rolling and along the face, pressure, approach."""
    a: float
    b: float
    pressure: float
    approach: float


def hertz(pair, place=0.0):
    """Johnson (4.24)-(4.26): A = 1/(2 R_y), B = 1/(2 R_x); the longer axis b lies along the face."""
    across, along = (1 / (2 * radius) for radius in radii(pair, place))
    low, high = 1e-9, 1.0       # of a/b, whose ratio B/A falls as it grows
    for _ in range(200):
        ratio = math.sqrt(low * high)
        K, E = elliptic(math.sqrt(1 - ratio ** 2))
        if (E / ratio ** 2 - K) / (K - E) > across / along:
            low = ratio
        else:
            high = ratio
    # B = p_0/E* a/(b^2 e^2) [(b/a)^2 E - K] and w = 2/3 p_0 pi a b with a = ratio b.
    e2 = 1 - ratio ** 2
    force, stiff = tooth_force(pair), plane_modulus(pair)
    b = (3 * force / (2 * math.pi * stiff * across * e2) * (E / ratio ** 2 - K)) ** (1 / 3)
    pressure = 3 * force / (2 * math.pi * ratio * b * b)
    return Hertz(ratio * b, b, pressure, pressure / stiff * ratio * b * K)


def brewe_hamrock(pair):
    """Pressure and approach by the fits of the elliptic integrals; they are meant for R_y/R_x of up to 100."""
    R_x, R_y = radii(pair)
    k = 1.0339 * (R_y / R_x) ** 0.636
    E, F = 1.0003 + 0.5968 * R_x / R_y, 1.5277 + 0.6023 * math.log(R_y / R_x)
    R, force, modulus = 1 / (1 / R_x + 1 / R_y), tooth_force(pair), 2 * plane_modulus(pair)
    long = (6 * k * k * E * force * R / (math.pi * modulus)) ** (1 / 3)
    approach = F * (4.5 / (E * R) * (force / (math.pi * k * modulus)) ** 2) ** (1 / 3)
    return 3 * force * k / (2 * math.pi * long ** 2), approach


def static_error(pair, places=100):
    """Transmission error of rigid teeth: mean over a mesh period, largest less smallest.

    Contacts a base pitch apart are pressed alike; each carries (delta/q)^(3/2), q^(3/2) w that it has alone.
    """
    pitch = 2 * math.pi * base_radii(pair)[0] / pair.teeth[0]
    begin, end = -tip_ratios(pair)[1] * pitch, tip_ratios(pair)[0] * pitch
    count = math.ceil(contact_ratio(pair))

    def error(place, contacts):
        return sum(hertz(pair, place + n * pitch).approach ** -1.5 for n in range(contacts)) ** (-2 / 3)

    # While the eldest contact is there, and after it has left.
    mean, ends = 0.0, []
    leaving = end - (count - 1) * pitch
    for low, high, contacts in ((begin, leaving, count), (leaving, begin + pitch, count - 1)):
        errors = [error(low + n / places * (high - low), contacts) for n in range(places + 1)]
        mean += (sum(errors) - 0.5 * (errors[0] + errors[-1])) / places * (high - low) / pitch
        ends += errors
    return mean, max(ends) - min(ends)


def inertias(pair):
    """Solid discs on the reference circles."""
    return [0.5 * math.pi * density * pair.width * (0.5 * pair.module * z) ** 4
            for z, density in zip(pair.teeth, pair.densities)]


def equivalent_mass(pair):
    return 1 / sum(base ** 2 / inertia for base, inertia in zip(base_radii(pair), inertias(pair)))


def natural_frequency(pair):
    """One Hertz contact is as stiff as 3 w/(2 delta), delta growing with the power 2/3 of w."""
    return math.sqrt(1.5 * tooth_force(pair) / hertz(pair).approach / equivalent_mass(pair)) / (2 * math.pi)


def entrainment(pair):
    """Both flanks roll at the pitch point with the same velocity."""
    return pair.rpm * math.pi / 30 * pair.axes * pair.teeth[0] / sum(pair.teeth) * math.sin(working_angle(pair))


def hamrock_dowson(pair):
    R_x, R_y = radii(pair)
    modulus = 2 * plane_modulus(pair)
    U, G = pair.viscosity * entrainment(pair) / (modulus * R_x), pair.pressure_viscosity * modulus
    W, k = tooth_force(pair) / (modulus * R_x ** 2), 1.03 * (R_y / R_x) ** 0.64
    return 2.69 * R_x * U ** 0.67 * G ** 0.53 * W ** -0.067 * (1 - 0.61 * math.exp(-0.73 * k))


def dowson_higginson(pressure):
    return 1 + 0.6e-9 * pressure / (1 + 1.7e-9 * pressure)


def nijenbanning(pair):
    """Nijenbanning, Venner and Moes, over the density at the Hertz pressure."""
    R_x, R_y = radii(pair)
    modulus, D = 2 * plane_modulus(pair), R_x / R_y
    twice = 2 * pair.viscosity * entrainment(pair) / (modulus * R_x)
    M, L = tooth_force(pair) / (modulus * R_x ** 2) * twice ** -0.75, pair.pressure_viscosity * modulus * twice ** 0.25
    g = 1 + 0.006 * math.log(D) + 0.63 * D ** (4 / 7)
    RI = 145 * (1 + 0.796 * D ** (14 / 15)) ** (-15 / 7) / (D * M * M)
    EI = 3.18 * g ** (-14 / 25) * D ** (-1 / 15) * M ** (-2 / 15)
    RP = 1.29 * (1 + 0.691 * D) ** (-2 / 3) * L ** (2 / 3)
    EP = 1.48 * g ** (-7 / 20) * D ** (-1 / 24) * M ** (-1 / 12) * L ** 0.75
    s = 1.5 * (1 + math.exp(-1.2 * EI / RI))
    soft = (RI ** 1.5 + (EI ** -4 + (1.8 / D) ** -4) ** -0.375) ** (2 * s / 3)
    hard = (RP ** -8 + EP ** -8) ** (-s / 8)
    return R_x * math.sqrt(twice) * (soft + hard) ** (1 / s) / dowson_higginson(hertz(pair).pressure)


def iso_single(pair):
    """c' times the face width for C_R = C_B = 1, and the factor that C_B and light loads add to it.

    C_B = 0.975 is that of a rack with a dedendum of 1.25 modules at 20 deg; below 100 N of tangential force a
    millimetre of face c' falls with the power 0.25 of it.
    """
    (x1, x2), (z1, z2) = shifts(pair), pair.teeth
    q = (0.04723 + 0.15551 / z1 + 0.25791 / z2 - 0.00635 * x1 - 0.11654 * x1 / z1 - 0.00193 * x2 - 0.24188 * x2 / z2 +
         0.00529 * x1 ** 2 + 0.00182 * x2 ** 2)
    moduli = [modulus for modulus, _ in pair.solids]
    material = 2 * moduli[0] * moduli[1] / sum(moduli) / 206e9
    basic_rack = 0.975 * (1 - 0.02 * (20 - math.degrees(pair.pressure_angle)))
    line_load = 1e-3 * tooth_force(pair) * math.cos(working_angle(pair)) / pair.width
    return 0.8 / q * 1e9 * pair.width * material, basic_rack * min(1, line_load / 100) ** 0.25


def ohlendorf(pair):
    (e1, e2), (z1, z2) = tip_ratios(pair), pair.teeth
    return math.pi * (1 / z1 + 1 / z2) * (1 - e1 - e2 + e1 ** 2 + e2 ** 2)
