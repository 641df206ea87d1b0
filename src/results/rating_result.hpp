// The ratings of a pair: least safeties of a time, where they are met, and the limits that were used.
#pragma once

#include <vector>

#include "dynamics/step_record.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// What contacts give for ratings, step by step.
class RatingHistory {
public:
  explicit RatingHistory(const MeshModel& mesh) : mesh_(mesh) {}

  /// A step that is not later than those before, of a march that began again, takes their place.
  void add(const StepRecord& record);

  /// The table `safety` over [T_begin, T_end]: for each rating an object, or null where nothing is known of it.
  Summary safeties(double T_begin, double T_end) const;

private:
  struct Moment {
    double T;
    int contact;
    double xi;  ///< [m]
    double contact_stress;
    std::array<double, 2> root_stress;
    double film_ratio, smallest_film;  ///< lambda_GF; [m]
    double temperature, flash;         ///< [K]
  };

  std::vector<Moment> between(double T_begin, double T_end) const;
  Summary pitting(const std::vector<Moment>& moments) const;
  Summary root(const std::vector<Moment>& moments, std::size_t gear) const;
  Summary flash(const std::vector<Moment>& moments) const;
  Summary integral(const std::vector<Moment>& moments) const;
  Summary micropitting(const std::vector<Moment>& moments) const;

  const MeshModel& mesh_;
  std::vector<Moment> moments_;
};

/// The table of one contact at rest, of a pair that is rated.
Summary safeties_at_rest(const MeshModel& mesh, const ContactRecord& contact);

/// What is in the table, in the manual's Markdown.
std::string rating_markdown();

}  // namespace gearfilm
