#include "dynamics/periodic_predictor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>

#include "dynamics/miss_code.hpp"
#include "dynamics/packed_integers.hpp"

namespace gearfilm {
namespace {

constexpr int places = 1'000'000;        // in a mesh period, that are told apart
constexpr double helpful = 0.5;          // of the square of a miss, what may be left of it
constexpr double oldest = 1.5;           // mesh periods
constexpr double between_sweeps = 0.1;   // mesh periods marched from one removal of old errors to the next
constexpr double most_pressures = 32e6;  // on all processes

int place_of(const MeshModel& mesh, double T) {
  const double periods = mesh.path.mesh_periods(T);
  return static_cast<int>(std::lround((periods - std::floor(periods)) * places)) % places;
}

double nodes_of(const Grid& grid) { return 1.0 * grid.nx() * grid.rows(); }

std::span<const double> pressures_of(const LubricatedPair& pair, const VecReading& state) {
  return state.values().first(static_cast<std::size_t>(pair.system().pressure_count()));
}

/// Values that so many bytes take, bit by bit.
std::size_t values_for(std::size_t bytes) { return (bytes + sizeof(double) - 1) / sizeof(double); }

}  // namespace

PeriodicPredictor::PeriodicPredictor(ValueReader values)
    : shape_(values.shape()), marched_(values.value()), trusted_(values.value() > 0.0) {
  while (!values.at_end()) {
    PredictorError& miss = errors_[static_cast<int>(values.value())];
    miss.recorded_at = values.value();
    miss.motion = values.motion();
    miss.largest = values.value();
    miss.count = values.count();
    miss.pressures.resize(values.count());
    std::memcpy(miss.pressures.data(), values.values(values_for(miss.pressures.size())).data(), miss.pressures.size());
  }
}

void PeriodicPredictor::append_to(std::vector<double>& values) const {
  append(values, shape_);
  // All at once: a list that grows takes up to three times as much while it does.
  std::size_t more = 2;
  for (const auto& [place, miss] : errors_)
    more += 6 + 2 * static_cast<std::size_t>(miss.motion.freedoms()) + values_for(miss.pressures.size());
  values.reserve(values.size() + more);
  values.insert(values.end(), {marched_, trusted_ ? 1.0 : 0.0});
  for (const auto& [place, miss] : errors_) {
    values.insert(values.end(), {static_cast<double>(place), miss.recorded_at});
    append(values, miss.motion);
    const std::size_t bytes = miss.pressures.size();
    values.insert(values.end(), {miss.largest, static_cast<double>(miss.count), static_cast<double>(bytes)});
    const std::size_t begin = values.size();
    values.resize(begin + values_for(bytes));
    std::memcpy(values.data() + begin, miss.pressures.data(), bytes);
  }
}

bool PeriodicPredictor::is_old(const PredictorError& error) const { return error.recorded_at < marched_ - oldest; }

const PeriodicPredictor::PredictorError* PeriodicPredictor::last_time(const MeshModel& mesh, double T,
                                                                      std::size_t pressures) const {
  const auto found = errors_.find(place_of(mesh, T));
  if (found == errors_.end() || found->second.count != pressures || is_old(found->second)) return nullptr;
  return &found->second;
}

void PeriodicPredictor::correct(const LubricatedPair& pair, Vec guess, double T) {
  const GridShape& shape = pair.system().grid().shape();
  if (shape != shape_) errors_.clear();
  shape_ = shape;
  guessed_at_ = T;
  guessed_motion_ = pair.motion(guess);
  {
    const VecReading values(guess);
    const std::span<const double> pressures = pressures_of(pair, values);
    guessed_.assign(pressures.begin(), pressures.end());
  }
  const PredictorError* miss = trusted_ ? last_time(pair.mesh(), T, guessed_.size()) : nullptr;
  if (!miss) return;
  {
    const MissCode code(nodes_of(pair.system().grid()));
    const std::vector<std::int16_t> missed = unpacked(miss->pressures, miss->count);
    const VecWriting values(guess);
    for (std::size_t n = 0; n < guessed_.size(); ++n)
      values[n] = std::max(0.0, guessed_[n] + miss->largest * code.decoded(missed[n]));
  }
  pair.set_motion(guess, moved(guessed_motion_, 1.0, miss->motion));
}

void PeriodicPredictor::record(const LubricatedPair& pair, Vec solved, double T0, double T) {
  const MeshModel& mesh = pair.mesh();
  const double before_step = marched_;
  marched_ += mesh.path.mesh_periods(T) - mesh.path.mesh_periods(T0);
  if (std::floor(marched_ / between_sweeps) > std::floor(before_step / between_sweeps))
    std::erase_if(errors_, [this](const auto& entry) { return is_old(entry.second); });
  if (guessed_.empty() || guessed_at_ != T) return;
  std::vector<double> missed;
  std::swap(missed, guessed_);
  const double nodes = nodes_of(pair.system().grid());
  const MissCode code(nodes);
  const VecReading values(solved);
  std::ranges::transform(pressures_of(pair, values), missed, missed.begin(), std::minus());

  const auto square = [](double value) { return value * value; };
  std::array<double, 2> squares = {0.0, 0.0};
  const PredictorError* before = last_time(mesh, T, missed.size());
  if (before) {
    const std::vector<std::int16_t> last = unpacked(before->pressures, before->count);
    squares = {std::transform_reduce(missed.begin(), missed.end(), 0.0, std::plus(), square),
               std::transform_reduce(
                   missed.begin(), missed.end(), last.begin(), 0.0, std::plus(),
                   [&](double now, std::int16_t then) { return square(now - before->largest * code.decoded(then)); })};
  }
  MPI_Allreduce(MPI_IN_PLACE, squares.data(), 2, MPI_DOUBLE, MPI_SUM, pair.system().comm());
  trusted_ = squares[1] < helpful * squares[0];

  const double pressures = nodes * static_cast<double>(pair.numbers().size());
  if (!before && static_cast<double>(errors_.size() + 1) * pressures > most_pressures) return;
  // The largest of all processes: any number of them makes the same guesses.
  double largest = std::transform_reduce(
      missed.begin(), missed.end(), 0.0, [](double a, double b) { return std::max(a, b); },
      [](double value) { return std::abs(value); });
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, pair.system().comm());
  std::vector<std::int16_t> codes(missed.size());
  if (largest > 0.0) {
    std::ranges::transform(missed, codes.begin(),
                           [&code, inverse = 1.0 / largest](double value) { return code.encoded(value * inverse); });
  }
  errors_[place_of(mesh, T)] = {marched_, difference(pair.motion(solved), guessed_motion_), largest, missed.size(),
                                packed(codes)};
}

}  // namespace gearfilm
