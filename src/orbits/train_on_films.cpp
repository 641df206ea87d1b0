#include "orbits/train_on_films.hpp"

#include "gearfilm/error.hpp"

namespace gearfilm {

std::vector<RateOnFilms> train_on_films(const DampedTrain& train, LubricatedPair& pair, Vec state,
                                        const SwingOptions& options,
                                        const std::function<void(const std::string&)>& lost) {
  const MeshModel& mesh = pair.mesh();
  pair.place(0.0);
  DynamicStiffness films(pair, state, options);
  const DynamicContact contact = [&](std::complex<double> s, double tolerance) {
    return mesh.compliance_scale() * films.at(s * mesh.scales.time, tolerance);
  };
  std::vector<RateOnFilms> rates;
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

std::vector<std::optional<SwingQuantities>> quantities_of(const DampedTrain& train, const RatesOnGrids& rates,
                                                          const FilmSwing& swing, const Scales& scales) {
  std::vector<std::optional<SwingQuantities>> modes;
  for (std::size_t n = 0; n < train.modes.size(); ++n) {
    const TrainMode& mode = train.modes[n];
    modes.emplace_back();
    if (!rates.fine[n]) continue;
    modes.back() = quantities_of(swing, scales,
                                 {.rate = *rates.fine[n],
                                  .coarser = rates.coarser.empty() ? RateOnFilms() : rates.coarser[n],
                                  .share = mode.mesh_share,
                                  .damping_without_films = train.damping_ratio(mode)});
  }
  return modes;
}

}  // namespace gearfilm
