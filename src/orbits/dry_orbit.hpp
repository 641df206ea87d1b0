// The periodic motion of the dry gear pair, by shooting.
//
// Unknown: (H_0, V_0) at the moment a contact has just left; equation: they repeat after one mesh period
// (dry_pair.hpp). Newton's method (dry_shooting.hpp) from several starts in turn. With a little damping the start of
// the lubricated orbit.
#pragma once

#include "dynamics/dry_pair.hpp"
#include "orbits/dry_shooting.hpp"
#include "orbits/monodromy.hpp"

namespace gearfilm {

/// About the damping ratio that films give a gear pair (0.007 to 0.009 for the case study at 7000 to 20000 rpm).
constexpr double typical_film_damping = 0.008;

/// Damping ratio that films give a pair, within a factor of 1.7 of that of 22 of 23 catalogue pairs: by the film over
/// the approach of the contact, and by the way that oil goes in a swing, 1/w half-axes a.
double expected_film_damping(const MeshModel& mesh);

struct DryOrbit {
  Motion start;  ///< where the mesh begins
  Monodromy monodromy;
  double largest_integral = 0.0;  ///< largest pressure integral of one contact
};

/// The mesh starts (T = 0) just after a contact has left; damping_ratio: of a viscous damper beside the contacts,
/// relative to the linear natural frequency. Where it begins, in turn:
///   - a pair that forgets its start within a few mesh periods: what it comes to from rest;
///   - others, and where that is no orbit: a strongly damped pair, which forgets its start too; the damping is lowered,
///     each orbit starting from the last;
///   - of an order above 1: pushed off the orbit of first order;
///   - long marches, from rest and from three motions beside it, and at last unstable orbits that they pass by.
/// Throws SolveError where no orbit is found; it says what the pair comes to instead.
DryOrbit find_dry_orbit(const MeshModel& mesh, double damping_ratio, const DryWatch& watch = {});

/// The dry periodic orbit at a damping ratio, by all ways of find_dry_orbit but the long marches; nothing where those
/// find none.
std::optional<DryOrbit> find_dry_orbit_soon(const MeshModel& mesh, double damping_ratio);

/// The orbit to which that of a strongly damped pair leads when the damping is lowered to none; nothing where its
/// branch ends on the way.
std::optional<DryOrbit> undamped_dry_orbit(const MeshModel& mesh);

/// Where a search for the lubricated pair's orbit begins: the dry pair's at the expected damping, by all but long
/// marches. Where that finds none, what it has come to after a time, with a map that forgets its start: the search then
/// marches on at first.
DryOrbit dry_start(const MeshModel& mesh);

/// The orbit next to a motion, or what dry_orbit_after() finds. Throws SolveError where there is no orbit.
DryOrbit dry_orbit_from(const MeshModel& mesh, double damping_ratio, const Motion& near, const DryWatch& watch = {});

/// What the pair settles on from a motion by long marches, or from three others beside it; at last unstable orbits that
/// these pass by. Throws SolveError where there is no orbit.
DryOrbit dry_orbit_after(const MeshModel& mesh, double damping_ratio, const Motion& from, const DryWatch& watch = {});

/// The orbit next to a motion near it (that of a neighbouring speed, say). Nothing where the shooting does not
/// converge.
std::optional<DryOrbit> follow_dry_orbit(const MeshModel& mesh, double damping_ratio, const Motion& near);

}  // namespace gearfilm
