// Drive trains whose frequencies are published: planetary gears, geared shafts, two gears on bearings.
#include <array>
#include <numbers>

#include "train_reference.hpp"

namespace gearfilm::trains {
namespace {

using std::numbers::pi;

const nlohmann::json& published(const std::string& name) { return reference().at("published").at(name); }

/// The planetary gear of Lin and Parker: nodes sun, ring, carrier, planets; rotations as lengths, I/r^2 for I.
class PlanetaryGear {
public:
  explicit PlanetaryGear(int planets) : planets_(planets), train_(nodes(planets)) {
    const double k_b = input().at("k_bearing");
    for (const std::size_t n : {sun, ring, carrier}) train_.add_bearing(n, bearing_of(k_b, k_b));
    train_.add_ground(ring, input().at("k_ring_torsion_N_per_m"), 0.0);
    for (int n = 0; n < planets; ++n) add_planet(first_planet + static_cast<std::size_t>(n), 2.0 * pi * n / planets);
  }

  std::vector<TrainMode> modes() const {
    return modes_of(train_, std::vector<double>(2 * static_cast<std::size_t>(planets_), input().at("k_mesh")));
  }

private:
  static constexpr std::size_t sun = 0, ring = 1, carrier = 2, first_planet = 3;
  static const nlohmann::json& input() { return published("lin_parker_1999").at("input"); }

  static std::vector<TrainNode> nodes(int planets) {
    const auto node = [](const std::string& name) {
      return TrainNode{.name = name, .inertia = input().at("I_over_r2").at(name), .mass = input().at("mass").at(name)};
    };
    std::vector<TrainNode> all = {node("sun"), node("ring"), node("carrier")};
    all.insert(all.end(), static_cast<std::size_t>(planets), node("planet"));
    return all;
  }

  /// At an angle of the carrier, its own axes along and across the carrier's arm.
  void add_planet(std::size_t planet, double angle) {
    const double alpha = input().at("pressure_angle_deg").get<double>() * pi / 180.0, k_b = input().at("k_bearing");
    const Eigen::MatrixXd own = train_.translation(planet), arm = train_.translation(carrier);
    const auto across = [&](std::size_t n, double at) -> Eigen::RowVectorXd {
      return Eigen::RowVector2d(-std::sin(at), std::cos(at)) * train_.translation(n);
    };
    train_.add_contact(across(sun, angle - alpha) + train_.rotation(sun) + train_.rotation(planet) -
                       std::sin(alpha) * own.row(0) - std::cos(alpha) * own.row(1));
    train_.add_contact(across(ring, angle + alpha) + train_.rotation(ring) - train_.rotation(planet) +
                       std::sin(alpha) * own.row(0) - std::cos(alpha) * own.row(1));
    Eigen::MatrixXd rows(2, train_.freedoms());
    rows << std::cos(angle) * arm.row(0) + std::sin(angle) * arm.row(1) - own.row(0),
        across(carrier, angle) + train_.rotation(carrier) - own.row(1);
    train_.add_element({.name = "planet's bearing", .rows = rows, .stiffness = k_b * Eigen::Matrix2d::Identity()});
  }

