"""The discrete equations of a film as docs/model.md and docs/discretisation.md have them, written again in numpy for
fields of results.h5.

Dimensionless throughout; fields are those of the whole domain, [x, y].
"""
import math

import numpy


def love_corner(x, y):
    return x * numpy.arcsinh(y / abs(x)) + y * numpy.arcsinh(x / abs(y))


def at_faces(values, axis):
    """Means of neighbours along an axis."""
    ahead, behind = numpy.split(values, [1], axis)[1], numpy.split(values, [-1], axis)[0]
    return 0.5 * (ahead + behind)


def logarithmic_mean(values, axis):
    """Of neighbours along an axis: their difference over that of their logarithms."""
    steps = numpy.diff(numpy.log(values), axis=axis)
    close = abs(steps) < 1e-4
    return numpy.where(close, at_faces(values, axis), numpy.diff(values, axis=axis) / numpy.where(close, 1, steps))


def conditions(parameters, derived, xi):
    """R_x and u_m at a place on the line of action, over those at the pitch point."""
    angle = math.radians(derived["working_pressure_angle_deg"])
    R_1, R_2 = (derived[f"base_radius_{gear}"] * math.tan(angle) for gear in ("pinion", "wheel"))
    speed_ratio = parameters["pinion.teeth"] / parameters["wheel.teeth"]
    return (R_1 + xi) * (R_2 - xi) / (R_1 * R_2), 1 + 0.5 * (1 - speed_ratio) * xi / R_1


