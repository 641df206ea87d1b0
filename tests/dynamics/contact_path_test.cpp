// Which contacts exist when: the path of contact of pairs with contact ratios from one to beyond two.
#include <algorithm>

#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// A pair of input/, or the same with its tip circles set for another contact ratio.
struct PathOf {
  const char* name;
  const char* file;
  double contact_ratio;  ///< 0: as it is
};

std::ostream& operator<<(std::ostream& out, const PathOf& pair) { return out << pair.name; }

/// Both addenda are scaled alike.
LineOfAction line_with_contact_ratio(const SpurGearPair& pair, double contact_ratio) {
  const auto line = [&](double scale) {
    SpurGearPair scaled = pair;
    for (SpurGear* gear : {&scaled.pinion, &scaled.wheel}) {
      const double pitch_radius = gear->teeth * pair.module_length / 2.0;
      gear->outer_radius = pitch_radius + scale * (gear->outer_radius - pitch_radius);
    }
    return LineOfAction(scaled);
  };
  // A contact ratio below one would be refused: the scale that is looked for is the upper end.
  double low = 0.5, high = 1.1;
  while (high - low > 4e-16) {
    const double middle = 0.5 * (low + high);
    bool above = false;
    try {
      above = line(middle).contact_ratio() >= contact_ratio;
    } catch (const InputError&) {
    }
    (above ? high : low) = middle;
  }
  return line(high);
}

/// The contacts between two events.
struct Segment {
  double begin = 0.0;
  double end = 0.0;
  std::vector<int> contacts;
};

class PathOfContact : public testing::TestWithParam<PathOf> {
protected:
  /// Just after the leaving of a contact, unless said otherwise.
  ContactPath path() const { return path(line.exit() - line.base_pitch()); }
  ContactPath path(double start) const { return {line, pair.scales, pair.pair.pinion_speed, start}; }

  static std::vector<Segment> segments(const ContactPath& path, double periods) {
    std::vector<Segment> list;
    for (double T = 0.0; T < (periods - 1e-8) * path.mesh_period();) {
      list.push_back({T, path.next_event(T), path.contacts_after(T)});
      T = list.back().end;
      if (list.back().begin >= T) throw std::logic_error("the next event is not ahead");
    }
    return list;
  }

  /// True when an entering and a leaving are one event.
  bool whole() const { return std::abs(line.contact_ratio() - std::round(line.contact_ratio())) < 1e-9; }

  CaseInput pair = input_case(GetParam().file);
  LineOfAction line = GetParam().contact_ratio > 0.0
                          ? line_with_contact_ratio(*pair.pair.gears, GetParam().contact_ratio)
                          : *pair.pair.line;
};

constexpr double many_periods = 1000.0;
// Events are found to 1e-9 of a mesh period.
constexpr double event_tolerance = 2e-9;

TEST_P(PathOfContact, contact_ratio_is_the_mean_number_of_contacts) {
  const double ratio = line.contact_ratio();
  if (GetParam().contact_ratio > 0.0) {
    ASSERT_NEAR(ratio, GetParam().contact_ratio, 1e-13);
  }
  const ContactPath contacts = path();
  const double end = many_periods * contacts.mesh_period();
  double contact_time = 0.0;
  for (const Segment& segment : segments(contacts, many_periods)) {
    const double number = static_cast<double>(segment.contacts.size());
    EXPECT_NEAR(number, ratio, 1.0) << "at T = " << segment.begin;
    contact_time += number * (std::min(segment.end, end) - segment.begin);
  }
  EXPECT_NEAR(contact_time / end, ratio, event_tolerance);
}

TEST_P(PathOfContact, numbers_are_continuous_and_the_lowest_leads) {
  const ContactPath contacts = path();
  for (const Segment& segment : segments(contacts, many_periods)) {
    ASSERT_FALSE(segment.contacts.empty()) << "at T = " << segment.begin;
    for (const double T : {segment.begin, 0.5 * (segment.begin + segment.end)}) {
      EXPECT_EQ(contacts.contacts_after(T), segment.contacts) << "at T = " << T;
      const double leading = contacts.position(segment.contacts.front(), T);
      for (std::size_t n = 0; n < segment.contacts.size(); ++n) {
        EXPECT_EQ(segment.contacts[n], segment.contacts.front() + static_cast<int>(n));
        const double xi = contacts.position(segment.contacts[n], T);
        // Round-off of xi grows with the length travelled, some ten metres.
        EXPECT_NEAR(xi, leading - n * line.base_pitch(), 1e-14);
        EXPECT_GE(xi, line.entry() - event_tolerance * line.base_pitch());
        EXPECT_LE(xi, line.exit() + event_tolerance * line.base_pitch());
      }
    }
  }
}

