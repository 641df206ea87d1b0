#include "gearfilm/traction/film_flow.hpp"

#include <cmath>

#include "gearfilm/lubricant/vector_math.hpp"

namespace gearfilm {

OwnFlow::OwnFlow(const std::vector<double>& weights, const std::vector<double>& places)
    : weights_(weights), places_(places) {
  for (std::size_t k = 0; k < weights.size(); ++k) {
    second_moment_ += weights[k] * (places[k] - 0.5) * (places[k] - 0.5);
  }
  for (auto* field : {&heat, &diagonal, &column, &row, &poiseuille}) field->assign(weights.size(), Lanes{});
}

void OwnFlow::update(const Oil& oil, const Film& film) {
  const std::size_t count = weights_.size();
  Lanes mean{}, first{}, moment{}, log_mean{};
  for (std::size_t k = 0; k < count; ++k) {
    const double weight = weights_[k], place = places_[k];
    each_lane([&](int l) {
      mean[l] += weight * oil.fluidity[k][l];
      first[l] += weight * place * oil.fluidity[k][l];
      log_mean[l] += weight * oil.log_viscosity[k][l];
    });
  }
  each_lane([&](int l) { centre[l] = first[l] / mean[l]; });
  for (std::size_t k = 0; k < count; ++k) {
    const double weight = weights_[k], place = places_[k];
    each_lane([&](int l) { moment[l] += weight * (place - centre[l]) * (place - centre[l]) * oil.fluidity[k][l]; });
  }
  // G h/eta_0, the same with F as it is; and of the parabola.
  Lanes gradient, inwards, parabola;
  each_lane([&](int l) {
    log_factor[l] = log(moment[l] / second_moment_) + film.log_viscosity[l];
    inwards[l] = film.poiseuille_flow[l] < 0.0 ? film.wet[l] : 0.0;
    gradient[l] = -inwards[l] * film.poiseuille_flow[l] / (film.thickness[l] * moment[l]);
    const double forwards = film.poiseuille_flow[l] / (film.thickness[l] * second_moment_);
    parabola[l] = (film.wet[l] - inwards[l]) * film.ambient_viscosity * exp(log_mean[l]) * forwards * forwards /
                  film.shear_factor[l];
  });
  const double exact = 12.0 * second_moment_;  // so that their mean is 12 eta q_P^2/(F h^4) on any points
  Lanes driven{}, passed{};
  for (std::size_t k = 0; k < count; ++k) {
    const double weight = weights_[k], place = places_[k], bent = (place - 0.5) * (place - 0.5);
    const double previous_weight = k > 0 ? 0.5 / static_cast<double>(count - 1) : 0.0;
    const std::size_t before = k > 0 ? k - 1 : 0;
    each_lane([&](int l) {
      const double arm = place - centre[l], own = inwards[l];
      const double drive = arm * oil.fluidity[k][l],
                   drive_before = (places_[before] - centre[l]) * oil.fluidity[before][l];
      driven[l] += previous_weight * (drive + drive_before);
      poiseuille[k][l] = driven[l];
      passed[l] += weight * driven[l];
      const double own_heat = exact * film.ambient_viscosity * gradient[l] * gradient[l] * arm * arm *
                              oil.fluidity[k][l] / film.shear_factor[l];
      const double cross =
          gradient[l] * arm *
          (std::copysign(film.stress[l], film.sliding) * oil.fluidity[k][l] +
           film.ambient_viscosity * film.sliding * oil.share[k][l] / (film.thickness[l] * film.shear_factor[l]));
      const double thrown = exact * bent * parabola[l];
      heat[k][l] = own_heat + cross + thrown;
      diagonal[k][l] = own_heat * oil.slope[k][l];
      column[k][l] = -(2.0 * own_heat + thrown);
      row[k][l] =
          weight * oil.slope[k][l] * (own * arm * arm * oil.fluidity[k][l] / moment[l] + (1.0 - own) * film.wet[l]);
    });
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double place = places_[k], bent = 6.0 * place * (1.0 - place);
    each_lane([&](int l) {
      const double own = inwards[l] * poiseuille[k][l] / (passed[l] != 0.0 ? passed[l] : 1.0);
      poiseuille[k][l] = film.wet[l] * film.poiseuille_flow[l] * (own + (1.0 - inwards[l]) * bent);
    });
  }
}

}  // namespace gearfilm
