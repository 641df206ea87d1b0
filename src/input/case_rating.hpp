// How the pair of a case is rated.
#pragma once

#include <memory>

#include "input/case.hpp"
#include "rating/rating_model.hpp"

namespace gearfilm {

/// The ratings of a pair of gears with its scales and heat; null without any limit. Throws InputError.
std::shared_ptr<const RatingModel> read_rating(const CaseInput& problem);

}  // namespace gearfilm
