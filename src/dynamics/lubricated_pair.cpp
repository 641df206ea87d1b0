#include "gearfilm/dynamics/lubricated_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gearfilm {

LubricatedPair::LubricatedPair(const ContactPath& path, std::vector<PairContact> contacts, double inertia,
                               const Scales& scales, const std::optional<LoadSharing::Piece>& share)
    : path_(path),
      contacts_(std::move(contacts)),
      grid_(contacts_.front().film->grid()),
      inertia_(inertia),
      static_force_(scales.static_force),
      approach_(scales.approach),
      sharing_(share),
      weight_(std::sqrt(static_cast<double>(contacts_.size()) * grid_.nx() * grid_.rows())),
      column_solution_(motion_at()),
      work_(field_size()) {}

OwnedVec LubricatedPair::create_state() const {
  OwnedVec state;
  petsc_check(VecCreateMPI(comm(), local_size(), PETSC_DETERMINE, state.put()));
  return state;
}

void LubricatedPair::set_field(Vec state, std::size_t contact, const std::vector<double>& field) const {
  const VecWriting values(state);
  std::copy(field.begin(), field.end(), values + contact * field_size());
}

std::vector<double> LubricatedPair::field(Vec state, std::size_t contact) const {
  const VecReading values(state);
  const double* first = values + contact * field_size();
  return {first, first + field_size()};
}

WorstNode LubricatedPair::worst_node(Vec rows, std::size_t contact) const {
  return gearfilm::worst_node(grid_, VecReading(rows) + contact * field_size());
}

void LubricatedPair::set_motion(Vec state, const Motion& motion) const {
  const VecWriting values(state);
  if (!has_motion()) return;
  values[motion_at()] = motion.H0;
  values[motion_at() + 1] = motion.V0;
}

Motion LubricatedPair::motion(Vec state) const {
  const VecReading values(state);
  return broadcast(values);
}

Motion LubricatedPair::broadcast(const double* values) const {
  std::array<double, 2> motion{};
  if (has_motion()) motion = {values[motion_at()], values[motion_at() + 1]};
  if (grid_.processes() > 1) MPI_Bcast(motion.data(), 2, MPI_DOUBLE, 0, comm());
  return {motion[0], motion[1]};
}

Motion LubricatedPair::unweighted(const Motion& rows) const {
  return {rows.H0 / weight_, rows.V0 / weight_ * static_force_};
}

void LubricatedPair::restrain(Vec guess, Vec last) const {
  const VecReading before(last);
  const VecWriting values(guess);
  for (std::size_t n = 0; n < motion_at(); ++n) values[n] = std::max({values[n], 0.5 * before[n], 0.0});
}

void LubricatedPair::follow_share(Vec state, double T0, double T1) const {
  if (inertia_ > 0.0 || !sharing_) return;
  const auto approach_at = [&](double T) {
    const double share = (*sharing_)(path_.position(contacts_.front().contact, T));
    return approach_ * std::cbrt(share * share);
  };
  const double sinking = approach_at(T1) - approach_at(T0);
  set_motion(state, {motion(state).H0 - sinking, -sinking / (T1 - T0)});
}

void LubricatedPair::place(double T) {
  for (const PairContact& contact : contacts_) contact.film->set_conditions(path_.conditions(contact.contact, T));
  if (sharing_) share_ = (*sharing_)(path_.position(contacts_.front().contact, T));
}

void LubricatedPair::residual(Vec state, Vec rate, double shift, Vec rows) {
  const VecReading in(state), rates(rate);
  const VecWriting out(rows);
  const Motion motion = broadcast(in);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const std::size_t at = k * field_size();
    contacts_[k].film->residual(in + at, motion.H0, {rates + at, shift}, out + at);
  }
  const double carried = carried_by(in);
  if (!has_motion()) return;
  const std::size_t at = motion_at();
  out[at] = weight_ * (rates[at] - motion.V0);
  out[at + 1] = weight_ / static_force_ * (inertia_ * rates[at + 1] - carried / share_ + static_force_);
}

