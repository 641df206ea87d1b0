#include "gear/load_sharing.hpp"

#include <algorithm>
#include <cmath>

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

/// Positions where the number of contacts changes, entry and exit included.
std::vector<double> changes_of(const LineOfAction& line) {
  std::vector<double> changes;
  for (int n = 0; n < line.contact_ratio(); ++n) {
    changes.push_back(line.entry() + n * line.base_pitch());
    changes.push_back(line.exit() - n * line.base_pitch());
  }
  std::sort(changes.begin(), changes.end());
  const double same = 1e-9 * line.base_pitch();
  changes.erase(std::unique(changes.begin(), changes.end(), [&](double a, double b) { return b - a < same; }),
                changes.end());
  return changes;
}

}  // namespace

double LoadSharing::Piece::operator()(double xi) const {
  const double part = std::clamp((xi - begin) / (end - begin), 0.0, 1.0);
  return at_begin + part * (at_end - at_begin);
}

LoadSharing LoadSharing::step(const LineOfAction& line) {
  const std::vector<double> changes = changes_of(line);
  std::vector<Piece> pieces;
  for (std::size_t n = 0; n + 1 < changes.size(); ++n) {
    const double middle = 0.5 * (changes[n] + changes[n + 1]);
    const double share = 1.0 / static_cast<double>(line.contact_positions(middle).size());
    pieces.push_back({changes[n], changes[n + 1], share, share});
  }
  return LoadSharing(std::move(pieces));
}

LoadSharing LoadSharing::trapezoid(const LineOfAction& line, double at_end, double at_inner_edge) {
  const double alone_from = line.exit() - line.base_pitch(), alone_to = line.entry() + line.base_pitch();
  if (!(line.entry() < alone_from && alone_from < alone_to)) {
    throw InputError(
        "the contact ratio is ", line.contact_ratio(),
        ", but a trapezoidal load sharing is for one or two contacts; choose load_sharing_kind step or table");
  }
  return LoadSharing({{line.entry(), alone_from, at_end, at_inner_edge},
                      {alone_from, alone_to, 1.0, 1.0},
                      {alone_to, line.exit(), at_inner_edge, at_end}});
}

LoadSharing LoadSharing::table(const LineOfAction& line, const std::vector<std::pair<double, double>>& points) {
  const auto refuse = [](const std::string& what) { throw InputError("the table of the load sharing " + what); };
  if (points.size() < 2) refuse("has fewer than two points; give position [m] and share, one point a line");
  std::vector<Piece> pieces;
  for (std::size_t n = 0; n + 1 < points.size(); ++n) {
    const auto [begin, at_begin] = points[n];
    const auto [end, at_end] = points[n + 1];
    const std::string where = worded("at its point ", n + 1, ", xi = ", begin, " m, ");
    if (!(end >= begin)) refuse(where + "goes back; sort it by position");
    if (!(at_begin > 0.0 && at_end > 0.0 && std::isfinite(at_begin) && std::isfinite(at_end))) {
      refuse(where + "has a share that is not above zero");
    }
    if (end > begin) pieces.push_back({begin, end, at_begin, at_end});
  }
  const double round_off = 1e-6 * line.base_pitch();
  if (pieces.empty() || pieces.front().begin > line.entry() + round_off ||
      pieces.back().end < line.exit() - round_off) {
    refuse(
        worded("does not cover the path of contact; give positions from ", line.entry(), " m to ", line.exit(), " m"));
  }
  return LoadSharing(std::move(pieces));
}

LoadSharing LoadSharing::with_jumps_over(double length) const {
  std::vector<Piece> pieces = {pieces_.front()};
  for (std::size_t n = 1; n < pieces_.size(); ++n) {
    Piece piece = pieces_[n];
    const double before = pieces_[n - 1].at_end, landing = piece.begin + length;
    if (std::abs(piece.at_begin - before) > 1e-6) {
      if (landing >= piece.end) {
        throw InputError("the load sharing jumps at xi = ", piece.begin, " m and again within the ", length,
                         " m that a jump takes; lower load_sharing_jump_time");
      }
      const double after = piece(landing);
      pieces.push_back({piece.begin, landing, before, after, true});
      piece.begin = landing;
      piece.at_begin = after;
    }
    pieces.push_back(piece);
  }
  return LoadSharing(std::move(pieces));
}

const LoadSharing::Piece& LoadSharing::piece_at(double xi) const {
  const double round_off = 1e-9 * (pieces_.back().end - pieces_.front().begin);
  const auto after =
      std::find_if(pieces_.begin(), pieces_.end(), [&](const Piece& piece) { return xi < piece.end - round_off; });
  return after == pieces_.end() ? pieces_.back() : *after;
}

}  // namespace gearfilm
