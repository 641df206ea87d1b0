#include "solver/film_system.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <set>
#include <stdexcept>

#include "contact/moes.hpp"
#include "numerics/tuned.hpp"

namespace gearfilm {
namespace {

/// The local part of a rate, empty where nothing moves.
class RateReading {
public:
  explicit RateReading(const FilmSystem::Rate& rate) {
    if (rate.values) vec_.emplace(rate.values);
  }
  std::span<const double> values() const { return vec_ ? vec_->values() : std::span<const double>(); }

private:
  std::optional<VecReading> vec_;
};

const Tuned<double> largest_rise("newton_largest_rise", 0.1, "largest rise of a pressure in an iteration");
const Tuned<double> largest_fall("newton_largest_fall", 0.9, "largest fall of a pressure in an iteration, relative");
const Tuned<double> fall_of_stiff_oil("newton_fall_of_stiff_oil", 0.4, "the same where oil stiffens much");

/// Smaller where oil stiffens much under pressure: where full film comes and goes over a whole inlet, its viscosity
/// would change by factors from one iteration to the next.
PressureLimits pressure_limits_in(const Scales& scales) {
  constexpr double stiffening = 8.0;  // Moes' L from which on falls are smaller
  const double L = moes_groups(scales.solids, scales.oil, scales.operation).L;
  if (L <= 0.0) return {largest_rise, largest_fall};
  return {std::min<double>(largest_rise, 1.0 / L),
          std::min<double>(largest_fall, std::max<double>(fall_of_stiff_oil, largest_fall * stiffening / L))};
}

}  // namespace

FilmSystem::FilmSystem(std::vector<ContactFilm*> films, BodyEquations bodies)
    : films_(std::move(films)),
      bodies_(std::move(bodies)),
      grid_(films_.front()->grid()),
      weight_(std::sqrt(static_cast<double>(films_.size()) * grid_.nx() * grid_.rows())),
      limits_(pressure_limits_in(films_.front()->scales())) {
  if (std::set(films_.begin(), films_.end()).size() != films_.size()) {
    throw std::logic_error("a film stands twice in a system, where it would have to show two states at once");
  }
}

void FilmSystem::set_bodies(BodyEquations bodies, Compliance compliance, ReverseFlankForce reverse_flanks) {
  bodies_ = std::move(bodies);
  compliance_ = std::move(compliance);
  reverse_flanks_ = std::move(reverse_flanks);
}

PetscInt FilmSystem::local_size() const {
  return static_cast<PetscInt>(scalars_at() + (has_scalars() ? bodies_.size() : 0));
}

OwnedVec FilmSystem::create_state() const {
  OwnedVec state;
  petsc_check(VecCreateMPI(comm(), local_size(), PETSC_DETERMINE, state.put()));
  return state;
}

void FilmSystem::set_field(Vec state, std::size_t contact, std::span<const double> field) const {
  const VecWriting values(state);
  std::ranges::copy(field, part(values.values(), contact).begin());
}

std::vector<double> FilmSystem::field(Vec state, std::size_t contact) const {
  const VecReading values(state);
  const auto own = part(values.values(), contact);
  return {own.begin(), own.end()};
}

void FilmSystem::set_scalars(Vec state, std::span<const double> scalars) const {
  const VecWriting values(state);
  if (has_scalars()) std::ranges::copy(scalars, values.values().subspan(scalars_at()).begin());
}

std::vector<double> FilmSystem::scalars(Vec state) const {
  const Eigen::VectorXd scalars = scalars_in(VecReading(state).values());
  return {scalars.begin(), scalars.end()};
}

Eigen::VectorXd FilmSystem::scalars_in(std::span<const double> values) const {
  Eigen::VectorXd scalars(bodies_.size());
  if (has_scalars()) std::ranges::copy(values.subspan(scalars_at()), scalars.begin());
  if (grid_.processes() > 1) {
    MPI_Bcast(scalars.data(), static_cast<int>(scalars.size()), MPI_DOUBLE, 0, comm());
  }
  return scalars;
}

void FilmSystem::put_scalars(const Eigen::VectorXd& scalars, std::span<double> values) const {
  if (has_scalars()) std::ranges::copy(scalars, values.subspan(scalars_at()).begin());
}

Eigen::VectorXd FilmSystem::forces(std::span<const double> values) const {
  const std::vector<double> sums = integrals(grid_, values.first(scalars_at()), films_.size());
  return Eigen::Map<const Eigen::VectorXd>(sums.data(), static_cast<Eigen::Index>(sums.size()));
}

// Extrapolated by a polynomial, what has fallen as a square would rise again behind an edge that has passed.
void FilmSystem::extrapolate_falls(Vec guess, std::span<const double> weights,
                                   const std::function<Vec(std::size_t)>& state) const {
  if (weights.size() < 2) return;
  std::deque<VecReading> states;
  for (std::size_t k = 0; k < weights.size(); ++k) states.emplace_back(state(k));
  const VecWriting values(guess);
  for (std::size_t n = 0; n < scalars_at(); ++n) {
    const double last = states[0][n];
    const bool falls = last <= 0.0 ? values[n] != 0.0 : last < states[1][n];
    if (!falls || !films_[n / field_size()]->conducts_freely(n % field_size())) continue;
    double root = 0.0;
    for (std::size_t k = 0; k < weights.size() && last > 0.0; ++k) {
      root += weights[k] * std::sqrt(std::max(0.0, states[k][n]));
    }
    values[n] = root > 0.0 ? root * root : 0.0;
  }
}

// Half of what is small would keep nodes full that a film's edge leaves.
void FilmSystem::clip_predictor(Vec guess, Vec last) const {
  constexpr double may_vanish = 0.003, left_at_least = 0.5;
  const VecReading before(last);
  const VecWriting values(guess);
  for (std::size_t n = 0; n < scalars_at(); ++n) {
    const double least = before[n] < may_vanish ? 0.0 : left_at_least * before[n];
    values[n] = std::max(values[n], least);
  }
}

Squeeze FilmSystem::squeeze(std::span<const double> rates, std::size_t contact, double shift) const {
  return {rates.empty() ? rates : part(rates, contact), shift};
}

Eigen::VectorXd FilmSystem::displacements(std::span<const double> values, const Eigen::VectorXd& scalars) const {
  Eigen::VectorXd rigid_part = bodies_.displacement * scalars;
  if (compliance_.rigid()) return rigid_part;
  return compliance_.displacements(rigid_part, forces(values));
}

Eigen::VectorXd FilmSystem::displacements(Vec state) const {
  const VecReading in(state);
  return displacements(in.values(), scalars_in(in.values()));
}

void FilmSystem::evaluate(std::span<const double> values, const Eigen::VectorXd& displaced, StateVersion version) {
  std::vector<ContactFilm::At> places;
  for (std::size_t k = 0; k < films(); ++k) places.push_back({films_[k], part(values, k), displaced[k]});
  ContactFilm::evaluate_together(places, version);
}

void FilmSystem::residual(Vec state, const Rate& rate, Vec rows) {
  const StateVersion version = versions_.of(state);
  const RateReading rates(rate);
  const VecReading in(state);
  const VecWriting out(rows);
  const Eigen::VectorXd scalars = scalars_in(in.values()), carried = forces(in.values());
  const Eigen::VectorXd displaced = compliance_.displacements(bodies_.displacement * scalars, carried);
  evaluate(in.values(), displaced, version);
  for (std::size_t k = 0; k < films(); ++k) {
    films_[k]->residual(part(in.values(), k), displaced[k], squeeze(rates.values(), k, rate.shift),
                        part(out.values(), k), version);
  }
  if (!has_scalars()) return;
  Eigen::VectorXd scalar_rates = Eigen::VectorXd::Zero(bodies_.size());
  if (rate.values) std::ranges::copy(rates.values().subspan(scalars_at()), scalar_rates.begin());
  put_scalars(weight_ * (bodies_.rows(scalars, scalar_rates, carried) + reverse_flanks_.rows(scalars)), out.values());
}

void FilmSystem::transient(Vec state, Vec values) {
  const StateVersion version = versions_.of(state);
  const VecReading in(state);
  const VecWriting out(values);
  const Eigen::VectorXd scalars = scalars_in(in.values()), displaced = displacements(in.values(), scalars);
  evaluate(in.values(), displaced, version);
  for (std::size_t k = 0; k < films(); ++k) {
    films_[k]->mass(part(in.values(), k), displaced[k], part(out.values(), k), version);
  }
  put_scalars(scalars, out.values());
}

void FilmSystem::linearise(Vec state, const Rate& rate, double shift, BlockElimination elimination,
                           SmootherFactors factors) {
  const StateVersion version = versions_.of(state);
  shift_ = shift;
  preconditionings_ = 0;
  elimination_ = compliance_.rigid() ? elimination : BlockElimination::exact;
  const RateReading rates(rate);
  const VecReading in(state);
  const Eigen::VectorXd scalars = scalars_in(in.values()), displaced = displacements(in.values(), scalars);
  reverse_jacobian_ = reverse_flanks_.jacobian(scalars);
  coupled_stiffness_.setZero(static_cast<Eigen::Index>(films()), bodies_.size());
  for (std::size_t k = 0; k < films(); ++k) {
    films_[k]->linearise(part(in.values(), k), displaced[k], squeeze(rates.values(), k, rate.shift), shift, version,
                         factors);
  }
  if (elimination_ == BlockElimination::exact) {
    responses_.resize(scalars_at());
    for (std::size_t k = 0; k < films(); ++k) {
      films_[k]->precondition_displacement(part(std::span(responses_), k));
    }
    const Eigen::VectorXd stiffness = forces(responses_);
    coupling_factors_ = LuFactors(compliance_.coupling_matrix(stiffness));
    coupled_stiffness_ = coupling_factors_.solve_columns(stiffness.asDiagonal() * bodies_.displacement);
  }
  body_factors_ = LuFactors(bodies_.jacobian(shift, coupled_stiffness_) + reverse_jacobian_);
}

double FilmSystem::merit(Vec rows) {
  const VecReading in(rows);
  double sum = 0.0;
  for (std::size_t k = 0; k < films(); ++k) sum += films_[k]->merit(part(in.values(), k));
  for (std::size_t n = scalars_at(); n < in.values().size(); ++n) sum += in[n] * in[n];
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, comm());
  return std::sqrt(sum);
}

