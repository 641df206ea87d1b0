#include "results/train_motion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "dynamics/friction_force.hpp"
#include "numerics/sampled_integral.hpp"
#include "results/members.hpp"

namespace gearfilm {
namespace {

/// Columns, and behind them one of each output from the first of these on.
std::vector<TableColumn> with_outputs(std::vector<TableColumn> columns, const TrainOutputs& outputs,
                                      std::size_t first) {
  for (std::size_t n = first; n < outputs.list().size(); ++n) {
    columns.push_back({outputs.list()[n].name, outputs.list()[n].unit});
  }
  return columns;
}

/// The course of some moments, in order of time; where contacts come or go two of them have one time.
class TrainCourse {
public:
  TrainCourse(const TrainOutputs& outputs, double seconds, const std::vector<TrainMoment>& moments, double T_begin,
              double T_end)
      : outputs_(outputs), seconds_(seconds) {
    const double round_off = 1e-9 * (T_end - T_begin);
    for (const TrainMoment& moment : moments) {
      if (moment.T < T_begin - round_off || moment.T > T_end + round_off) continue;
      if (moment.T <= T_begin + round_off) moments_.clear();  // the last one of the begin
      moments_.push_back(&moment);
    }
  }

  bool empty() const { return moments_.size() < 2; }
  double duration() const { return seconds_ * (moments_.back()->T - moments_.front()->T); }
  const TrainMoment& first() const { return *moments_.front(); }
  const TrainMoment& last() const { return *moments_.back(); }
  const TrainOutputs& outputs() const { return outputs_; }

  /// Of one output.
  std::vector<double> values(std::size_t output) const {
    return each([&](const TrainMoment& moment) { return outputs_.values(moment)[static_cast<Eigen::Index>(output)]; });
  }
  std::vector<double> each(const std::function<double(const TrainMoment&)>& value) const {
    std::vector<double> values;
    values.reserve(moments_.size());
    for (const TrainMoment* moment : moments_) values.push_back(value(*moment));
    return values;
  }

  /// Over time [s], from event to event.
  double integral(const std::vector<double>& values) const {
    const std::vector<double> t = each([&](const TrainMoment& moment) { return seconds_ * moment.T; });
    double sum = 0.0;
    for (std::size_t begin = 0, n = 1; n <= t.size(); ++n) {
      if (n < t.size() && t[n] > t[n - 1]) continue;
      sum += sampled_integral(std::span(t).subspan(begin, n - begin), std::span(values).subspan(begin, n - begin));
      begin = n;
    }
    return sum;
  }
  double mean(const std::vector<double>& values) const { return integral(values) / duration(); }

private:
  const TrainOutputs& outputs_;
  double seconds_;  ///< of a unit of T
  std::vector<const TrainMoment*> moments_;
};

/// A shaft or a ground, whose torque is an output.
struct TorqueOfTrain {
  std::string name;
  double mean, least, largest;  ///< [N m]
};

/// A bearing, whose force has two.
struct BearingOfTrain {
  std::string name;
  double mean_x, mean_y, mean, largest;  ///< [N]
};

struct GearOfTrain {
  std::string name;
  double rotation;             ///< root mean square of phi'' [rad/s^2]
  std::optional<double> x, y;  ///< of its displacements [m/s^2]
};

/// [J].
struct EnergyOfTrain {
  double torques, teeth, dampers, change, largest_kinetic;

