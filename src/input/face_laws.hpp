// The laws of the dry contact along a face that cases of one pair have: those of a sweep mostly have the same flanks
// under the same force, and a law takes seconds.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "contact/face_law.hpp"
#include "contact/scales.hpp"
#include "gear/line_of_action.hpp"

namespace gearfilm {

class FaceLaws {
public:
  /// The law of the scales' face, for the radii of a path of contact or about that of a bare contact. It is made where
  /// no case before had it. Throws SolveError.
  std::shared_ptr<const FaceLaw> law(const Scales& scales, const std::optional<LineOfAction>& line);

private:
  std::map<std::vector<double>, std::shared_ptr<const FaceLaw>> known_;  ///< by all that they are made from
};

}  // namespace gearfilm