void FilmSystem::project_change(Vec state, Vec change) {
  const VecReading pressures(state);
  const VecWriting changes(change);
  for (std::size_t k = 0; k < films(); ++k) {
    films_[k]->project_change(part(pressures.values(), k), part(changes.values(), k));
  }
}

bool FilmSystem::relax_overshot_nodes(Vec change, Vec whole, Vec before, Vec after) {
  const VecReading first(whole), rows_before(before), rows_after(after);
  const VecWriting own(change);
  int relaxed = 0;
  for (std::size_t k = 0; k < films(); ++k) {
    relaxed |= films_[k]->relax_overshot_nodes(part(own.values(), k), part(first.values(), k),
                                               part(rows_before.values(), k), part(rows_after.values(), k));
  }
  MPI_Allreduce(MPI_IN_PLACE, &relaxed, 1, MPI_INT, MPI_LOR, comm());
  return relaxed != 0;
}

double FilmSystem::moved() {
  if (!films_.front()->scales().solids.rough) return 0.0;
  double moved = 0.0;
  for (const ContactFilm* film : films_) moved = std::max(moved, film->gap_moved());
  MPI_Allreduce(MPI_IN_PLACE, &moved, 1, MPI_DOUBLE, MPI_MAX, comm());
  return moved;
}

