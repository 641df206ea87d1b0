// What a point of a sweep has in its record, and what the next one reads there.
#pragma once

#include "input/case.hpp"
#include "orbits/described_orbit.hpp"
#include "orbits/orbit_chain.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// A periodic state with its map; that of the dry pair too.
void add_orbit(const MeshModel& mesh, const DescribedOrbit& found, Summary& result);
void add_dry_orbit(const OrbitProblem& problem, const DryPointFound& found, Summary& result);

/// A point on disk, but for its films, as the beginning of the next.
ChainLink read_link(const Summary& point);

}  // namespace gearfilm
