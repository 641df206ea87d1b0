#include "input/case_face.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/hertz.hpp"
#include "elasticity/row_contact.hpp"
#include "film/expected_errors.hpp"
#include "gearfilm/error.hpp"
#include "input/point_table.hpp"

namespace gearfilm {
namespace {

EndFace read_end_face(const ParameterValues& values, const std::string& section) {
  const std::string& name = values.text(section + ".end_face");
  if (name == "half_space") return EndFace::half_space;
  return name == "mirror" ? EndFace::mirror : EndFace::free;
}

struct Body {
  double modulus, poisson_ratio;
  bool ends;  ///< with the face
};

/// Those that end with it, both as one where they are of one material.
std::vector<EndingBody> ending_bodies(const std::vector<Body>& bodies) {
  const auto compliance = [](const Body& body) {
    return (1.0 - body.poisson_ratio * body.poisson_ratio) / body.modulus;
  };
  const double sum = compliance(bodies[0]) + compliance(bodies[1]);
  std::vector<EndingBody> ending;
  for (const Body& body : bodies) {
    if (!body.ends) continue;
    const double share = compliance(body) / sum;
    if (!ending.empty() && ending[0].poisson_ratio == body.poisson_ratio) {
      ending[0].share += share;
    } else {
      ending.push_back({share, body.poisson_ratio});
    }
  }
  return ending;
}

/// The end relief that a section has, if any.
void read_end_relief(const ParameterValues& values, const std::string& section, double face_width, FaceGap& gap) {
  const std::string amount = section + ".end_relief", length = section + ".end_relief_length";
  if (values.real(amount) == 0.0) {
    if (values.has(length)) values.refuse(length, "is given, but not '" + amount + "'; give both or neither");
    return;
  }
  if (!values.has(length)) values.refuse(amount, "is given without '" + length + "'; give both");
  if (values.real(length) > 0.5 * face_width) {
    values.refuse(length, "is " + format_value(values.real(length)) + " m, more than half the face width of " +
                              format_value(face_width) + " m; give at most " + format_value(0.5 * face_width));
  }
  gap.reliefs.push_back({.amount = values.real(amount),
                         .length = values.real(length),
                         .power = values.text(section + ".end_relief_shape") == "linear" ? 1 : 2});
}

void require_small_slope(const ParameterValues& values, const Face& face, const std::vector<std::string>& names) {
  if (std::abs(face.gap.slope) <= largest_face_slope) return;
  const std::string& name =
      *std::ranges::max_element(names, {}, [&](const std::string& of) { return std::abs(values.real(of)); });
  values.refuse(name, "is " + format_value(values.real(name)) + " m, and the flanks part by " +
                          format_value(std::abs(face.gap.slope) * face.width) + " m over a face of " +
                          format_value(face.width) + " m, which lifts them off each other; give at most " +
                          format_value(largest_face_slope * face.width) + ", for both gears and their shafts together");
}

/// The points (y, material removed) of a measured lead, if any.
void read_lead(const ParameterValues& values, const std::string& name, double face_width, FaceGap& gap) {
  if (!values.has(name)) return;
  gap.tables.push_back(read_ascending_points(
      values, name,
      "a point of the lead; give two numbers, y from the middle of the face [m] and material removed "
      "[m]"));
  for (const auto& [y, removed] : gap.tables.back()) {
    if (std::abs(y) > (0.5 + 1e-9) * face_width) {
      values.refuse(name, "has a point at y = " + format_value(y) + " m, beyond the end of the face at " +
                              format_value(0.5 * face_width) + " m; give points on the face");
    }
  }
}

}  // namespace

std::shared_ptr<const Face> read_face_of_contact(const ParameterValues& values) {
  const std::string width = "contact.face_width";
  if (!values.has(width)) {
    for (const std::string name : {"contact.end_relief", "contact.misalignment", "contact.logarithmic_profile"}) {
      if (values.real(name) != 0.0) values.refuse(name, "is given without '" + width + "'; give the width of the face");
    }
    return {};
  }
  Face face;
  face.width = values.real(width);
  face.gap.slope = values.real("contact.misalignment") / face.width;
  face.gap.logarithmic = values.real("contact.logarithmic_profile");
  require_small_slope(values, face, {"contact.misalignment"});
  read_end_relief(values, "contact", face.width, face.gap);
  face.end = read_end_face(values, "contact");
  face.mirror_factor = values.real("contact.end_face_factor");
  // Steel, where only the reduced modulus is given.
  constexpr double of_steel = 0.3;
  const auto poisson_ratio = [&](const std::string& body) {
    return values.real_if_given("contact.poisson_ratio_" + body).value_or(of_steel);
  };
  std::vector<Body> bodies;
  for (const std::string body : {"1", "2"}) {
    bodies.push_back({values.real_if_given("contact.youngs_modulus_" + body).value_or(1.0), poisson_ratio(body), true});
  }
  face.ending = ending_bodies(bodies);
  return std::make_shared<const Face>(face);
}

std::shared_ptr<const Face> read_face_of_pair(const ParameterValues& values) {
  Face face;
  face.width = values.real("gear.face_width");
  face.gap.slope = values.real("gear.misalignment") / face.width;
  face.end = read_end_face(values, "gear");
  face.mirror_factor = values.real("gear.end_face_factor");
  std::vector<Body> bodies;
  for (const std::string gear : {"pinion", "wheel"}) {
    const std::string own_width = gear + ".face_width";
    face.gap.slope += values.real(gear + ".lead_slope") / face.width;
    read_end_relief(values, gear, face.width, face.gap);
    read_lead(values, gear + ".lead_file", face.width, face.gap);
    const double width = values.real_if_given(own_width).value_or(face.width);
    if (width < face.width) {
      values.refuse(own_width, "is " + format_value(width) +
                                   " m, less than 'gear.face_width', which is that of the "
                                   "contact; give that of the narrower gear there");
    }
    bodies.push_back(
        {values.real(gear + ".youngs_modulus"), values.real(gear + ".poisson_ratio"), width == face.width});
  }
  require_small_slope(values, face, {"gear.misalignment", "pinion.lead_slope", "wheel.lead_slope"});
  face.ending = ending_bodies(bodies);
  return std::make_shared<const Face>(face);
}

namespace {

bool reaches_ends(const Face& face, const ContactSolids& solids, double load) {
  constexpr double spare = 1.06;  // as much as a domain about the ellipse has beyond it at least
  if (!std::isfinite(solids.radius_y) || face.gap.slope != 0.0) return true;
  return !face.plain_around(0.0, spare * hertz_contact(solids, load).b);
}

}  // namespace

void set_face(const ParameterValues& values, const std::shared_ptr<const Face>& face, double load,
              ContactSolids& solids) {
  const std::string whole = "grid.whole_face";
  if (!face) {
    if (values.text(whole) == "yes") values.refuse(whole, "is yes, but no 'contact.face_width' is given; give it");
    return;
  }
  if (values.text(whole) == "yes" || reaches_ends(*face, solids, load)) solids.face = face;
}

namespace {

/// Half the length of a contact along the face [m]: of the ellipse where flanks are crowned, at most half the face.
double half_length(ContactSolids solids, double load) {
  constexpr double straight = 1e-6;  // R_x/R_y of flanks that have no ellipse
  const double half_face = 0.5 * solids.face->width;
  if (solids.radius_x <= straight * solids.radius_y) return half_face;
  solids.face.reset();
  return std::min(half_face, hertz_contact(solids, load).b);
}

/// By how much rows are closer where a case asks for more than usual accuracy.
double part_by_accuracy(const ParameterValues& values) {
  return std::sqrt(std::min(1.0, values.real("grid.accuracy") / usual_accuracy));
}

/// Away from ends and kinks pressure changes over the whole contact, or with the waves of the flanks.
double longest_between_rows(const ParameterValues& values, const Scales& scales, double longest_by_waves) {
  constexpr double always = 2.5, part_of_contact = 0.1;
  const double contact = half_length(scales.solids, scales.operation.load);
  const double by_contact = std::min(part_of_contact * part_by_accuracy(values) * contact, longest_by_waves);
  return std::max(always * part_by_accuracy(values), by_contact / scales.length);
}

/// Where a contact ends within the face, it does as at the tip of an ellipse whose half-width grows alike, with
/// d(s^2)/dY = 2 a^2/b: its film tears on rows that are farther apart than that ellipse allows.
RowPlace place_of(const ContactEnd& end, FilmDiscretisation discretisation, const Scales& scales) {
  ExpectedFilm tip(scales);
  tip.ellipticity = 0.5 * end.widening;
  return {end.y, longest_side_step(discretisation, tip) / tip.ellipticity};
}

/// With what dry contacts reach and where they end, no closer than at ends of the face. Their own rows begin coarse.
/// Throws SolveError.
RowGrading following_contacts(const RowGrading& given, const Scales& scales, FilmDiscretisation discretisation,
                              double by_accuracy) {
  constexpr std::array ratios = {2.0, 1.5, 1.2, 1.0, 0.8, 0.65, 0.5, 0.35, 0.2, 0.1, 0.05};  // of the static force
  std::vector<double> forces(ratios.begin(), ratios.end());
  for (double& force : forces) force *= scales.static_force;
  RowGrading grading = given, of_rows = coarse_grading(scales);
  for (int pass = 0; pass < 2; ++pass) {
    const LoadedFace face = loaded_face(scales, forces, of_rows);
    grading.reached = face.reached;
    grading.contact_ends.clear();
    for (const ContactEnd& end : face.ends) {
      const RowPlace place = place_of(end, discretisation, scales);
      grading.contact_ends.push_back({place.y, std::max(given.first, by_accuracy * place.step)});
    }
    of_rows.contact_ends = grading.contact_ends;
  }
  return grading;
}

}  // namespace

RowGrading read_row_grading(const ParameterValues& values, const Scales& scales, FilmDiscretisation discretisation,
                            double longest_by_waves) {
  const FaceGap& gap = scales.solids.face->gap;
  const bool sharp = gap.reliefs.empty() && gap.logarithmic == 0.0;
  RowGrading grading;
  grading.first = values.real_if_given("grid.first_row").value_or(sharp ? 0.03 : 0.06);
  grading.growth = values.real("grid.row_growth");
  grading.largest =
      values.real_if_given("grid.largest_row").value_or(longest_between_rows(values, scales, longest_by_waves));
  if (discretisation == FilmDiscretisation::central) {  // for comparison with films on rows of ends and kinks alone
    grading.bend = grading.kink;
    return grading;
  }
  try {
    return following_contacts(grading, scales, discretisation, part_by_accuracy(values));
  } catch (const SolveError&) {
    return grading;  // who needs the dry contact says what it lacks
  }
}

}  // namespace gearfilm
