"""Laws that every valid pair of gears obeys, on random ones.

Environment as for cli_test.py; GEARFILM_RANDOM_PAIRS and GEARFILM_RANDOM_SEED choose how many and which. Pair N of a
seed does not depend on those before it; a failure names both.
"""
import math
import os
import random
import sys
import unittest

import h5py
import numpy

from film_equations import FilmEquations
from films import BALANCE, SAME, summary_in
from program import SOURCE, ProgramTest
from random_pairs import formula_holds, random_pair
from vibration import table_in

sys.path.insert(0, str(SOURCE / "scripts"))
from studies.common.pairs import case_text  # noqa: E402

PAIRS = int(os.environ.get("GEARFILM_RANDOM_PAIRS", "6"))
SEED = os.environ.get("GEARFILM_RANDOM_SEED", "5")
# Root mean square at which Newton's method stops, the default of solver.newton_tolerance, and the round-off of the same
# rows from the fields of results.h5.
STEADY_ROWS = 1.01e-8
# Sums of some thousand terms in another order, differences of values that are not far from one.
ROUND_OFF = 1e-12
# Of the formula, fitted to computed films of Barus' law: its own error, that of the grid and that of another law.
FORMULA = 0.15
# Marches of 1 and 2 processes. At least twice as much as histories differ from those with a tolerance of 1e-8
# (docs/notes/2026-11-newton-tolerance.md).
SAME_H0, SAME_FORCE, SAME_FILM = 2e-5, 1e-4, 2e-4
# H_0 at the end of a march by other time steps; measured 2e-6. Half the step changes it by 1e-4.
OTHER_STEPS = 2e-4


class Film:
    """P and H of one contact at one time, dimensionless."""

    def __init__(self, group, equations):
        self.pressure, self.film = group["P"][:] / equations.pressure, group["H"][:] / equations.film
        self.xi = group.attrs["xi"]


