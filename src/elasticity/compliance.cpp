#include "elasticity/compliance.hpp"

namespace gearfilm {

Compliance::Compliance(Eigen::MatrixXd matrix) : matrix_(std::move(matrix)) {}

bool Compliance::coupled() const { return !matrix_.isDiagonal(0.0); }

Compliance Compliance::alone(std::size_t k) const {
  return rigid() ? Compliance() : Compliance(Eigen::MatrixXd::Constant(1, 1, (*this)(k, k)));
}

Eigen::VectorXd Compliance::displacements(const Eigen::VectorXd& rigid_part, const Eigen::VectorXd& forces) const {
  if (rigid()) return rigid_part;
  return rigid_part + matrix_ * forces;
}

std::vector<double> Compliance::displacements(double H0, std::span<const double> forces) const {
  const auto films = static_cast<Eigen::Index>(forces.size());
  const Eigen::VectorXd displaced =
      displacements(Eigen::VectorXd::Constant(films, H0), Eigen::Map<const Eigen::VectorXd>(forces.data(), films));
  return {displaced.begin(), displaced.end()};
}

}  // namespace gearfilm
