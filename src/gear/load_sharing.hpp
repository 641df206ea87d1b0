// The share f of the static force that one tooth contact carries along the line of action: what the simplified models
// prescribe in place of the other contacts, f(xi) of (5) and (6) of doi 10.1016/j.triboint.2013.01.017.
//
// Piecewise linear in xi. It may jump from one piece to the next, as where a neighbour enters or leaves.
#pragma once

#include <vector>

#include "gear/line_of_action.hpp"

namespace gearfilm {

class LoadSharing {
public:
  struct Piece {
    double begin = 0.0;  ///< xi [m]
    double end = 0.0;
    double at_begin = 0.0;  ///< f there
    double at_end = 0.0;
    bool jump = false;  ///< stands for a jump

    /// f inside, or at either end as seen from inside.
    double operator()(double xi) const;
  };

  /// 1/n where n contacts exist.
  static LoadSharing step(const LineOfAction& line);
  /// 1 where the contact is alone; linear between at_end, where it enters or leaves, and at_inner_edge, where it
  /// becomes alone (Wang et al. 2004). For contact ratios from one to two; throws InputError otherwise.
  static LoadSharing trapezoid(const LineOfAction& line, double at_end, double at_inner_edge);
  /// Linear between points (xi [m], f), ascending in xi; two points at one xi make a jump. Throws InputError unless
  /// they cover the path of contact with positive shares.
  static LoadSharing table(const LineOfAction& line, const std::vector<std::pair<double, double>>& points);

  /// A copy with every jump, and nothing else, spread over a length [m] behind it. Throws InputError where a piece is
  /// shorter.
  LoadSharing with_jumps_over(double length) const;

  /// Adjoining pieces from entry to exit.
  const std::vector<Piece>& pieces() const { return pieces_; }
  /// The piece at a position; of two that meet there the later one.
  const Piece& piece_at(double xi) const;
  double operator()(double xi) const { return piece_at(xi)(xi); }

private:
  explicit LoadSharing(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

  std::vector<Piece> pieces_;
};

}  // namespace gearfilm
