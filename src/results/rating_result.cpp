#include "results/rating_result.hpp"

#include <algorithm>
#include <map>

#include "rating/pitting.hpp"
#include "rating/scuffing.hpp"

namespace gearfilm {

void RatingHistory::add(const StepRecord& record) {
  if (!mesh_.rating) return;
  while (!moments_.empty() && moments_.back().T > record.T) moments_.pop_back();
  for (const ContactRecord& contact : record.contacts) {
    const ContactQuantities& of = contact.quantities;
    moments_.push_back({record.T,
                        contact.number,
                        contact.position,
                        of["sigma_H"],
                        {of["sigma_F_pinion"], of["sigma_F_wheel"]},
                        of["lambda_GF"],
                        mesh_.scales.thickness * of["h_min"],
                        of["contact_temperature"],
                        of["flash_temperature"]});
  }
}

std::vector<RatingHistory::Moment> RatingHistory::between(double T_begin, double T_end) const {
  constexpr double round_off = 1e-9;
  std::vector<Moment> found;
  std::ranges::copy_if(moments_, std::back_inserter(found), [&](const Moment& moment) {
    return moment.T >= T_begin - round_off && moment.T <= T_end + round_off;
  });
  return found;
}

Summary RatingHistory::safeties(double T_begin, double T_end) const {
  const std::vector<Moment> moments = between(T_begin, T_end);
  if (moments.empty()) return nullptr;
  return {{"pitting", pitting(moments)}, {"root_pinion", root(moments, 0)}, {"root_wheel", root(moments, 1)},
          {"flash", flash(moments)},     {"integral", integral(moments)},   {"micropitting", micropitting(moments)}};
}

Summary RatingHistory::pitting(const std::vector<Moment>& moments) const {
  const RatingModel& rating = *mesh_.rating;
  const Moment& worst = *std::ranges::max_element(moments, {}, &Moment::contact_stress);
  const double torque = mesh_.tooth_force * rating.line.base_radius_pinion();
  const NominalContactStress nominal = nominal_contact_stress(rating.pair, torque);
  Summary found = {{"stress", worst.contact_stress},
                   {"xi", worst.xi},
                   {"nominal_stress", nominal.stress * std::max(nominal.pinion_factor, nominal.wheel_factor)},
                   {"limit", nullptr},
                   {"safety", nullptr}};
  if (!rating.limits.contact) return found;
  found["limit"] = rating.permissible_contact_stress();
  found["safety"] = rating.permissible_contact_stress() / worst.contact_stress;
  return found;
}

Summary RatingHistory::root(const std::vector<Moment>& moments, std::size_t gear) const {
  const RatingModel& rating = *mesh_.rating;
  if (!rating.roots) return nullptr;
  const auto of_gear = [gear](const Moment& moment) { return moment.root_stress[gear]; };
  const Moment& worst = *std::ranges::max_element(moments, {}, of_gear);
  const double limit = rating.permissible_root_stress(gear);
  return {{"stress", of_gear(worst)}, {"xi", worst.xi}, {"limit", limit}, {"safety", limit / of_gear(worst)}};
}

Summary RatingHistory::flash(const std::vector<Moment>& moments) const {
  if (!mesh_.traction) return nullptr;
  const RatingLimits& limits = mesh_.rating->limits;
  const Moment& worst = *std::ranges::max_element(moments, {}, &Moment::temperature);
  Summary found = {{"temperature", worst.temperature}, {"xi", worst.xi}, {"limit", nullptr}, {"safety", nullptr}};
  if (!limits.scuffing) return found;
  found["limit"] = *limits.scuffing;
  found["safety"] = flash_safety(*limits.scuffing, limits.oil_temperature, worst.temperature);
  return found;
}

// Over the path of contact, of which a period of the motion has every part equally often.
Summary RatingHistory::integral(const std::vector<Moment>& moments) const {
  if (!mesh_.traction) return nullptr;
  std::map<int, const Moment*> before;
  double sum = 0.0, way = 0.0;
  for (const Moment& moment : moments) {
    if (const auto last = before.find(moment.contact); last != before.end()) {
      const double step = moment.xi - last->second->xi;
      sum += 0.5 * step * (moment.flash + last->second->flash);
      way += step;
    }
    before[moment.contact] = &moment;
  }
  if (!(way > 0.0)) return nullptr;
  const RatingLimits& limits = mesh_.rating->limits;
  const double temperature = integral_temperature(mesh_.rating->bulk_temperature, sum / way);
  Summary found = {{"temperature", temperature}, {"mean_flash", sum / way}, {"limit", nullptr}, {"safety", nullptr}};
  if (!limits.integral) return found;
  found["limit"] = *limits.integral;
  found["safety"] = integral_safety(*limits.integral, temperature);
  return found;
}

Summary RatingHistory::micropitting(const std::vector<Moment>& moments) const {
  const RatingModel& rating = *mesh_.rating;
  if (!rating.mean_roughness) return nullptr;
  const Moment* worst = nullptr;
  double thinnest = HUGE_VAL;
  for (const Moment& moment : moments) {
    if (!(moment.film_ratio > 0.0)) continue;  // without a load
    if (!worst || moment.film_ratio < worst->film_ratio) worst = &moment;
    thinnest = std::min(thinnest, moment.smallest_film);
  }
  if (!worst) return nullptr;
  Summary found = {{"lambda_GF", worst->film_ratio},
                   {"xi", worst->xi},
                   {"lambda_film", thinnest / *rating.mean_roughness},
                   {"limit", nullptr},
                   {"safety", nullptr}};
  if (!rating.limits.film_ratio) return found;
  found["limit"] = *rating.limits.film_ratio;
  found["safety"] = worst->film_ratio / *rating.limits.film_ratio;
  return found;
}

Summary safeties_at_rest(const MeshModel& mesh, const ContactRecord& contact) {
  RatingHistory moment(mesh);
  StepRecord record;
  record.contacts = {contact};
  moment.add(record);
  return moment.safeties(0.0, 0.0);
}

std::string rating_markdown() {
  return "\n## Safeties\n\n"
         "With any limit of `rating`, the summaries of `periodic`, `transient`, `steady` and of each periodic state "
         "of\n"
         "`sweep` on films have the table `safety`: `pitting`,\n"
         "`root_pinion`, `root_wheel`, `flash`, `integral` and `micropitting`. Each has the largest stress or\n"
         "temperature, or the smallest film ratio, where that is met (`xi`), the `limit` that was used with its\n"
         "factors, and the `safety`, null where no limit is given; a rating of which nothing is known is null itself.\n"
         "`nominal_stress` is the one of the formula, `lambda_film` the smallest computed film over Ra.\n";
}

}  // namespace gearfilm