bool FilmSystem::in_single_precision() const { return std::ranges::all_of(films_, &ContactFilm::in_single_precision); }

void FilmSystem::multiply(Vec change, Vec rows) {
  const VecReading in(change);
  const VecWriting out(rows);
  const Eigen::VectorXd scalars = scalars_in(in.values()), carried = forces(in.values());
  const Eigen::VectorXd displaced = compliance_.displacements(bodies_.displacement * scalars, carried);
  std::vector<ContactFilm::Product> products;
  for (std::size_t k = 0; k < films(); ++k) {
    products.push_back({films_[k], part(in.values(), k), displaced[k], part(out.values(), k)});
  }
  ContactFilm::multiply_together(products);
  put_scalars(weight_ * (bodies_.rows_of_change(scalars, shift_ * scalars, carried) + reverse_jacobian_ * scalars),
              out.values());
}

void FilmSystem::multiply_transient(Vec change, Vec rows) {
  const VecReading in(change);
  const VecWriting out(rows);
  const Eigen::VectorXd scalars = scalars_in(in.values()), displaced = displacements(in.values(), scalars);
  for (std::size_t k = 0; k < films(); ++k) {
    films_[k]->multiply_mass(part(in.values(), k), displaced[k], part(out.values(), k));
  }
  put_scalars(weight_ * (bodies_.mass * scalars), out.values());
}

