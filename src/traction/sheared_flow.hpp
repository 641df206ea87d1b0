// What a shear law that is not Newton's makes of the flow along a film (lubricant/shear_law.hpp), as fields that
// Reynolds' equation is given (film/flow_factors.hpp).
//
// The flow that pressure drives is S times that of a Newtonian oil along the sliding velocity, and A S times at right
// angles to it: shear by sliding thins the oil for it, along more than across. Where the film is as warm everywhere S
// is exact. Where it is not, viscosity is the harmonic mean over the film here, which is exact as long as pressure
// drives little beside sliding.
#pragma once

#include "film/contact_film.hpp"
#include "traction/traction_model.hpp"

namespace gearfilm {

/// S and A at one node of a flow correction; x = ln(eta/eta_0) - ln F there, the others as mean_shear has them.
void put_shear(const ShearLaw& law, double log_newtonian, double half_gradient, double x, std::size_t node,
               FlowFactors& flow);

/// Flow factors of a film at its present state that has one temperature everywhere.
FlowFactors sheared_flow(const TractionModel& model, const ContactFilm& film);

}  // namespace gearfilm
