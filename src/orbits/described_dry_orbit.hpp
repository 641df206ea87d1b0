// The periodic motion of the dry pair, found and described as that of the lubricated pair is.
#pragma once

#include "orbits/described_orbit.hpp"

namespace gearfilm {

/// Near a motion, where the search has one: the orbit there, or what the pair settles on from there. The observer sees
/// the steps of one period. Throws SolveError where no orbit is found, and what the watch throws.
DescribedOrbit find_described_dry_orbit(const OrbitProblem& problem, const StepObserver& observer,
                                        const DryWatch& watch = {});

/// An orbit that was found, with its quantities.
DescribedOrbit describe(const OrbitProblem& problem, const DryOrbit& orbit, const StepObserver& observer = unseen);

}  // namespace gearfilm
