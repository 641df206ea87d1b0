#include "train/relative_motion.hpp"

#include <algorithm>
#include <numeric>

#include "algebra/dense.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

constexpr double dependent = 1e-9;  // what is left of a unit row that others span

/// All ways: those of the contacts first, then those of the elements.
Eigen::MatrixXd all_rows(const Train& train) {
  Eigen::MatrixXd rows = train.contacts();
  for (const TrainElement& element : train.elements()) {
    const Eigen::Index before = rows.rows();
    rows.conservativeResize(before + element.rows.rows(), Eigen::NoChange);
    rows.bottomRows(element.rows.rows()) = element.rows;
  }
  return rows;
}

/// The rows that no earlier ones span, scaled to ways in lengths, and what they span as an orthonormal basis of entries
/// in lengths.
struct IndependentRows {
  Eigen::MatrixXd rows, basis;
};

IndependentRows independent(const Eigen::MatrixXd& rows, const Eigen::VectorXd& lengths) {
  IndependentRows found{Eigen::MatrixXd(0, rows.cols()), Eigen::MatrixXd(0, rows.cols())};
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    Eigen::RowVectorXd rest = rows.row(k).cwiseQuotient(lengths.transpose());
    if (rest.norm() == 0.0) continue;  // such as a shaft between two imposed speeds
    rest.normalize();
    for (int twice = 0; twice < 2; ++twice) rest -= rest * found.basis.transpose() * found.basis;
    if (rest.norm() < dependent) continue;
    found.basis.conservativeResize(found.basis.rows() + 1, Eigen::NoChange);
    found.basis.bottomRows(1) = rest.normalized();
    found.rows.conservativeResize(found.rows.rows() + 1, Eigen::NoChange);
    found.rows.bottomRows(1) = rows.row(k) / rows.row(k).cwiseQuotient(lengths.transpose()).cwiseAbs().maxCoeff();
  }
  return found;
}

/// Which entries of q hang together: the number of a part for each. Those that the first contact joins are part 0.
std::vector<int> parts_of(const Eigen::MatrixXd& rows) {
  std::vector<int> part(static_cast<std::size_t>(rows.cols()));
  std::iota(part.begin(), part.end(), 0);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    std::vector<int> joined;
    for (std::size_t n = 0; n < part.size(); ++n) {
      if (rows(k, static_cast<Eigen::Index>(n)) != 0.0) joined.push_back(part[n]);
    }
    if (joined.empty()) continue;
    const int least = std::ranges::min(joined);
    for (int& number : part) {
      if (std::ranges::find(joined, number) != joined.end()) number = least;
    }
  }
  Eigen::Index of_contact = 0;
  if (rows.rows() > 0) rows.row(0).cwiseAbs().maxCoeff(&of_contact);
  const int main = part[static_cast<std::size_t>(of_contact)];
  for (int& number : part) number = number == main ? 0 : number + 1;
  return part;
}

/// The names of the nodes that move in the given entries.
std::string names_of_moved(const Train& train, const Eigen::VectorXd& moves) {
  std::string names;
  for (std::size_t n = 0; n < train.node_count(); ++n) {
    const double moved = std::abs(train.rotation(n) * moves) + (train.translation(n) * moves).cwiseAbs().sum();
    if (moved > dependent) names += (names.empty() ? "" : ", ") + train.node(n).name;
  }
  return names;
}

void require_one_rotation(const Train& train, const Eigen::MatrixXd& rows, const Eigen::MatrixXd& free) {
  const std::vector<int> parts = parts_of(rows);
  Eigen::VectorXd moved = free.cwiseAbs().rowwise().sum();
  bool loose = false;
  for (std::size_t n = 0; n < parts.size(); ++n) {
    double& entry = moved[static_cast<Eigen::Index>(n)];
    if (parts[n] == 0) entry = 0.0;
    loose = loose || entry > dependent;
  }
  if (!loose && free.cols() <= 1) return;
  if (!loose) moved = free.cwiseAbs().rowwise().sum();
  throw InputError("the drive train has parts that hang on nothing: ", names_of_moved(train, moved),
                   "; join them to the gears by a shaft, or hold them by a bearing, a ground or fixed");
}

void require_moving_contacts(const Train& train) {
  for (const auto& row : train.contacts().rowwise()) {
    if (row.size() > 0 && row.cwiseAbs().maxCoeff() > 0.0) continue;
    throw InputError(
        "the drive train imposes the speeds of both gears, so that their flanks cannot part; free one of them");
  }
}

}  // namespace

RelativeMotion relative_motion(const Train& train) {
  require_moving_contacts(train);
  const Eigen::VectorXd lengths = train.lengths();
  const Eigen::MatrixXd rows = all_rows(train);
  const IndependentRows found = independent(rows, lengths);
  const Eigen::MatrixXd free = orthogonal_complement(found.basis.transpose());
  require_one_rotation(train, rows, free);
  if (free.cols() == 0) return {.coordinates = found.rows, .motions = inverse(found.rows)};
  Eigen::Index largest = 0;
  free.col(0).cwiseAbs().maxCoeff(&largest);
  const Eigen::VectorXd rigid = free.col(0).cwiseQuotient(lengths) / free(largest, 0);
  // R and phi_0^T M together have the inverse [Z, phi_0/(phi_0^T M phi_0)].
  Eigen::MatrixXd whole(train.freedoms(), train.freedoms());
  whole << found.rows, rigid.transpose() * train.mass();
  return {.coordinates = found.rows, .motions = inverse(whole).leftCols(found.rows.rows()), .rigid = rigid};
}

}  // namespace gearfilm
