// Histories of stress at the points of a flank as a contact passes over them.
//
// While a contact travels, the stresses in the section below it are kept with its place xi. A point of the flank is at
// x(s, xi) in the contact (flank_path.hpp): its history are the stresses there, straight between lines of the section,
// while it lies in the section; before and behind it there is none. Force, radius and speed change on the way over one
// point, so that the section of one moment is no history: with it the largest Dang Van stress of a case study comes out
// 5 to 8 % higher.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "fatigue/flank_path.hpp"
#include "stress/section_stress.hpp"

namespace gearfilm {

/// Lines of a section in metres.
struct SectionPlaces {
  double first = 0.0;
  double step = 0.0;
  int count = 0;
};

/// Stresses of one body at one moment, at the depths of this process, as they are kept: xx yy zz xz, and yz xy where
/// the section is not one of symmetry.
struct SectionRecord {
  double xi = 0.0;  ///< of the contact [m]
  SectionPlaces places{};
  int components = 0;
  int depths = 0;
  std::vector<float> values;  ///< [depth][component][line], in units of pressure

  Stress at(int depth, double x) const;
};

/// stress_unit: of the section's values [Pa]; the record is in Pa.
SectionRecord section_record(double xi, const SectionPlaces& places, const SectionStress& section, double stress_unit,
                             bool symmetric);

/// A section thinned to points of the flank at equal distances, where these are fewer than its lines. Nothing is lost,
/// since the history of a point is straight between lines.
SectionRecord at_points(const SectionRecord& record, const FlankPath& path, std::span<const double> points);

/// What a point of a flank feels, one state after the other.
struct PointHistory {
  std::vector<double> x;  ///< of the point in the contact [m], increasing
  std::vector<Stress> stress;
};

class FlankHistory {
public:
  explicit FlankHistory(const FlankPath& path) : path_(path) {}

  /// Keeps records by increasing xi.
  void add(SectionRecord record);
  const std::vector<SectionRecord>& records() const { return records_; }
  const FlankPath& path() const { return path_; }
  void clear() { records_.clear(); }

  /// Stresses at a point s [m] and a depth of this process while the contact's section holds the point [Pa].
  PointHistory at(double s, int depth) const;

private:
  FlankPath path_;
  std::vector<SectionRecord> records_;
};

}  // namespace gearfilm
