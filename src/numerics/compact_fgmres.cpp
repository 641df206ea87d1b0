#include "numerics/compact_fgmres.hpp"

#include <petsc/private/kspimpl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace gearfilm {
namespace {

constexpr std::size_t piece = 1024;  // of a vector, that lies in the nearest cache while all of a basis pass it
constexpr std::size_t lanes = 8;

/// Factor by which one cycle lowers the residual at most: what numbers of this type can tell.
template <class Real>
constexpr double digits = std::is_same_v<Real, float> ? 1e-6 : 1e-14;

template <class Real>
using Basis = std::vector<std::unique_ptr<Real[]>>;

template <class Real>
Real* vector_of(Basis<Real>& basis, std::size_t n, std::size_t size) {
  if (n == basis.size()) basis.push_back(std::make_unique_for_overwrite<Real[]>(size));
  return basis[n].get();
}

template <class Real>
double dot(const Real* a, const double* b, std::size_t count) {
  std::array<double, lanes> sums{};
  std::size_t n = 0;
  for (; n + lanes <= count; n += lanes) {
    for (std::size_t k = 0; k < lanes; ++k) sums[k] += a[n + k] * b[n + k];
  }
  double sum = 0.0;
  for (; n < count; ++n) sum += a[n] * b[n];
  for (const double part : sums) sum += part;
  return sum;
}

/// values += sum_j factors_j basis_j, piece by piece; each piece is then given to work(begin, size).
template <class Real, class Work>
void add_combination(const Basis<Real>& basis, std::span<const double> factors, std::span<double> values, Work work) {
  for (std::size_t begin = 0; begin < values.size(); begin += piece) {
    const std::size_t count = std::min(piece, values.size() - begin);
    double* out = values.data() + begin;
    for (std::size_t j = 0; j < factors.size(); ++j) {
      const Real* in = basis[j].get() + begin;
      for (std::size_t n = 0; n < count; ++n) out[n] += factors[j] * in[n];
    }
    work(out, count);
  }
}

template <class Real>
void store_scaled(std::span<const double> values, double factor, Real* out) {
  for (std::size_t n = 0; n < values.size(); ++n) out[n] = static_cast<Real>(factor * values[n]);
}

template <class Real>
void load(const Real* in, std::span<double> values) {
  std::copy_n(in, values.size(), values.begin());
}

template <class Real>
class Fgmres {
public:
  explicit Fgmres(int restart) : restart_(static_cast<std::size_t>(restart)) {}

  void solve(KSP ksp) {
    Vec residual = ksp->work[0];
    ksp->its = 0;
    ksp->reason = KSP_CONVERGED_ITERATING;
    for (bool from_zero = ksp->guess_zero; !ksp->reason; from_zero = false) {
      petsc_check(VecCopy(ksp->vec_rhs, residual));
      if (!from_zero) {
        Mat matrix = nullptr;
        petsc_check(PCGetOperators(ksp->pc, &matrix, nullptr));
        petsc_check(MatMult(matrix, ksp->vec_sol, ksp->work[1]));
        petsc_check(VecAXPY(residual, -1.0, ksp->work[1]));
      }
      cycle(ksp);
      if (!ksp->reason && ksp->its >= ksp->max_it) ksp->reason = KSP_DIVERGED_ITS;
    }
  }

  /// Gives its vectors back.
  void clear() {
    basis_.clear();
    directions_.clear();
  }

private:
  /// Improves the solution, given its residual in the first work vector.
  void cycle(KSP ksp) {
    Vec direction = ksp->work[0], product = ksp->work[1];
    Mat matrix = nullptr;
    petsc_check(PCGetOperators(ksp->pc, &matrix, nullptr));
    const std::size_t size = local_size(direction);
    double norm = 0.0;
    petsc_check(VecNorm(direction, NORM_2, &norm));
    const double first = norm;
    report(ksp, norm);
    if (ksp->reason) return;
    store_scaled(VecReading(direction).values(), 1.0 / norm, vector_of(basis_, 0, size));
    triangle_.clear();
    rotations_.clear();
    rotated_ = {norm};
    while (!ksp->reason && ksp->its < ksp->max_it && rotations_.size() < restart_ && norm > digits<Real> * first) {
      const std::size_t j = rotations_.size();
      load(basis_[j].get(), VecWriting(direction).values());
      petsc_check(PCApply(ksp->pc, direction, product));
      Real* kept = vector_of(directions_, j, size);
      {
        const VecWriting rounded(product);
        store_scaled(rounded.values(), 1.0, kept);
        load(kept, rounded.values());
      }
      petsc_check(MatMult(matrix, product, direction));
      rotate(orthogonalise(ksp, VecWriting(direction).values()));
      norm = std::abs(rotated_.back());
      ++ksp->its;
      report(ksp, norm);
    }
    if (!std::isfinite(norm)) return;
    const std::vector<double> parts = coefficients();
    add_combination(directions_, parts, VecWriting(ksp->vec_sol).values(), [](const double*, std::size_t) {});
  }

