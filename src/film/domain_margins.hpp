// Margins around a loaded contact: how far the edges of its grid must stay from it, and a grid that reaches farther.
//
// Films hardly depend on where the edges are while the Hertz ellipse of the present force stays clear of the sides and
// the outlet, and the inlet lies so far before it that the contact is flooded (domain.hpp).
#pragma once

#include <limits>
#include <string>

#include "film/contact_conditions.hpp"
#include "gearfilm/error.hpp"
#include "grid/grid.hpp"

namespace gearfilm {

/// A contact that ends within the face at first has come to its edges: films over the whole face go on.
class EdgesReached : public SolveError {
public:
  using SolveError::SolveError;
};

/// The rule by which the edges follow a contact.
struct MarginRule {
  double inlet = 1.0;                                     ///< between the ellipse and X_min [a]
  double side = 1.06;                                     ///< half the width, of the ellipse's half-axis
  double face = std::numeric_limits<double>::infinity();  ///< half the face width [a]: no domain is wider
};

/// Distances of the edges from the centre; in units of the Hertz half-axis a in both directions.
struct DomainMargins {
  double inlet = 0.0;
  double outlet = 0.0;
  double side = 0.0;

  bool operator==(const DomainMargins&) const = default;
};

/// What a contact under a pressure integral must have at least, growth: with half-axes that are about to be so many
/// times as long. Throws EdgesReached, naming `where`, if its ellipse reaches the edges of the teeth.
DomainMargins required_margins(const MarginRule& rule, const Scales& scales, const ContactConditions& conditions,
                               double pressure_integral, const std::string& where, double growth = 1.0);
/// What several contacts on one grid need.
DomainMargins enclosing(const DomainMargins& a, const DomainMargins& b);

bool fits(const GridShape& shape, const DomainMargins& needed);

/// The shape with more lines and rows of the same steps where it lacks room, and some to spare; so many that coarser
/// grids stay as they are.
GridShape widened(const GridShape& shape, const DomainMargins& needed, const MarginRule& rule);

}  // namespace gearfilm
