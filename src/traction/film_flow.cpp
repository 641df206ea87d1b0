#include "traction/film_flow.hpp"

#include <cmath>

#include "lubricant/vector_math.hpp"

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
  // Of heat and its derivative what is the same for all points; of it all, the parts of the film's own profile and of
  // the parabola.
  const double exact = 12.0 * second_moment_;  // so that their mean is 12 eta q_P^2/(F h^4) on any points
  Lanes inwards, own_scale, stress_scale, rate_scale, parabola_scale, own_row, parabola_row;
  each_lane([&](int l) {
    log_factor[l] = log(moment[l] / second_moment_) + film.log_viscosity[l];
    inwards[l] = film.poiseuille_flow[l] < 0.0 ? film.full_film[l] : 0.0;
    const double thinned = film.ambient_viscosity / film.shear_factor[l], inverse = 1.0 / moment[l];
    const double speed = film.poiseuille_flow[l] / film.thickness[l];
    const double gradient = -inwards[l] * speed * inverse;  // G h/eta_0
    const double forwards = speed / second_moment_;
    // Heat is the flow times p_x.
    const double work = film.poiseuille_flow[l] != 0.0 ? film.driven_flow[l] / film.poiseuille_flow[l] : 0.0;
    const double heating = exact * thinned * (work > 0.0 ? work : 0.0);
    own_scale[l] = heating * gradient * gradient;
    stress_scale[l] = gradient * (film.sliding[l] < 0.0 ? -film.stress[l] : film.stress[l]);
    rate_scale[l] = gradient * thinned * film.sliding[l] / film.thickness[l];
    parabola_scale[l] = heating * (film.full_film[l] - inwards[l]) * exp(log_mean[l]) * forwards * forwards;
    own_row[l] = inwards[l] * inverse;
    parabola_row[l] = (1.0 - inwards[l]) * film.full_film[l];
  });
  Lanes driven{}, passed{}, drive_before{};
  for (std::size_t k = 0; k < count; ++k) {
    const double weight = weights_[k], place = places_[k], bent = (place - 0.5) * (place - 0.5);
    const double previous_weight = k > 0 ? 0.5 / static_cast<double>(count - 1) : 0.0;
    each_lane([&](int l) {
      const double arm = place - centre[l], drive = arm * oil.fluidity[k][l], square = arm * drive;
      driven[l] += previous_weight * (drive + drive_before[l]);
      drive_before[l] = drive;
      poiseuille[k][l] = driven[l];
      passed[l] += weight * driven[l];
      const double own_heat = own_scale[l] * square, thrown = bent * parabola_scale[l];
      heat[k][l] = own_heat + stress_scale[l] * drive + rate_scale[l] * arm * oil.share[k][l] + thrown;
      diagonal[k][l] = own_heat * oil.slope[k][l];
      column[k][l] = -(2.0 * own_heat + thrown);
      row[k][l] = weight * oil.slope[k][l] * (own_row[l] * square + parabola_row[l]);
    });
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double place = places_[k], bent = 6.0 * place * (1.0 - place);
    each_lane([&](int l) {
      const double own = inwards[l] * poiseuille[k][l] / (passed[l] != 0.0 ? passed[l] : 1.0);
      poiseuille[k][l] = film.full_film[l] * film.poiseuille_flow[l] * (own + (1.0 - inwards[l]) * bent);
    });
  }
}

}  // namespace gearfilm