  int planets_;
  Train train_;
};

TEST(PublishedTrains, planetary_gears_of_lin_and_parker) {
  const double tolerance = published("lin_parker_1999").at("tol");
  for (const auto& [planets, printed] : published("lin_parker_1999").at("printed").items()) {
    std::vector<double> expected;
    const auto add = [&](const char* kind, int times) {
      if (!printed.contains(kind)) return;
      for (const double frequency : printed.at(kind)) expected.insert(expected.end(), times, frequency);
    };
    add("single", 1);
    add("double", 2);
    add("planet", 1);
    add("planet_twice", 2);
    std::ranges::sort(expected);
    expect_frequencies(PlanetaryGear(std::stoi(planets)).modes(), expected, tolerance);
  }
}

/// Nodes that only turn, given by their inertias; the radius of gears follows in their contacts.
Train turning(const std::vector<double>& inertias) {
  std::vector<TrainNode> nodes;
  for (const double inertia : inertias) nodes.push_back({.name = std::to_string(nodes.size()), .inertia = inertia});
  return Train(std::move(nodes));
}

void mesh(Train& train, const SpurGearNode& first, const SpurGearNode& second) {
  train.add_contact(spur_row(train, first, second, 0.35));
}

std::vector<double> first_of(const std::vector<TrainMode>& modes, std::size_t count) {
  std::vector<double> frequencies;
  for (std::size_t n = 0; n < count; ++n) frequencies.push_back(modes[n].frequency());
  return frequencies;
}

void expect_printed(const std::vector<TrainMode>& modes, const nlohmann::json& expected) {
  const nlohmann::json& printed = expected.at("printed");
  const std::vector<double> found = first_of(modes, printed.size() - 1);
  for (std::size_t n = 0; n < found.size(); ++n) {
    EXPECT_NEAR(found[n], printed[n + 1].get<double>(), expected.at("tol_abs").get<double>());
  }
}

// Teeth that do not bend are a contact so stiff that the printed digits do not feel it.
TEST(PublishedTrains, motor_and_two_rotors_of_friswell) {
  Train train = turning({400e-6, 25e-6, 25e-6, 700e-6, 700e-6});
  train.add_shaft(0, 1, {.stiffness = 10000.0});
  train.add_shaft(1, 3, {.stiffness = 5000.0});
  train.add_shaft(2, 4, {.stiffness = 5000.0});
  mesh(train, {1, 1.0}, {2, 1.0});
  expect_printed(modes_of(train, {1e9}), published("friswell_motor_two_rotors"));
}

TEST(PublishedTrains, branched_shafts_of_friswell) {
  const nlohmann::json& expected = published("friswell_963");
  Train train = turning({3200.0, 200.0, 200.0, 800.0, 800.0, 450.0, 450.0});
  train.add_shaft(0, 1, {.stiffness = expected.at("k")[0]});
  train.add_shaft(3, 5, {.stiffness = expected.at("k")[1]});
  train.add_shaft(4, 6, {.stiffness = expected.at("k")[1]});
  mesh(train, {1, 0.5}, {2, 0.5});
  mesh(train, {1, 0.5}, {3, 0.8});
  mesh(train, {2, 0.5}, {4, 0.8});
  expect_printed(modes_of(train, {1e13, 1e13, 1e13}), expected);
}

TEST(PublishedTrains, two_gears_of_ross_on_bearings) {
  const nlohmann::json& expected = published("ross_lumped");
  const nlohmann::json& input = expected.at("input");
  const double angle = input.at("alpha_deg").get<double>() * pi / 180.0, k_b = input.at("k_b");
  const double base_radius = input.at("r_pitch").get<double>() * std::cos(angle);
  const TrainNode gear{.name = "gear", .inertia = input.at("I"), .mass = input.at("m"), .radius = base_radius};
  Train train({gear, gear});
  for (const std::size_t n : {0, 1}) train.add_bearing(n, bearing_of(k_b, k_b));
  train.add_contact(spur_row(train, {0, base_radius}, {1, base_radius}, angle));
  expect_frequencies(modes_of(train, {input.at("k_mesh")}), expected.at("ross"), expected.at("tol"));
}

/// Shafts one after the other from a node on, of steel.
void add_shafts(Train& train, std::size_t first, const std::vector<std::array<double, 2>>& lengths_and_diameters) {
  constexpr double shear_modulus = 81.2e9, density = 7810.0;
  for (const auto& [length, diameter] : lengths_and_diameters) {
    const double polar = pi * std::pow(diameter, 4) / 32.0;
    train.add_shaft(first, first + 1,
                    {.stiffness = shear_modulus * polar / length, .inertia = density * polar * length});
    ++first;
  }
}

// Long shafts: their own inertia counts.
TEST(PublishedTrains, turbine_and_alternator_of_rao_in_torsion) {
  Train train = turning({0.0, 32.2, 6.23, 0.0, 113.9, 0.004, 0.0, 0.149, 0.0});
  add_shafts(train, 0, {{0.1, 0.3}, {4.24, 0.3}, {1.16, 0.22}, {0.3, 0.22}});
  add_shafts(train, 5, {{0.3, 0.15}, {5.0, 0.15}, {0.1, 0.15}});
  mesh(train, {4, 0.5086}, {5, 0.03567});
  const nlohmann::json& expected = published("ross_two_shaft").at("torsion_only_rad_s");
  const std::vector<TrainMode> modes = modes_of(train, {1e8});
  for (std::size_t n = 1; n < expected.size(); ++n) {
    EXPECT_NEAR(modes[n - 1].rate / expected[n].get<double>(), 1.0, 1e-7);
  }
}

}  // namespace
}  // namespace gearfilm::trains
