#include "gearfilm/ehl/compliance.hpp"

#include <cmath>

namespace gearfilm {

Compliance::Compliance(std::vector<double> matrix)
    : matrix_(std::move(matrix)), films_(std::lround(std::sqrt(static_cast<double>(matrix_.size())))) {}

bool Compliance::coupled() const {
  for (std::size_t k = 0; k < films_; ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      if ((*this)(k, j) != 0.0) return true;
    }
  }
  return false;
}

Compliance Compliance::alone(std::size_t k) const {
  return rigid() ? Compliance() : Compliance(std::vector<double>{(*this)(k, k)});
}

std::vector<double> Compliance::displacements(double H0, std::span<const double> forces) const {
  std::vector<double> displacements(forces.size(), H0);
  for (std::size_t k = 0; k < films_; ++k) {
    for (std::size_t j = 0; j < films_; ++j) displacements[k] += (*this)(k, j) * forces[j];
  }
  return displacements;
}

std::vector<double> Compliance::coupling_matrix(std::span<const double> stiffness) const {
  const std::size_t n = stiffness.size();
  std::vector<double> matrix(n * n);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = 0; j < n; ++j) matrix[k * n + j] = (k == j ? 1.0 : 0.0) + stiffness[k] * (*this)(k, j);
  }
  return matrix;
}

}  // namespace gearfilm