  static void report(KSP ksp, double norm) {
    ksp->rnorm = norm;
    petsc_check(KSPLogResidualHistory(ksp, norm));
    petsc_check(KSPMonitor(ksp, ksp->its, norm));
    petsc_check((*ksp->converged)(ksp, ksp->its, norm, &ksp->reason, ksp->cnvP));
  }

  /// Makes the next vector of the basis of a product; returns its column of the Hessenberg matrix.
  std::vector<double> orthogonalise(KSP ksp, std::span<double> product) {
    MPI_Comm comm = PetscObjectComm(reinterpret_cast<PetscObject>(ksp));
    const std::size_t count = rotations_.size() + 1;
    std::vector<double> column(count, 0.0);
    for (std::size_t begin = 0; begin < product.size(); begin += piece) {
      const std::size_t part = std::min(piece, product.size() - begin);
      for (std::size_t i = 0; i < count; ++i) column[i] += dot(basis_[i].get() + begin, product.data() + begin, part);
    }
    MPI_Allreduce(MPI_IN_PLACE, column.data(), static_cast<int>(count), MPI_DOUBLE, MPI_SUM, comm);
    std::vector<double> factors = column;
    for (double& factor : factors) factor = -factor;
    double square = 0.0;
    add_combination(basis_, factors, product,
                    [&](const double* values, std::size_t part) { square += dot(values, values, part); });
    MPI_Allreduce(MPI_IN_PLACE, &square, 1, MPI_DOUBLE, MPI_SUM, comm);
    const double norm = std::sqrt(square);
    store_scaled(product, norm > 0.0 ? 1.0 / norm : 0.0, vector_of(basis_, count, product.size()));
    column.push_back(norm);
    return column;
  }

  /// Takes a column of the Hessenberg matrix into the triangle that rotations make of it.
  void rotate(std::vector<double> column) {
    for (std::size_t i = 0; i < rotations_.size(); ++i) turn(rotations_[i], column[i], column[i + 1]);
    const std::size_t last = rotations_.size();
    const double length = std::hypot(column[last], column[last + 1]);
    rotations_.push_back({length > 0.0 ? column[last] / length : 1.0, length > 0.0 ? column[last + 1] / length : 0.0});
    turn(rotations_.back(), column[last], column[last + 1]);
    rotated_.push_back(0.0);
    turn(rotations_.back(), rotated_[last], rotated_[last + 1]);
    triangle_.push_back(std::move(column));
  }

  struct Rotation {
    double cosine, sine;
  };
  static void turn(const Rotation& by, double& a, double& b) {
    const double turned = by.cosine * a + by.sine * b;
    b = by.cosine * b - by.sine * a;
    a = turned;
  }

  /// What the solution has of each direction.
  std::vector<double> coefficients() const {
    std::vector<double> parts(rotated_.begin(), rotated_.end() - 1);
    for (std::size_t i = parts.size(); i-- > 0;) {
      for (std::size_t j = i + 1; j < parts.size(); ++j) parts[i] -= triangle_[j][i] * parts[j];
      parts[i] = triangle_[i][i] != 0.0 ? parts[i] / triangle_[i][i] : 0.0;
    }
    return parts;
  }

  std::size_t restart_;
  Basis<Real> basis_, directions_;             ///< v_j and z_j, own parts
  std::vector<std::vector<double>> triangle_;  ///< by column
  std::vector<Rotation> rotations_;
  std::vector<double> rotated_;  ///< right side of the triangle; what is left comes last
};

struct CompactFgmres {
  CompactFgmres(int restart, std::function<bool()> serves)
      : single(restart), whole(restart), single_serves(std::move(serves)) {}

  void solve(KSP ksp) {
    if (single_serves()) {
      whole.clear();
      single.solve(ksp);
    } else {
      single.clear();
      whole.solve(ksp);
    }
  }

  Fgmres<float> single;
  Fgmres<double> whole;
  std::function<bool()> single_serves;
};

PetscErrorCode create(KSP ksp) {
  ksp->ops->setup = [](KSP own) -> PetscErrorCode { return KSPSetWorkVecs(own, 2); };
  ksp->ops->solve = [](KSP own) -> PetscErrorCode {
    return petsc_callback([&] { static_cast<CompactFgmres*>(own->data)->solve(own); });
  };
  ksp->ops->destroy = [](KSP own) -> PetscErrorCode {
    delete static_cast<CompactFgmres*>(own->data);
    own->data = nullptr;
    return PETSC_SUCCESS;
  };
  ksp->ops->buildsolution = KSPBuildSolutionDefault;
  ksp->ops->buildresidual = KSPBuildResidualDefault;
  return KSPSetSupportedNorm(ksp, KSP_NORM_UNPRECONDITIONED, PC_RIGHT, 3);
}

}  // namespace

void use_compact_fgmres(KSP ksp, int restart, std::function<bool()> single_serves) {
  constexpr const char* name = "compact_fgmres";
  petsc_check(KSPRegister(name, create));
  petsc_check(KSPSetType(ksp, name));
  delete static_cast<CompactFgmres*>(std::exchange(ksp->data, new CompactFgmres(restart, std::move(single_serves))));
}

}  // namespace gearfilm