void LubricatedPair::storage(Vec state, Vec stored) {
  const VecReading in(state);
  const VecWriting out(stored);
  const Motion motion = broadcast(in);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    contacts_[k].film->storage(in + k * field_size(), motion.H0, out + k * field_size());
  }
  if (has_motion()) std::copy_n(in + motion_at(), 2, out + motion_at());
}

void LubricatedPair::linearise(double shift, Elimination elimination) {
  shift_ = shift;
  elimination_ = inertia_ > 0.0 ? elimination : Elimination::exact;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    contacts_[k].film->linearise(shift);
    if (elimination_ == Elimination::motion_first) continue;
    contacts_[k].film->precondition(contacts_[k].film->film_shift().data(), column_solution_.data() + k * field_size());
  }
  stiffness_ = elimination_ == Elimination::exact ? carried_by(column_solution_.data()) / share_ : 0.0;
}

void LubricatedPair::multiply_storage(Vec change, Vec rows) {
  const VecReading in(change);
  const VecWriting out(rows);
  const Motion motion = broadcast(in);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    contacts_[k].film->multiply_storage(in + k * field_size(), motion.H0, out + k * field_size());
  }
  if (!has_motion()) return;
  out[motion_at()] = weight_ * motion.H0;
  out[motion_at() + 1] = weight_ / static_force_ * inertia_ * motion.V0;
}

void LubricatedPair::multiply(Vec change, Vec rows) {
  const VecReading in(change);
  const VecWriting out(rows);
  const Motion motion = broadcast(in);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    contacts_[k].film->multiply(in + k * field_size(), motion.H0, out + k * field_size());
  }
  const double carried = carried_by(in);
  if (!has_motion()) return;
  const std::size_t at = motion_at();
  out[at] = weight_ * (shift_ * motion.H0 - motion.V0);
  out[at + 1] = weight_ / static_force_ * (inertia_ * shift_ * motion.V0 - carried / share_);
}

void LubricatedPair::precondition(Vec rows, Vec change) {
  if (elimination_ == Elimination::exact) {
    precondition_exactly(rows, change);
  } else {
    precondition_motion_first(rows, change);
  }
}

// Without the contacts' reaction, shift H0 - V0 = r_H and I_n shift V0 = r_V.
void LubricatedPair::precondition_motion_first(Vec rows, Vec change) {
  const VecReading in(rows);
  const VecWriting out(change);
  const Motion residual = unweighted(broadcast(in));
  const double V0 = residual.V0 / (inertia_ * shift_);
  const double H0 = (residual.H0 + V0) / shift_;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const double* film_rows = in + k * field_size();
    const double* column = contacts_[k].film->film_shift().data();
    for (std::size_t n = 0; n < field_size(); ++n) work_[n] = film_rows[n] - H0 * column[n];
    contacts_[k].film->precondition(work_.data(), out + k * field_size());
  }
  if (!has_motion()) return;
  out[motion_at()] = H0;
  out[motion_at() + 1] = V0;
}

// With z = M^-1 r and y = M^-1 dG/dH_0 of the films: v = z - y H0, V0 = shift H0 - r_H, and the equation of motion,
// I_n shift V0 - Int z/f + H0 Int y/f = r_V, gives H0.
void LubricatedPair::precondition_exactly(Vec rows, Vec change) {
  const VecReading in(rows);
  const VecWriting out(change);
  const Motion residual = unweighted(broadcast(in));
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    contacts_[k].film->precondition(in + k * field_size(), out + k * field_size());
  }
  const double H0 = (residual.V0 + inertia_ * shift_ * residual.H0 + carried_by(out) / share_) /
                    (inertia_ * shift_ * shift_ + stiffness_);
  for (std::size_t n = 0; n < motion_at(); ++n) out[n] -= H0 * column_solution_[n];
  if (!has_motion()) return;
  out[motion_at()] = H0;
  out[motion_at() + 1] = shift_ * H0 - residual.H0;
}

std::vector<ContactRecord> LubricatedPair::records(double T) const {
  std::vector<ContactRecord> records;
  for (const PairContact& contact : contacts_) {
    records.push_back(contact_record(path_, contact.film->scales(), contact.contact, T, contact.film->figures()));
  }
  return records;
}

}  // namespace gearfilm
