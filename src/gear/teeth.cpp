#include "gear/teeth.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gear/involute.hpp"
#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

constexpr std::array<const char*, 2> names = {"pinion", "wheel"};

void check_relief(const Relief& relief, double active, const std::string& name) {
  if (relief.amount == 0.0 || (relief.length > 0.0 && relief.length < active)) return;
  throw InputError(name, "_length = ", relief.length, " m of roll is not between zero and the active flank's ", active,
                   " m: shorten it");
}

void check_errors(const std::vector<double>& errors, int teeth, const std::string& name) {
  if (errors.empty() || static_cast<int>(errors.size()) == teeth) return;
  throw InputError(name, "_pitch_errors has ", errors.size(), " numbers for ", teeth, " teeth: give one a tooth");
}

void check_pitch_errors(const std::vector<double>& errors, double base_pitch, const std::string& name) {
  for (const double error : errors) {
    if (std::abs(error) < 0.5 * base_pitch) continue;
    throw InputError(name, "_pitch_errors has ", error, " m, half a base pitch of ", base_pitch,
                     " m or more: such a tooth is its neighbour; give errors in metres");
  }
}

/// A modified flank must leave a tooth, whose other flank is modified alike: 2 E/cos(alpha_r) < s(r).
void check_removed(const Flank& flank, const SpurGearPair& pair, int gear, const std::array<double, 2>& from_to) {
  constexpr int places = 100;
  const SpurGear& own = gear == 0 ? pair.pinion : pair.wheel;
  const double base = 0.5 * own.teeth * pair.module_length * std::cos(pair.pressure_angle);
  for (int n = 0; n <= places; ++n) {
    const double rho = from_to[0] + (from_to[1] - from_to[0]) * n / places, radius = std::hypot(base, rho);
    const double thickness = tooth_thickness_at(radius, own, pair, profile_shifts(pair)[gear]);
    const double removed = std::abs(flank.removed(rho));
    if (thickness <= 0.0 || 2.0 * removed * radius / base < thickness) continue;
    throw InputError("the flank of the ", names[gear], " is modified by ", removed, " m at the radius ", radius,
                     " m, where the tooth is ", thickness, " m thick: check ", names[gear],
                     "_tip_relief, root_relief, profile_slope, profile_crowning and profile_file, which are in metres");
  }
}

/// Linear between points, constant beyond.
double interpolate(const std::vector<std::pair<double, double>>& points, double at) {
  if (at <= points.front().first) return points.front().second;
  if (at >= points.back().first) return points.back().second;
  const auto above = std::ranges::upper_bound(points, at, {}, &std::pair<double, double>::first);
  const auto below = std::prev(above);
  const double part = (at - below->first) / (above->first - below->first);
  return below->second + part * (above->second - below->second);
}

}  // namespace

Teeth::Teeth(const SpurGearPair& pair, const LineOfAction& line, std::array<GearFlanks, 2> flanks,
             const ComplianceOptions& compliance, ProfileAction action)
    : at_pitch_pinion_(line.radius_pinion(0.0)),
      at_pitch_wheel_(line.radius_wheel(0.0)),
      base_radius_{line.base_radius_pinion(), line.base_radius_wheel()},
      action_(action),
      low_(line.entry()),
      high_(line.exit()) {
  std::array<Flank, 2> own;
  const std::array<int, 2> teeth = {pair.pinion.teeth, pair.wheel.teeth};
  const std::array<double, 2> start = {line.radius_pinion(low_), line.radius_wheel(high_)};
  const std::array<double, 2> tip = {line.radius_pinion(high_), line.radius_wheel(low_)};
  for (int gear = 0; gear < 2; ++gear) {
    const FlankModification& modification = flanks[gear].modification;
    check_relief(modification.tip, tip[gear] - start[gear], std::string(names[gear]) + "_tip_relief");
    check_relief(modification.root, tip[gear] - start[gear], std::string(names[gear]) + "_root_relief");
    check_errors(flanks[gear].pitch_errors, teeth[gear], names[gear]);
    check_pitch_errors(flanks[gear].pitch_errors, line.base_pitch(), names[gear]);
    own[gear] = Flank(modification, start[gear], tip[gear]);
    check_removed(own[gear], pair, gear, {start[gear], tip[gear]});
    add_relief_places(modification, gear, start[gear], tip[gear]);
    errors_[gear] = std::move(flanks[gear].pitch_errors);
    if (!errors_[gear].empty()) pattern_ = std::lcm(pattern_, static_cast<long>(teeth[gear]));
    perfect_ = perfect_ && own[gear].perfect() && errors_[gear].empty();
  }
  flanks_ = std::make_shared<const std::array<Flank, 2>>(own);
  if (!flanks[0].beside_middle.even() || !flanks[1].beside_middle.even()) {
    beside_middle_ = std::make_shared<const std::array<UnevenFlank, 2>>(
        std::array{std::move(flanks[0].beside_middle), std::move(flanks[1].beside_middle)});
  }
  set_compliance(pair, line, compliance);
  set_backlash(pair, line);
}