class FilmEquations:
    """Of one gear pair: its parameters, what `info` derives from them, and the nodes x, y [m] of its grid."""

    def __init__(self, parameters, derived, x, y):
        self.parameters, self.derived = parameters, derived
        a, R_x, u = derived["a"], derived["R_x"], derived["entrainment_velocity"]
        self.pressure, self.film, self.time = derived["p_hertz"], a ** 2 / R_x, a / u
        self.C_h = 2 * self.pressure * R_x / (math.pi * derived["E_prime"] * a)
        self.wedge_number = 12 * u * parameters["lubricant.viscosity"] * R_x ** 2 / (a ** 3 * self.pressure)  # lambda
        self.static_force = 2 * math.pi / (3 * derived["kappa"])
        self.X, self.Y = x[:, None] / a, y[None, :] / a
        self.h_x, self.h_y = (x[-1] - x[0]) / a / (len(x) - 1), (y[-1] - y[0]) / a / (len(y) - 1)

    def force(self, P):
        """The integral of P: every node stands for its cell."""
        return P.sum() * self.h_x * self.h_y

    def gap(self, P, H0, xi):
        """H: rigid displacement, paraboloid and deformation, pressure being constant on the cell of each node."""
        edges = [h * (numpy.arange(1 - n, n + 1) - 0.5) for h, n in zip((self.h_x, self.h_y), P.shape)]
        kernel = numpy.diff(numpy.diff(love_corner(edges[0][:, None], edges[1][None, :]), axis=0), axis=1)
        deformed = numpy.fft.irfft2(numpy.fft.rfft2(kernel) * numpy.fft.rfft2(P, kernel.shape), kernel.shape)
        radius_ratio, _ = conditions(self.parameters, self.derived, xi)
        return (H0 + 0.5 * self.X ** 2 / radius_ratio + 0.5 * self.derived["D"] * self.Y ** 2
                + self.C_h * deformed[P.shape[0] - 1:, P.shape[1] - 1:])

    def density(self, P):
        if self.parameters["lubricant.density_law"] == "incompressible":
            return numpy.ones_like(P)
        p = self.pressure * P
        return (5.9e8 + 1.34 * p) / (5.9e8 + p)

    def log_viscosity(self, P):
        p, alpha = self.pressure * P, self.parameters["lubricant.pressure_viscosity"]
        if self.parameters["lubricant.viscosity_law"] == "barus":
            return alpha * p
        span = math.log(self.parameters["lubricant.viscosity"]) + 9.67
        return span * numpy.expm1(alpha * 1.96e8 / span * numpy.log1p(p / 1.96e8))

    def mass(self, P, H):
        """rho H."""
        return self.density(P) * H

    def eyring_thinning(self, P, H, sliding, stress):
        """S along the sliding velocity and across it, of Eyring's law: integrals over the film by Gauss's rule."""
        gradient = numpy.zeros_like(P)
        gradient[1:-1] = (P[2:] - P[:-2]) / (2 * self.h_x)
        half = 0.5 * H * gradient * self.pressure * self.film / self.derived["a"] / stress  # h p_x/(2 tau_0)
        viscosity = self.parameters["lubricant.viscosity"] * numpy.exp(self.log_viscosity(P))
        rate = viscosity * sliding / (H * self.film * stress)
        half = numpy.where(abs(half) < 1e-6, 1e-6, half)
        mean = numpy.arcsinh(rate * half / numpy.sinh(half))
        along, across = 0.0, 0.0
        for zeta, weight in zip(*numpy.polynomial.legendre.leggauss(64)):
            tau = mean + zeta * half
            along = along + 1.5 * weight * zeta * numpy.sinh(tau) / half
            across = across + 1.5 * weight * zeta ** 2 * numpy.sinh(tau) / tau
        return along, across

    def flows(self, P, H, U, conductances):
        """Through the faces along x and along y: U rho H - xi dP/dX and -xi dP/dY."""
        if self.parameters.get("film.discretisation", "fitted") == "fitted":
            return self.fitted_flows(P, H, U, conductances)
        mass = self.mass(P, H)
        carried = numpy.concatenate([at_faces(mass[:2], 0), 1.5 * mass[1:-1] - 0.5 * mass[:-2]])
        return (U * carried - at_faces(conductances[0], 0) * numpy.diff(P, axis=0) / self.h_x,
                -at_faces(conductances[1], 1) * numpy.diff(P, axis=1) / self.h_y)

    def fitted_flows(self, P, H, U, conductances):
        density, mass = self.density(P), self.mass(P, H)
        film = numpy.concatenate([at_faces(H[:2], 0), 0.375 * H[2:] + 0.75 * H[1:-1] - 0.125 * H[:-2]])
        along = conductances[0] / (density * H ** 3)
        xi = at_faces(density, 0) * film ** 3 * logarithmic_mean(along, 0)
        part = xi / (xi + 0.2 * self.h_x ** 2 * 2 * math.pi * self.C_h * U)
        carried = at_faces(mass, 0)
        carried[1:] = (1.5 * mass[1:-1] - 0.5 * mass[:-2]
                       + part[1:] * 0.375 * (mass[2:] - 2 * mass[1:-1] + mass[:-2]))
        anisotropy = at_faces(conductances[1] / conductances[0], 1)
        across = anisotropy * at_faces(density, 1) * at_faces(H, 1) ** 3 * logarithmic_mean(along, 1)
        return (U * carried - xi * numpy.diff(P, axis=0) / self.h_x, -across * numpy.diff(P, axis=1) / self.h_y)

    def rows(self, P, H, xi, rate=0.0, shift=0.0, thinning=(1.0, 1.0)):
        """G = min(d P, R) at inner nodes; rate is d(rho H)/dT there, shift its derivative by rho H."""
        _, U = conditions(self.parameters, self.derived, xi)
        newtonian = self.density(P) * H ** 3 * numpy.exp(-self.log_viscosity(P)) / self.wedge_number
        conductances = newtonian * thinning[0], newtonian * thinning[1]
        flow_x, flow_y = self.flows(P, H, U, conductances)
        inner = (slice(1, -1), slice(1, -1))
        residual = (rate + (numpy.diff(flow_x, axis=0) / self.h_x)[:, 1:-1]
                    + (numpy.diff(flow_y, axis=1) / self.h_y)[1:-1])
        scale = 2 * conductances[0][inner] * (self.h_x ** -2 + self.h_y ** -2) + 0.05 * (U / self.h_x + shift)
        return numpy.minimum(scale * P[inner], residual)