  std::optional<double> residual() const {
    const double scale = std::abs(dampers) + largest_kinetic;
    if (!(scale > 0.0)) return {};
    return std::abs(torques + teeth - dampers - change) / scale;
  }
};

constexpr auto torque_members = std::to_array<Member<TorqueOfTrain>>({
    {"shaft", "", "", "name of the column of `/history/train`",
     [](const TorqueOfTrain& of) -> Summary { return of.name; }},
    {"torque_mean", "", "N m", "torque, mean in time", [](const TorqueOfTrain& of) -> Summary { return of.mean; }},
    {"torque_max", "", "N m", "largest torque", [](const TorqueOfTrain& of) -> Summary { return of.largest; }},
    {"torque_min", "", "N m", "smallest torque", [](const TorqueOfTrain& of) -> Summary { return of.least; }},
});

constexpr auto bearing_members = std::to_array<Member<BearingOfTrain>>({
    {"bearing", "", "", "name of the columns, without `_x` and `_y`",
     [](const BearingOfTrain& of) -> Summary { return of.name; }},
    {"force_mean", "", "N", "size of the force, mean in time",
     [](const BearingOfTrain& of) -> Summary { return of.mean; }},
    {"force_max", "", "N", "largest size", [](const BearingOfTrain& of) -> Summary { return of.largest; }},
    {"force_x_mean", "", "N", "its part along the line of centres, to the wheel, mean in time",
     [](const BearingOfTrain& of) -> Summary { return of.mean_x; }},
    {"force_y_mean", "", "N", "its part across, mean in time",
     [](const BearingOfTrain& of) -> Summary { return of.mean_y; }},
});

constexpr auto gear_motion_members = std::to_array<Member<GearOfTrain>>({
    {"gear", "", "", "pinion or wheel", [](const GearOfTrain& of) -> Summary { return of.name; }},
    {"rotation_acceleration_rms", "", "rad/s^2", "root mean square of its angular acceleration",
     [](const GearOfTrain& of) -> Summary { return of.rotation; }},
    {"x_acceleration_rms", "", "m/s^2", "of that along the line of centres, on bearings",
     [](const GearOfTrain& of) { return if_there(of.x); }},
    {"y_acceleration_rms", "", "m/s^2", "of that across it, on bearings",
     [](const GearOfTrain& of) { return if_there(of.y); }},
});

constexpr auto energy_members = std::to_array<Member<EnergyOfTrain>>({
    {"work_of_torques", "", "J", "work of the torques on the motion beside the mean rotation",
     [](const EnergyOfTrain& of) -> Summary { return of.torques; }},
    {"work_of_teeth", "", "J", "work of the forces between flanks on it, what moving contacts take or give",
     [](const EnergyOfTrain& of) -> Summary { return of.teeth; }},
    {"dissipated_energy", "", "J", "what dampers take", [](const EnergyOfTrain& of) -> Summary { return of.dampers; }},
    {"stored_energy_change", "", "J", "change of the energy of motion, shafts and bearings",
     [](const EnergyOfTrain& of) -> Summary { return of.change; }},
    {"energy_balance_residual", "", "-",
     "what is left of both works less both energies, over the dissipated and the largest kinetic energy",
     [](const EnergyOfTrain& of) { return known(of.residual()); }},
});

double largest(const std::vector<double>& values) { return *std::ranges::max_element(values); }

/// Shafts and grounds into one list, bearings into the other.
void add_elements(const TrainCourse& course, Summary& summary) {
  const std::vector<TrainOutput>& list = course.outputs().list();
  Summary shafts = Summary::array(), bearings = Summary::array();
  for (std::size_t n = course.outputs().first_of_elements(); n < list.size(); ++n) {
    const std::vector<double> values = course.values(n);
    if (list[n].unit == "N m") {
      shafts.push_back(as_summary(torque_members, TorqueOfTrain{list[n].name, course.mean(values),
                                                                *std::ranges::min_element(values), largest(values)}));
      continue;
    }
    const std::vector<double> across = course.values(++n);
    std::vector<double> size;
    for (std::size_t k = 0; k < values.size(); ++k) size.push_back(std::hypot(values[k], across[k]));
    const std::string name = list[n - 1].name;
    bearings.push_back(
        as_summary(bearing_members, BearingOfTrain{name.substr(0, name.find("_x")), course.mean(values),
                                                   course.mean(across), course.mean(size), largest(size)}));
  }
  if (!shafts.empty()) summary["shaft_torques"] = std::move(shafts);
  if (!bearings.empty()) summary["bearing_forces"] = std::move(bearings);
}

void add_gears(const TrainCourse& course, const Train& train, Summary& summary) {
  const auto root_mean_square = [&](const Eigen::RowVectorXd& row) {
    return std::sqrt(course.mean(course.each(
        [&](const TrainMoment& moment) { return std::pow(row.dot(course.outputs().acceleration(moment)), 2.0); })));
  };
  Summary gears = Summary::array();
  for (const std::size_t n : {0, 1}) {  // the gears come first
    GearOfTrain gear{train.node(n).name, root_mean_square(train.rotation(n)), {}, {}};
    if (train.node(n).mass) {
      gear.x = root_mean_square(train.translation(n).row(0));
      gear.y = root_mean_square(train.translation(n).row(1));
    }
    gears.push_back(as_summary(gear_motion_members, gear));
  }
  summary["gear_accelerations"] = std::move(gears);
}

void add_energies(const TrainCourse& course, Summary& summary) {
  const TrainOutputs& outputs = course.outputs();
  const auto work = [&](double TrainPowers::*part) {
    return course.integral(course.each([&](const TrainMoment& moment) { return outputs.powers(moment).*part; }));
  };
  const auto energy = [&](const Motion& motion) {
    return outputs.kinetic_energy(motion) + outputs.stored_energy(motion);
  };
  const EnergyOfTrain energies{
      work(&TrainPowers::torques), work(&TrainPowers::teeth), work(&TrainPowers::dampers),
      energy(course.last().motion) - energy(course.first().motion),
      largest(course.each([&](const TrainMoment& moment) { return outputs.kinetic_energy(moment.motion); }))};
  add_members(energy_members, energies, summary);
}

}  // namespace

TrainHistory::TrainHistory(ResultsFile& file, const MeshModel& mesh, double damping)
    : mesh_(mesh),
      damper_(mesh.inertia * damping),
      outputs_(mesh),
      table_(file, "/history/train", with_outputs({{"step", "-", true}, {"t", "s"}}, outputs_, 0)) {}

void TrainHistory::add(const StepRecord& record) {
  moments_.push_back(
      {.T = record.T,
       .motion = record.motion,
       .teeth = record.pressure_integral(),
       .damper = damper_ * record.motion.V0(),
       .back = record.back_force,
       .friction = mesh_.friction_couples_dynamics ? friction_on_motion(mesh_, record.contacts) : Eigen::VectorXd()});
  const Eigen::VectorXd values = outputs_.values(moments_.back());
  std::vector<double> row = {static_cast<double>(step_++), mesh_.scales.time * record.T};
  row.insert(row.end(), values.begin(), values.end());
  table_.append(row);
}

void TrainHistory::add_to(Summary& summary, double T_begin, double T_end) const {
  const TrainCourse course(outputs_, mesh_.scales.time, moments_, T_begin, T_end);
  if (course.empty()) return;
  add_elements(course, summary);
  add_gears(course, mesh_.train->whole.damped->train, summary);
  add_energies(course, summary);
}

void TrainHistory::write_orders(ResultsFile& file, double T_begin, double T_end, SpectralWindow window) const {
  const auto first = static_cast<Eigen::Index>(outputs_.first_of_elements());
  std::vector<Signal> signals(1 + outputs_.list().size() - outputs_.first_of_elements());
  for (const TrainMoment& moment : moments_) {
    const double thickness = mesh_.scales.thickness;
    signals[0].sample(moment.T, -thickness * moment.motion.H0(), -thickness * moment.motion.V0());
    const Eigen::VectorXd values = outputs_.values(moment), rates = mesh_.scales.time * outputs_.rates(moment);
    for (Eigen::Index n = first; n < values.size(); ++n) {
      signals[1 + n - first].sample(moment.T, values[n], rates[n]);
    }
  }
  std::vector<std::vector<SpectralLine>> spectra;
  spectra.reserve(signals.size());
  for (const Signal& signal : signals) spectra.push_back(signal.spectrum(T_begin, T_end, window));
  // Orders are of the pinion's shaft: its speed at the end, where that changes.
  const double turns = mesh_.path.rpm(T_end) / 60.0;
  std::vector<double> rows;
  for (std::size_t line = 1; line < spectra[0].size(); ++line) {
    const double frequency = spectra[0][line].frequency / mesh_.scales.time;
    rows.insert(rows.end(), {frequency / turns, frequency});
    std::ranges::transform(spectra, std::back_inserter(rows),
                           [line](const std::vector<SpectralLine>& spectrum) { return spectrum[line].amplitude; });
  }
  write_table(file, "/orders",
              with_outputs({{"order", "-"}, {"frequency", "Hz"}, {"transmission_error", "m"}}, outputs_,
                           outputs_.first_of_elements()),
              rows);
}

void add_train_at_rest(const MeshModel& mesh, Summary& summary) {
  const TrainOutputs outputs(mesh);
  const Motion none = Motion::zero(mesh.train->freedoms());
  const std::vector<TrainMoment> moments = {{.T = 0.0, .motion = none}, {.T = 1.0, .motion = none}};
  add_elements({outputs, mesh.scales.time, moments, 0.0, 1.0}, summary);
}

std::string train_motion_markdown() {
  return "\n## `/history/train` and `/orders`\n\n"
         "Of marches and periodic states with a drive train. `/history/train` has a row for each of `/history/steps`\n"
         "(`step`, `t`): of every node `rotation_NODE`, `rotation_velocity_NODE`, on bearings `x_NODE`, `y_NODE` and\n"
         "`x_velocity_NODE`, `y_velocity_NODE`, less the mean rotation; `shaft_A_B` and `ground_NODE`, torques;\n"
         "`bearing_NODE_x`, `bearing_NODE_y`, force of the node on its bearings. Dampers of elements are in them, "
         "those\n"
         "of `train.damping_ratio` in none. `/orders` has the amplitudes of the last ones and of "
         "`transmission_error`,\n"
         "one row an `order` of the pinion's shaft, with its `frequency`; of `transient` with "
         "`output.spectrum_periods`.\n" +
         members_markdown("Torques of a drive train", "Keys of each of `shaft_torques`.", torque_members) +
         members_markdown("Forces on bearings", "Keys of each of `bearing_forces`.", bearing_members) +
         members_markdown("Accelerations of the gears", "Keys of each of `gear_accelerations`.", gear_motion_members) +
         members_markdown("Energy of a drive train", "Keys of the summaries of `transient` and `periodic`.",
                          energy_members);
}

}  // namespace gearfilm