TEST_P(PathOfContact, entries_and_exits_alternate) {
  const ContactPath contacts = path();
  const std::vector<Segment> list = segments(contacts, many_periods);
  int entries = 0, exits = 0;
  for (std::size_t n = 1; n < list.size(); ++n) {
    const std::vector<int>&before = list[n - 1].contacts, &after = list[n].contacts;
    const int entered = after.back() - before.back(), left = after.front() - before.front();
    entries += entered;
    exits += left;
    ASSERT_EQ(entered + left, whole() ? 2 : 1) << "at T = " << list[n].begin;
    if (!whole()) {
      ASSERT_TRUE(entries == exits || entries == exits + 1) << "at T = " << list[n].begin;
    }
    if (entered == 1) {
      EXPECT_NEAR(contacts.position(after.back(), list[n].begin), line.entry(), event_tolerance * line.base_pitch());
    }
    if (left == 1) {
      EXPECT_NEAR(contacts.position(before.front(), list[n].begin), line.exit(), event_tolerance * line.base_pitch());
    }
  }
  // The last period ends with the leaving that began the first; the march stops on it, or just before.
  EXPECT_NEAR(entries, many_periods, 1.0);
  EXPECT_NEAR(exits, many_periods, 1.0);
}

TEST_P(PathOfContact, contact_number_0_leads_after_a_leaving) {
  const ContactPath contacts = path();
  const std::vector<int> present = contacts.contacts_after(0.0);
  EXPECT_EQ(present.size(), static_cast<std::size_t>(std::floor(line.contact_ratio() + 1e-9)));
  EXPECT_EQ(present.front(), 0);
  EXPECT_NEAR(contacts.position(0, 0.0), line.exit() - line.base_pitch(), 1e-15);
}

TEST_P(PathOfContact, all_starts_that_place_a_contact_alike_are_the_same_march) {
  for (const double start : {0.0, 0.5 * line.exit(), line.entry(), line.exit() - 1e-6}) {
    const ContactPath first = path(start);
    for (const double xi : line.contact_positions(start)) {
      const ContactPath other = path(xi);
      EXPECT_EQ(other.contacts_after(0.0), first.contacts_after(0.0)) << "xi = " << xi;
      EXPECT_EQ(other.contacts_after(0.0).front(), 0) << "xi = " << xi;
      EXPECT_NEAR(other.position(0, 0.0), first.position(0, 0.0), 1e-15) << "xi = " << xi;
      EXPECT_NEAR(other.next_event(0.0), first.next_event(0.0), 1e-9) << "xi = " << xi;
    }
  }
}

TEST_P(PathOfContact, conditions_follow_the_line_of_action) {
  const ContactPath contacts = path(0.0);
  const int at_pitch = static_cast<int>(std::lround(contacts.position(0, 0.0) / line.base_pitch()));
  const MeshModel mesh{pair.scales, contacts};
  const ContactConditions pitch = mesh.contact(at_pitch, 0.0).conditions;
  EXPECT_NEAR(pitch.relative_radius, 1.0, 1e-12);
  EXPECT_NEAR(pitch.entrainment, 1.0, 1e-12);
  for (const double T : {0.3, 4.1, 12.9}) {
    for (const int contact : contacts.contacts_after(T)) {
      const double xi = contacts.position(contact, T);
      const ContactConditions there = mesh.contact(contact, T).conditions;
      EXPECT_NEAR(there.relative_radius, line.radius_x(xi) / line.radius_x(0.0), 1e-12);
      EXPECT_NEAR(there.entrainment,
                  line.entrainment_velocity(xi, pair.pair.pinion_speed) /
                      line.entrainment_velocity(0.0, pair.pair.pinion_speed),
                  1e-12);
    }
  }
  EXPECT_NEAR(contacts.mesh_period() * pair.scales.time * mesh_frequency(*pair.pair.gears, pair.pair.pinion_speed), 1.0,
              1e-12);
}

INSTANTIATE_TEST_SUITE_P(contact_ratios, PathOfContact,
                         testing::Values(PathOf{"ratio_1.29", "barbieri2013.yaml", 0.0},
                                         PathOf{"ratio_2.38", "high_contact_ratio.yaml", 0.0},
                                         PathOf{"ratio_1", "barbieri2013.yaml", 1.0 + 1e-13},
                                         PathOf{"ratio_just_above_1", "barbieri2013.yaml", 1.0 + 1e-6},
                                         PathOf{"ratio_just_below_2", "high_contact_ratio.yaml", 2.0 - 1e-6},
                                         PathOf{"ratio_2", "high_contact_ratio.yaml", 2.0},
                                         PathOf{"ratio_just_above_2", "high_contact_ratio.yaml", 2.0 + 1e-6}),
                         [](const auto& pair) {
                           std::string name = pair.param.name;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

TEST(HeldGeometry, contacts_stay_and_no_event_comes) {
  const CaseInput problem = table3_case();
  const ContactPath path(*problem.pair.line, problem.scales, problem.pair.pinion_speed, 4e-3, MeshGeometry::held);
  const ContactPath moving(*problem.pair.line, problem.scales, problem.pair.pinion_speed, 4e-3);
  for (double T : {0.0, 3.0, 1e4}) {
    EXPECT_EQ(path.contacts_after(T), moving.contacts_after(0.0));
    EXPECT_DOUBLE_EQ(path.position(1, T), moving.position(1, 0.0));
    EXPECT_EQ((MeshModel{problem.scales, path}.contact(0, T).conditions),
              (MeshModel{problem.scales, moving}.contact(0, 0.0).conditions));
    EXPECT_TRUE(std::isinf(path.next_event(T)));
    EXPECT_EQ(path.distance(T), 0.0);
  }
  EXPECT_DOUBLE_EQ(path.mesh_period(), moving.mesh_period());
}

}  // namespace
}  // namespace gearfilm
