#include "results/train_summary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "input/case_numerics.hpp"
#include "mesh/static_mesh.hpp"
#include "results/members.hpp"
#include "results/tilt_summary.hpp"

namespace gearfilm {
namespace {

constexpr int mesh_harmonics = 3;  // whose speeds are given
constexpr double widest_spread = 1e6, highest_mode = 100.0;
constexpr double largest_growth = 1e-3, largest_change_of_contact_ratio = 0.02;

/// One mode, as the summary has it.
struct DescribedMode {
  const CaseInput& problem;
  const DampedTrain& damped;
  const TrainMode& mode;
  const ModeOnFilms* on_films;  ///< null: of the dry pair

  std::size_t most_strained() const {
    return static_cast<std::size_t>(std::ranges::max_element(mode.element_shares) - mode.element_shares.begin());
  }
};

/// A number of a mode on films.
Summary on_films(const DescribedMode& of, std::optional<double> (*value)(const SwingQuantities&)) {
  if (!of.on_films) return absent();
  return *of.on_films ? known(value(**of.on_films)) : Summary();
}

/// Speeds of the pinion [rpm].
Summary crossings(const DescribedMode& of) {
  Summary speeds = Summary::array();
  for (int harmonic = 1; harmonic <= mesh_harmonics; ++harmonic) {
    speeds.push_back(60.0 * of.mode.frequency() / (harmonic * of.problem.pair.gears->pinion.teeth));
  }
  return speeds;
}

Summary shape_of(const DescribedMode& of) {
  const Train& train = of.damped.train;
  const Eigen::VectorXd lengths = normalised_shape(train, of.mode);
  Summary shape = Summary::object();
  for (std::size_t n = 0; n < train.node_count(); ++n) {
    Summary node = Summary::object();
    if (!train.node(n).fixed) node["rotation"] = (train.rotation(n) * lengths).value();
    if (train.node(n).mass) {
      const Eigen::Vector2d way = train.translation(n) * lengths;
      node["x"] = way.x();
      node["y"] = way.y();
    }
    shape[train.node(n).name] = std::move(node);
  }
  return shape;
}

constexpr auto mode_members = std::to_array<Member<DescribedMode>>({
    {"frequency_dry", "", "Hz", "natural frequency on the stiffness of the dry mesh, undamped",
     [](const DescribedMode& of) -> Summary { return of.mode.frequency(); }},
    {"frequency", "", "Hz", "frequency on films; null where it is not found",
     [](const DescribedMode& of) {
       return on_films(of, [](const SwingQuantities& mode) { return std::optional(mode.frequency); });
     }},
    {"frequency_error", "", "Hz", "its error; null where no coarser grid has a mode",
     [](const DescribedMode& of) {
       return on_films(of, [](const SwingQuantities& mode) { return mode.frequency_error; });
     }},
    {"damping_ratio", "", "-", "damping ratio by dampers, of small damping; on films by these too",
     [](const DescribedMode& of) -> Summary {
       if (!of.on_films) return 0.0 + of.damped.damping_ratio(of.mode);  // no negative zero
       return on_films(of, [](const SwingQuantities& mode) { return std::optional(mode.damping_ratio); });
     }},
    {"damping_ratio_error", "", "-", "on films: its error, likewise",
     [](const DescribedMode& of) {
       return on_films(of, [](const SwingQuantities& mode) { return mode.damping_ratio_error; });
     }},
    {"mesh_share", "", "-", "share of the teeth in the energy of the strained parts",
     [](const DescribedMode& of) -> Summary { return of.mode.mesh_share; }},
    {"largest_element", "", "", "the shaft, bearing or ground that is strained most",
     [](const DescribedMode& of) -> Summary {
       return of.mode.element_shares.empty() ? absent() : Summary(of.damped.train.elements()[of.most_strained()].name);
     }},
    {"largest_element_share", "", "-", "its share",
     [](const DescribedMode& of) -> Summary {
       return of.mode.element_shares.empty() ? absent() : Summary(of.mode.element_shares[of.most_strained()]);
     }},
    {"crossing_rpm", "", "rpm", "speeds of the pinion at which 1, 2 and 3 times the mesh frequency meet the mode",
     crossings},
    {"shape", "", "-",
     "of each node its rotation as a length, at the base circle of its side's gear, and its displacements along and "
     "across the line of centres; the largest of all 1",
     shape_of},
});

struct TrainOfCase {
  const CaseInput& problem;
  const DampedTrain& damped;
};

bool has_bearings(const Train& train) { return train.node(0).mass || train.node(1).mass; }

constexpr auto train_members = std::to_array<Member<TrainOfCase>>({
    {"speed_rpm", "", "rpm", "speed of the pinion",
     [](const TrainOfCase& of) -> Summary { return of.problem.parameters.real("pinion.speed_rpm"); }},
    {"centre_distance_growth", "", "m", "by which the static force parts the centres on their bearings",
     [](const TrainOfCase& of) -> Summary {
       return has_bearings(of.damped.train) ? Summary(centre_distance_growth(of.problem)) : absent();
     }},
    {"damping_references", "", "Hz",
     "elements whose damping is given as a ratio, and the frequency at which they have it",
     [](const TrainOfCase& of) -> Summary {
       if (of.damped.references.empty()) return absent();
       Summary list = Summary::object();
       for (const ReferenceFrequency& reference : of.damped.references) list[reference.element] = reference.frequency;
       return list;
     }},
});

/// Stiffness of an element as one of lengths [N/m]: the smallest and the largest.
std::pair<double, double> stiffness_range(const DampedTrain& damped, double contact) {
  double least = contact, most = contact;
  const Eigen::VectorXd lengths = damped.train.lengths();
  for (const TrainElement& element : damped.train.elements()) {
    for (Eigen::Index n = 0; n < element.rows.rows(); ++n) {
      const double scale = element.rows.row(n).cwiseQuotient(lengths.transpose()).cwiseAbs().maxCoeff();
      const double stiffness = element.stiffness(n, n) * scale * scale;
      if (stiffness == 0.0) continue;
      least = std::min(least, stiffness);
      most = std::max(most, stiffness);
    }
  }
  return {least, most};
}

void warn_of_growth(const CaseInput& problem, std::vector<std::string>& warnings) {
  const double growth = centre_distance_growth(problem), distance = problem.pair.gears->centre_distance;
  SpurGearPair parted = *problem.pair.gears;
  parted.centre_distance += growth;
  const double before = problem.pair.line->contact_ratio();
  const std::optional<double> after = [&]() -> std::optional<double> {
    try {
      return LineOfAction(parted).contact_ratio();
    } catch (const InputError&) {
      return {};
    }
  }();
  const bool other = !after || std::abs(*after - before) > largest_change_of_contact_ratio;
  if (!other && std::abs(growth) <= largest_growth * distance) return;
  warnings.push_back(worded(std::setprecision(3), "the static force parts the centres by ", growth * 1e6,
                            " um on their bearings, from a ", "contact ratio of ", before, " to ",
                            after ? worded(std::setprecision(3), *after) : "less than 1",
                            ": gear.centre_distance is taken as that under load; give it so"));
}

}  // namespace

void add_train(const CaseInput& problem, const DampedTrain& train, const std::vector<ModeOnFilms>& on_films,
               Summary& summary) {
  add_members(train_members, TrainOfCase{problem, train}, summary);
  add_tilt(problem, summary);
  summary["modes"] = Summary::array();
  for (std::size_t n = 0; n < train.modes.size(); ++n) {
    const ModeOnFilms* found = on_films.empty() ? nullptr : &on_films[n];
    summary["modes"].push_back(as_summary(mode_members, DescribedMode{problem, train, train.modes[n], found}));
  }
}

std::vector<std::string> mode_lines(const Summary& summary) {
  std::vector<std::string> lines;
  if (!summary.contains("modes")) return lines;
  const auto number = [](const Summary& value, int digits) {
    return value.is_null() ? std::string("-") : worded(std::setprecision(digits), value.get<double>());
  };
  const bool films = !summary["modes"].empty() && summary["modes"][0].contains("frequency");
  const auto columns = [&lines, films](const std::vector<std::string>& cells) {
    std::ostringstream line;
    line << std::left << std::setw(6) << cells[0] << std::setw(13) << cells[1];
    if (films) line << std::setw(13) << cells[2];
    line << std::setw(12) << cells[3] << std::setw(12) << cells[4] << std::setw(32) << cells[5] << cells[6];
    lines.push_back(line.str());
  };
  columns({"mode", "dry, Hz", "on films, Hz", "damping", "mesh share", "strained most", "met by f_m at, rpm"});
  int count = 0;
  for (const Summary& mode : summary["modes"]) {
    std::string element = "-";
    if (mode.contains("largest_element")) {
      element = worded(mode["largest_element"].get<std::string>(), " ", number(mode["largest_element_share"], 3));
    }
    columns({std::to_string(++count), number(mode["frequency_dry"], 6), films ? number(mode["frequency"], 6) : "",
             number(mode["damping_ratio"], 3), number(mode["mesh_share"], 3), element,
             number(mode["crossing_rpm"][0], 6)});
  }
  return lines;
}

std::vector<std::string> damping_lines(const Summary& summary) {
  std::vector<std::string> lines;
  if (!summary.contains("damping_references")) return lines;
  for (const auto& [element, frequency] : summary["damping_references"].items()) {
    lines.push_back(
        worded("the damping ratio of ", element, " holds at ", std::setprecision(6), frequency.get<double>(), " Hz"));
  }
  return lines;
}

std::vector<std::string> train_warnings(const CaseInput& problem, const DampedTrain& train) {
  std::vector<std::string> warnings;
  const auto [least, most] = stiffness_range(train, mesh_after_leaving(problem).stiffness_si());
  if (most > widest_spread * least) {
    warnings.push_back(worded(std::setprecision(3), "stiffnesses of the drive train, as those of lengths, are from ",
                              least, " to ", most, " N/m: so far apart that digits are lost; make the stiffest rigid"));
  }
  const double f_m = mesh_frequency(*problem.pair.gears, problem.pair.pinion_speed);
  if (!train.modes.empty() && train.modes.back().frequency() > highest_mode * f_m) {
    warnings.push_back(worded(std::setprecision(4), "the drive train has a mode at ", train.modes.back().frequency(),
                              " Hz, far above the mesh frequency of ", f_m,
                              " Hz; make the support that is strained there rigid"));
  }
  if (has_bearings(train.train)) warn_of_growth(problem, warnings);
  return warnings;
}

std::string train_markdown() {
  return members_markdown("A drive train in `info` and `eigen`",
                          "Keys of their summaries where the case has a drive train, beside `modes`.", train_members) +
         members_markdown("Modes of a drive train", "Keys of each of `modes`, the lowest first.", mode_members) +
         tilt_markdown();
}

}  // namespace gearfilm