void Teeth::add_relief_places(const FlankModification& modification, int gear, double start, double tip) {
  const auto add = [&](const Relief& relief, double rho) {
    if (relief.amount != 0.0) relief_places_.push_back(gear == 0 ? rho - at_pitch_pinion_ : at_pitch_wheel_ - rho);
  };
  add(modification.tip, tip - modification.tip.length);
  add(modification.root, start + modification.root.length);
}

void Teeth::set_compliance(const SpurGearPair& pair, const LineOfAction& line, const ComplianceOptions& options) {
  coupling_.fill(options.mesh);
  double body = options.mesh;
  std::vector<GearCompliance> gears;
  if (options.teeth) {
    const std::array<double, 2> shifts = profile_shifts(pair);
    const auto add = [&](const SpurGear& gear, double shift, const char* name) {
      gears.emplace_back(gear, pair, ToothProfile(gear, pair, shift, name), *options.teeth, name);
    };
    add(pair.pinion, shifts[0], names[0]);
    add(pair.wheel, shifts[1], names[1]);
    for (const GearCompliance& gear : gears) {
      // The ring's foundation has its torsion already.
      if (*options.teeth == FoundationModel::weber) body += gear.body().torsion;
      if (!options.body_coupling) continue;
      coupling_[0] += gear.body().neighbour;
      coupling_[1] += gear.body().neighbour2;
    }
  } else if (options.table.empty() && options.mesh == 0.0) {
    return;
  }
  rigid_ = false;
  table_ = options.table;
  mesh_ = options.mesh;
  if (table_.empty()) {
    own_ = Chebyshev<32>(low_, high_, [&](double xi) {
      double sum = body;
      if (gears.empty()) return sum;
      sum += options.factor * gears[0].tooth(line.radius_pinion(xi)).sum();
      return sum + options.factor * gears[1].tooth(line.radius_wheel(xi)).sum();
    });
  }
  double softest = compliance(low_);
  for (int n = 0; n <= 100; ++n) softest = std::min(softest, compliance(low_ + (high_ - low_) * n / 100));
  if (coupling_[0] < softest || coupling_[0] == options.mesh) return;
  throw InputError("a neighbour's force would bend a tooth by ", coupling_[0], " m/N, its own by ", softest,
                   " m/N: check pinion_bore_radius and wheel_bore_radius, or set gear_body_coupling to no");
}

// On the working pitch circle R_w the pinion's tooth is s_w = 2 R_w (s/2r + inv alpha - inv alpha') thick.
void Teeth::set_backlash(const SpurGearPair& pair, const LineOfAction& line) {
  backlash_ = pair.backlash;
  base_pitch_ = line.base_pitch();
  if (!backlash_) return;
  const double thickness = tooth_thickness(pair, profile_shifts(pair)[0]);
  // R_w cos alpha' = R_b.
  thickness_ = 2.0 * line.base_radius_pinion() *
               (thickness / (pair.pinion.teeth * pair.module_length) + involute(pair.pressure_angle) -
                involute(line.working_pressure_angle()));
}

std::vector<double> Teeth::back_positions(double xi) const {
  std::vector<double> positions;
  const double first = thickness_ - xi;
  for (double n = std::floor((first - low_) / base_pitch_); first - n * base_pitch_ <= high_; --n) {
    positions.push_back(first - n * base_pitch_);
  }
  return positions;
}

double Teeth::removed(double xi) const {
  if (!flanks_) return 0.0;
  return (*flanks_)[0].removed(at_pitch_pinion_ + xi) + (*flanks_)[1].removed(at_pitch_wheel_ - xi);
}

LocalProfile Teeth::local(double xi) const {
  if (action_ == ProfileAction::offset || perfect_) return {};
  return {flanks_, {at_pitch_pinion_ + xi, at_pitch_wheel_ - xi}, base_radius_};
}

UnevenProfile Teeth::beside_middle(double xi) const {
  if (!beside_middle_) return {};
  return {beside_middle_, {at_pitch_pinion_ + xi, at_pitch_wheel_ - xi}, base_radius_, action_ == ProfileAction::field};
}

Teeth Teeth::without_pitch_errors() const {
  Teeth nominal = *this;
  nominal.errors_ = {};
  nominal.pattern_ = 1;
  return nominal;
}

double Teeth::gap(int contact, double xi) const {
  if (perfect_) return 0.0;
  double gap = removed(xi);
  for (const std::vector<double>& errors : errors_) {
    if (errors.empty()) continue;
    const int teeth = static_cast<int>(errors.size());
    gap -= errors[((contact % teeth) + teeth) % teeth];
  }
  return gap;
}

double Teeth::compliance(double xi) const {
  if (rigid_) return 0.0;
  return table_.empty() ? own_(std::clamp(xi, low_, high_)) : interpolate(table_, xi) + mesh_;
}

double Teeth::coupling(int pitches) const {
  if (rigid_) return 0.0;
  return coupling_[std::min(pitches, 2) - 1];
}

}  // namespace gearfilm
