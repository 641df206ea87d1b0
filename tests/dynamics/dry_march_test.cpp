// The pair on dry Hertz contacts against an integration of its own, and its invariants under frozen geometry.
//
//   I_n H_0'' = sum_k F_k - F* ,   F_k = F* (-H_0 film/h_0n(R_x))^(3/2)   where h_0n is the approach under w*
#include <algorithm>
#include <numbers>

#include "mesh/natural_frequency.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

const StepObserver nobody = [](const StepRecord&, const std::vector<ActiveContact>&) {};

/// The motion by classical Runge-Kutta steps between events that are found here again.
class RungeKutta {
public:
  explicit RungeKutta(const CaseInput& problem)
      : line_(*problem.pair.line),
        scales_(problem.scales),
        inertia_(mesh_of(problem).inertia),
        velocity_(line_.travel_velocity(problem.pair.pinion_speed) * scales_.time),
        start_(problem.march.start_position) {}

  Motion integrate(Motion motion, double T_end, double largest_step) const {
    std::vector<double> times = {0.0, T_end};
    for (int n = -10; n < 100; ++n) {
      for (const double end_of_path : {line_.entry(), line_.exit()}) {
        const double T = (end_of_path + n * line_.base_pitch() - start_) / velocity_;
        if (T > 0.0 && T < T_end) times.push_back(T);
      }
    }
    std::sort(times.begin(), times.end());
    for (std::size_t n = 1; n < times.size(); ++n) {
      const double middle = start_ + 0.5 * (times[n - 1] + times[n]) * velocity_;
      std::vector<double> offsets;  // of the contacts from start_ + velocity T
      for (const double xi : line_.contact_positions(middle)) offsets.push_back(xi - middle);
      const int steps = static_cast<int>(std::ceil((times[n] - times[n - 1]) / largest_step));
      const double dT = (times[n] - times[n - 1]) / steps;
      for (int step = 0; step < steps; ++step) motion = advance(motion, offsets, times[n - 1] + step * dT, dT);
    }
    return motion;
  }

private:
  Motion rate(const Motion& motion, const std::vector<double>& offsets, double T) const {
    double force = 0.0;
    for (const double offset : offsets) {
      ContactSolids solids = scales_.solids;
      solids.radius_x = line_.radius_x(start_ + velocity_ * T + offset);
      const double approach = hertz_contact(solids, scales_.operation.load).approach;
      force += scales_.static_force * std::pow(std::max(0.0, -motion.H0() * scales_.thickness / approach), 1.5);
    }
    return {motion.V0(), (force - scales_.static_force) / inertia_};
  }

  Motion advance(const Motion& at, const std::vector<double>& offsets, double T, double dT) const {
    const auto moved = [&](const Motion& k, double step) {
      return Motion{at.H0() + step * k.H0(), at.V0() + step * k.V0()};
    };
    const Motion k1 = rate(at, offsets, T);
    const Motion k2 = rate(moved(k1, 0.5 * dT), offsets, T + 0.5 * dT);
    const Motion k3 = rate(moved(k2, 0.5 * dT), offsets, T + 0.5 * dT);
    const Motion k4 = rate(moved(k3, dT), offsets, T + dT);
    return {at.H0() + dT / 6.0 * (k1.H0() + 2.0 * k2.H0() + 2.0 * k3.H0() + k4.H0()),
            at.V0() + dT / 6.0 * (k1.V0() + 2.0 * k2.V0() + 2.0 * k3.V0() + k4.V0())};
  }

  LineOfAction line_;
  Scales scales_;
  double inertia_;
  double velocity_;
  double start_;
};

TEST(DryMarch, three_periods_from_rest_agree_with_an_integration_of_its_own) {
  const CaseInput problem = table3_case();
  const MeshModel mesh = mesh_of(problem);
  DryMarch march(mesh, 0.05, nobody);
  march.start({});
  const Motion rest{-problem.scales.approach, 0.0};
  EXPECT_NEAR(march.motion().H0(), rest.H0(), 1e-12);
  EXPECT_EQ(march.motion().V0(), 0.0);
  const double end = 3.0 * mesh.path.mesh_period();
  march.run(end);
  // Steps of 1e-3 are exact to 1e-10 here.
  const Motion expected = RungeKutta(problem).integrate(rest, end, 1e-3);
  EXPECT_NEAR(march.motion().H0(), expected.H0(), 1e-6);
  EXPECT_NEAR(march.motion().V0(), expected.V0(), 1e-6);
}

TEST(DryForce, is_that_of_hertz_at_every_radius_of_the_path) {
  for (const char* file : {"barbieri2013.yaml", "high_contact_ratio.yaml"}) {
    const CaseInput problem = input_case(file);
    const MeshModel mesh = mesh_of(problem);
    const DryForce force(mesh);
    const LineOfAction& line = mesh.path.line();
    for (int n = 0; n <= 100; ++n) {
      const double xi = line.entry() + 0.01 * n * (line.exit() - line.entry());
      const ContactConditions conditions = meshed_contact(line, mesh.scales, mesh.path.pinion_speed(), xi).conditions;
      const double load = hertz_load(solids_of(mesh.scales, conditions), 0.8 * mesh.scales.thickness);
      EXPECT_NEAR(mesh.scales.force(force.law(conditions).force(0.8, 0.0)) / load, 1.0, 1e-12) << file << " at " << xi;
    }
  }
}