def root_mean_square(rows):
    """Over all nodes that the program stores, those with Y >= 0: inner rows of some contacts, the edge having none."""
    nodes = sum((inner.shape[0] + 2) * (inner.shape[1] + 3) / 2 for inner in rows)
    return math.sqrt(sum((inner[:, inner.shape[1] // 2:] ** 2).sum() for inner in rows) / nodes)


def derivative_weights(T):
    """Backward differences: the slope at the last time of the polynomial through values at all."""
    powers = (T - T[-1]) ** numpy.arange(len(T))[:, None]
    return numpy.linalg.solve(powers, numpy.eye(len(T))[1])


def fitted_motion(w, T, weights):
    """alpha, beta, f and c of docs/numerics.md, fitted frequency."""
    if w == 0:
        return 0.0, 1.0, 1.0, 0.0
    derivative = weights @ numpy.exp(1j * w * (T - T[-1]))
    x, y = derivative.imag / w, derivative.real
    return y / (w ** 2 * x), x + y ** 2 / (w ** 2 * x), 1 / x, -y / x


def step_rows(equations):
    """Root mean square at which a time step ends, the default of time.newton_tolerance, and round-off."""
    return 1.001 * min(1e-5, 6e-5 * equations.derived["nijenbanning_venner_moes_h_central"] / equations.film)


def steps_in_line(steps):
    """The times of the motion's differences at each step between events, but the first two, of which the first begins
    with a half step that no history shows: four where three steps are nearly equal, else three."""
    events = [*numpy.flatnonzero(steps["dT"] == 0), len(steps)]
    for begin, end in zip(events, events[1:]):
        for last in range(begin + 3, end):
            lengths = steps["dT"][last - 2:last + 1]
            even = lengths.max() < 1.5 * lengths.min()
            yield slice(last - (3 if even else 2), last + 1)


def expected_events(pair, derived):
    """Kind and distance of what enters and leaves in a march."""
    pitch = derived["base_pitch"]
    events = [((derived[f"xi_{kind}"] - pair["start.position"]) % pitch, kind) for kind in ("entry", "exit")]
    return sorted(event for event in events if event[0] < pair["mesh_periods"] * pitch)


class RandomPairs(ProgramTest):
    """Film at the pitch point and a march of each pair, held against equations written again."""

    def test_random_pairs_obey_the_laws_of_the_model(self):
        compared = []
        for number in range(PAIRS):
            with self.subTest(seed=SEED, pair=number):
                pair, derived = random_pair(random.Random(f"{SEED}:{number}"), self.derive)
                self.write_case(case_text(pair))
                ratio, equations = self.check_steady(pair, derived)
                events = self.check_march(pair, derived, equations)
                holds = formula_holds(pair, derived)
                print(f"pair {number}: M = {derived['M']:.0f}, L = {derived['L']:.1f}, D = {derived['D']:.3g}, "
                      f"p_h = {1e-9 * derived['p_hertz']:.2f} GPa, {pair['lubricant.viscosity_law']}, "
                      f"{pair['grid.nx']} lines, film / formula {ratio:.3f}{'' if holds else ' (not compared)'}, "
                      f"march with {' and '.join(events) or 'no event'}", flush=True)
                if holds:
                    compared.append(ratio)
                    self.assertAlmostEqual(ratio, 1, delta=FORMULA)
        # Three in five on average: none of six pairs would be so in one of some two hundred seeds.
        self.assertGreaterEqual(len(compared), PAIRS // 4)

    def derive(self, pair):
        """What `info` says of a pair; None where it refuses it."""
        run = self.run_program("info", self.write_case(case_text(pair)), "-output_dir", "info")
        if run.status == 1:
            return None
        self.assertEqual(run.status, 0, run)  # the first trial may be odd enough for a warning
        return summary_in(self.folder / "info")

    def results_of(self, command, processes):
        """Folder with the results of the case written last."""
        folder = f"{command}_{processes}"
        self.run_well(command, "case.yaml", "-output_dir", folder, processes=processes)
        return self.folder / folder

    def assert_possible(self, film, H0, equations, tolerance):
        """A film between elastic bodies: without tension, above zero, the gap of the deformed bodies.

        A cavitated node's row is its pressure times more than one: Newton's tolerance leaves no more of either sign.
        """
        for field in (film.pressure, film.film):
            self.assertTrue(numpy.isfinite(field).all())
        self.assertGreater(film.pressure.min(), -tolerance)
        self.assertGreater(film.film.min(), 0)
        gap = equations.gap(film.pressure, H0, film.xi)
        self.assertLess(abs(film.film - gap).max(), ROUND_OFF * film.film.max())

    def steady_film(self, pair, derived, processes):
        folder = self.results_of("steady", processes)
        with h5py.File(folder / "results.h5") as results:
            contact = results["contact0"]
            equations = FilmEquations(pair, derived, contact["x"][:], contact["y"][:])
            return summary_in(folder), equations, Film(contact, equations)

    def check_steady(self, pair, derived):
        """Returns the central film over that of the formula, and the equations on the pair's grid."""
        summary, equations, film = self.steady_film(pair, derived, 1)
        self.assert_possible(film, summary["H0"], equations, STEADY_ROWS)
        self.assertAlmostEqual(summary["force"] / derived["load"], 1, delta=BALANCE)
        self.assertAlmostEqual(equations.force(film.pressure) / equations.static_force, 1, delta=BALANCE)
        # Where P > 0 Reynolds' row vanishes, where P = 0 it has the sign of cavitation: the smaller of both is zero.
        self.assertLess(root_mean_square([equations.rows(film.pressure, film.film, film.xi)]), STEADY_ROWS)
        _, _, shared = self.steady_film(pair, derived, 2)
        self.assertLess(abs(shared.pressure - film.pressure).max(), SAME * film.pressure.max())
        self.assertLess(abs(shared.film / film.film - 1).max(), SAME)
        formula = derived["nijenbanning_venner_moes_h_central"]
        self.assertEqual(summary["predictions"]["nijenbanning_venner_moes_h_central"], formula)
        return summary["h_central"] / formula, equations

    def check_march(self, pair, derived, equations):
        """Returns the kinds of what entered and left."""
        folder = self.results_of("transient", 1)
        summary = summary_in(folder)
        self.assertTrue(summary["completed"])
        expected = expected_events(pair, derived)
        self.assertEqual([event["event"] for event in summary["events"]], [kind for _, kind in expected])
        numpy.testing.assert_allclose([event["distance"] for event in summary["events"]],
                                      [distance for distance, _ in expected], atol=1e-9 * derived["base_pitch"])
        steps, contacts = table_in(folder, "history/steps"), table_in(folder, "history/contacts")
        for table in (steps, contacts):
            for name in table.dtype.names:
                self.assertTrue(numpy.isfinite(table[name]).all(), name)
        self.assertGreaterEqual(contacts["force"].min(), 0)
        total = numpy.bincount(contacts["step"].astype(int), contacts["force"], len(steps))
        numpy.testing.assert_allclose(steps["force_total"], total, rtol=ROUND_OFF)
        self.assertEqual(bool(summary["contact_losses"]), (total < 0.02 * derived["load"]).any())
        self.check_motion(steps, contacts, derived, equations)
        self.check_films_in_time(folder, steps, contacts, derived, equations)
        self.check_march_of_two_processes(steps, contacts, derived)
        return [kind for _, kind in expected]

    def check_motion(self, steps, contacts, derived, equations):
        """dH_0/dT = V_0 and the equation of motion, by the differences of the time scheme, fitted to the swing of the
        dry contacts that had the forces of the step before."""
        inertia, rows = derived["I_n"] / equations.static_force, step_rows(equations)
        approach = derived["hertz_approach"] / equations.film
        for times in steps_in_line(steps):
            row = steps[times][-1]
            weights = derivative_weights(steps["T"][times])
            dH0, dV0 = weights @ steps["H0"][times], weights @ steps["V0"][times]
            pull = row["force_total"] / derived["load"] - 1

            def worst(w):
                alpha, beta, mass, damping = fitted_motion(w, steps["T"][times], weights)
                return max(abs(dH0 + alpha * dV0 - beta * row["V0"]),
                           abs(inertia * (mass * dV0 + damping * row["V0"]) - pull))

            loads = contacts["force"][contacts["step"] == times.stop - 2] / derived["load"]
            # Of contacts with the radii of the pitch point: those on the path have others.
            swing = math.sqrt(1.5 * numpy.cbrt(loads).sum() / approach / inertia)
            low, high = 0.6 * swing, 1.5 * swing
            while high - low > 1e-6 * swing:
                near = numpy.linspace(low, high, 31)
                best = min(range(31), key=lambda n: worst(near[n]))
                low, high = near[max(best - 1, 0)], near[min(best + 1, 30)]
            self.assertLess(worst(0.5 * (low + high)), rows)

    def check_films_in_time(self, folder, steps, contacts, derived, equations):
        """All films, and the mass of their oil: what stays at a full node is what flows in less what flows out."""
        films = {}  # by step and contact
        with h5py.File(folder / "results.h5") as results:
            for snapshot in results["snapshots"].values():
                step = int(numpy.flatnonzero(steps["T"] == snapshot.attrs["T"])[0])
                for name, group in snapshot.items():
                    films[step, int(name.removeprefix("contact"))] = Film(group, equations)
        rows_with_film = contacts[(steps["dT"][contacts["step"].astype(int)] > 0) | (contacts["step"] == 0)]
        self.assertEqual(sorted(films), sorted((int(row["step"]), int(row["contact"])) for row in rows_with_film))
        for row in rows_with_film:
            film = films[int(row["step"]), int(row["contact"])]
            self.assert_possible(film, steps["H0"][int(row["step"])], equations, step_rows(equations))
            force = derived["load"] * equations.force(film.pressure) / equations.static_force
            self.assertAlmostEqual(force, row["force"], delta=ROUND_OFF * contacts["force"].max())
        for times in steps_in_line(steps):
            self.check_mass(times, steps, films, equations)

    def check_mass(self, times, steps, films, equations):
        """Differences of films are of third order where oil passes at most 0.6 of a cell in a step."""
        last = times.stop - 1
        known = times if steps["dT"][last] <= 0.6 * equations.h_x else slice(last - 2, times.stop)
        weights = derivative_weights(steps["T"][known])
        rows = []
        for contact in [number for step, number in films if step == last]:
            history = [films[step, contact] for step in range(known.start, known.stop)]
            rate = sum(weight * equations.mass(film.pressure, film.film)[1:-1, 1:-1]
                       for weight, film in zip(weights, history))
            film = history[-1]
            rows.append(equations.rows(film.pressure, film.film, film.xi, rate, 1.5 / steps["dT"][last]))
        self.assertLess(root_mean_square(rows), step_rows(equations))

    def check_march_of_two_processes(self, steps, contacts, derived):
        folder = self.results_of("transient", 2)
        shared_steps, shared_contacts = table_in(folder, "history/steps"), table_in(folder, "history/contacts")
        if len(shared_steps) != len(steps) or not numpy.allclose(shared_steps["T"], steps["T"], rtol=ROUND_OFF):
            # A step that just failed on one of them was halved there: the same motion by other steps.
            self.assertAlmostEqual(shared_steps["H0"][-1], steps["H0"][-1], delta=OTHER_STEPS)
            return
        numpy.testing.assert_allclose(shared_steps["H0"], steps["H0"], rtol=0, atol=SAME_H0)
        numpy.testing.assert_allclose(shared_contacts["force"], contacts["force"], rtol=0,
                                      atol=SAME_FORCE * derived["load"])
        for name in ("h_central", "h_min"):
            numpy.testing.assert_allclose(shared_contacts[name], contacts[name], rtol=SAME_FILM)


if __name__ == "__main__":
    unittest.main()