void FilmSystem::precondition(Vec rows, Vec change) {
  const VecReading in(rows);
  const VecWriting out(change);
  ++preconditionings_;
  if (elimination_ == BlockElimination::exact) {
    precondition_exactly(in.values(), out.values());
  } else {
    precondition_scalars_first(in.values(), out.values());
  }
}

void FilmSystem::solve_film(std::size_t contact, std::span<const double> rows, std::span<double> change) {
  constexpr int patience = 20;
  if (preconditionings_ > patience && preconditionings_ % 2 == 0) {
    films_[contact]->relax(rows, change);
  } else {
    films_[contact]->precondition(rows, change);
  }
}

// s from the body equations as if no force changed, then v_k = M_k^-1 (r_k - H_k dG_k/dH_k).
void FilmSystem::precondition_scalars_first(std::span<const double> rows, std::span<double> change) {
  const Eigen::VectorXd scalars = body_factors_.solve(scalars_in(rows) / weight_);
  const Eigen::VectorXd displaced = bodies_.displacement * scalars;
  work_.resize(field_size());
  for (std::size_t k = 0; k < films(); ++k) {
    const auto film_rows = part(rows, k);
    const auto column = films_[k]->displacement_column();
    for (std::size_t n = 0; n < field_size(); ++n) work_[n] = film_rows[n] - displaced[k] * column[n];
    solve_film(k, work_, part(change, k));
  }
  put_scalars(scalars, change);
}

// With z = M^-1 r and y = M^-1 dG/dH of the films v_k = z_k - y_k H_k: their forces follow from those of z with the
// stiffness S (compliance.hpp), F = (I + S C)^-1 (Z - S B s), and the body equations give s.
void FilmSystem::precondition_exactly(std::span<const double> rows, std::span<double> change) {
  for (std::size_t k = 0; k < films(); ++k) solve_film(k, part(rows, k), part(change, k));
  const Eigen::VectorXd at_rest = coupling_factors_.solve(forces(change));  // of s = 0
  const Eigen::VectorXd scalars = body_factors_.solve(scalars_in(rows) / weight_ + bodies_.force * at_rest);
  const Eigen::VectorXd displaced =
      compliance_.displacements(bodies_.displacement * scalars, at_rest - coupled_stiffness_ * scalars);
  for (std::size_t k = 0; k < films(); ++k) {
    const auto response = part(std::span(std::as_const(responses_)), k);
    const auto own = part(change, k);
    for (std::size_t n = 0; n < field_size(); ++n) own[n] -= displaced[k] * response[n];
  }
  put_scalars(scalars, change);
}

std::vector<FilmQuantities> FilmSystem::quantities(Vec state) {
  const StateVersion version = versions_.of(state);
  const VecReading in(state);
  const Eigen::VectorXd displaced = displacements(in.values(), scalars_in(in.values()));
  std::vector<FilmQuantities> quantities;
  for (std::size_t k = 0; k < films(); ++k) {
    quantities.push_back(films_[k]->quantities(part(in.values(), k), displaced[k], version));
  }
  return quantities;
}

WorstNode FilmSystem::worst_node(Vec rows, std::size_t contact) const {
  const VecReading values(rows);
  return gearfilm::worst_node(grid_, part(values.values(), contact));
}

}  // namespace gearfilm