// The record's step is an output interval only.
TEST(DryMarch, the_interval_of_the_records_does_not_matter) {
  const CaseInput problem = table3_case();
  const MeshModel mesh = mesh_of(problem);
  Motion ends[2];
  for (int n : {0, 1}) {
    DryMarch march(mesh, n == 0 ? 0.026 : 1.0, nobody);
    march.start({});
    march.run(mesh.path.mesh_period());
    ends[n] = march.motion();
  }
  EXPECT_NEAR(ends[0].H0(), ends[1].H0(), 1e-8);
  EXPECT_NEAR(ends[0].V0(), ends[1].V0(), 1e-8);
}

TEST(DryMarch, records_reach_every_event_and_share_the_force) {
  const CaseInput problem = input_case("high_contact_ratio.yaml");
  const MeshModel mesh = mesh_of(problem);
  const ContactPath& path = mesh.path;
  double last = 0.0, next = path.next_event(0.0);
  int events = 0;
  DryMarch march(mesh, 0.07, [&](const StepRecord& record, const std::vector<ActiveContact>& contacts) {
    EXPECT_NEAR(record.T - record.dT, last, 1e-12);
    EXPECT_LE(record.T, next + 1e-12);
    EXPECT_EQ(contacts.size(), record.contacts.size());
    if (record.T > next - 1e-12) {
      next = path.next_event(record.T);
      ++events;
    }
    if (last == 0.0 && record.T == 0.0) {
      EXPECT_NEAR(record.pressure_integral() / problem.scales.static_force, 1.0, 1e-12);
    }
    last = record.T;
  });
  march.start({});
  march.run(2.0 * path.mesh_period());
  EXPECT_EQ(events, 4);
}

/// The pitch point held in place: a pair that hardly turns.
class FrozenGeometry : public testing::Test {
protected:
  double energy(const Motion& motion) const {
    const double reference = problem.scales.approach;
    const double compressed = std::max(0.0, -motion.H0());
    return 0.5 * mesh.inertia * motion.V0() * motion.V0() +
           0.4 * problem.scales.static_force * std::pow(compressed / reference, 1.5) * compressed +
           problem.scales.static_force * motion.H0();
  }

  CaseInput problem = table3_case();
  MeshModel mesh{.scales = problem.scales,
                 .path = ContactPath(*problem.pair.line, problem.scales, 1e-15 * problem.pair.pinion_speed, 0.0),
                 .inertia = problem.scales.inertia(*problem.pair.equivalent_mass),
                 .stiffness = problem.pair.stiffness};
  double H0_at_rest = -problem.scales.approach;
};

/// A start above or below balance.
struct FrozenMotion {
  Motion start;
  bool loses_contact;
};

// Some thousand steps, each to 1e-10; where contact is lost and comes back the force is not smooth.
TEST_F(FrozenGeometry, energy_is_conserved) {
  for (const auto& [start, loses_contact] :
       {FrozenMotion{{1.4 * H0_at_rest, 0.0}, false}, FrozenMotion{{2.0 * H0_at_rest, 0.1}, true}}) {
    const double total = energy(start);
    double largest_H0 = start.H0(), drift = 0.0;
    DryMarch march(mesh, 0.1, [&](const StepRecord& record, const std::vector<ActiveContact>&) {
      largest_H0 = std::max(largest_H0, record.motion.H0());
      drift = std::max(drift, std::abs(energy(record.motion) - total));
    });
    march.start(start);
    march.run(40.0);
    EXPECT_EQ(largest_H0 > 0.1, loses_contact);
    report("energy drifts by %.1e of %.3f", drift, total - energy({H0_at_rest, 0.0}));
    EXPECT_LT(drift, (loses_contact ? 1e-7 : 1e-8) * (total - energy({H0_at_rest, 0.0})));
  }
}

// Three halves is no whole power: the period of an oscillation differs from the linear one with the amplitude squared.
TEST_F(FrozenGeometry, small_oscillations_have_the_natural_frequency) {
  const double frequency = natural_frequency(mesh.stiffness_si(), *problem.pair.equivalent_mass);
  const double period = 1.0 / (frequency * problem.scales.time);
  DryMarch march(mesh, 0.1, nobody);
  const double amplitude = 1e-4 * std::abs(H0_at_rest);
  march.start(Motion{H0_at_rest + amplitude, 0.0});
  // After ten periods and a quarter only the velocity is left.
  march.run(10.25 * period);
  EXPECT_NEAR(march.motion().H0() - H0_at_rest, 0.0, 1e-3 * amplitude);
  EXPECT_NEAR(march.motion().V0(), -2.0 * std::numbers::pi / period * amplitude,
              1e-3 * 2.0 * std::numbers::pi / period * amplitude);
}

}  // namespace
}  // namespace gearfilm
