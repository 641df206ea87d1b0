#include "orbits/train_on_films.hpp"

#include "gearfilm/error.hpp"

namespace gearfilm {

std::vector<std::optional<std::complex<double>>> train_on_films(const DampedTrain& train, LubricatedPair& pair,
                                                                Vec state, const SwingOptions& options,
                                                                const std::function<void(const std::string&)>& lost) {
  const MeshModel& mesh = pair.mesh();
  pair.place(0.0);
  DynamicStiffness films(pair, state, options);
  const DynamicContact contact = [&](std::complex<double> s, double tolerance) {
    return mesh.compliance_scale() * films.at(s * mesh.scales.time, tolerance);
  };
  std::vector<std::optional<std::complex<double>>> rates;
  for (const TrainMode& mode : train.modes) {
    try {
      rates.emplace_back(contact_mode(train, mode, contact,
                                      {.tolerance = options.tolerance,
                                       .max_iterations = options.max_iterations,
                                       .tightest = options.krylov_tolerance}));
    } catch (const SolveError& error) {
      rates.emplace_back();
      lost(error.what());
    }
  }
  return rates;
}

}  // namespace gearfilm
