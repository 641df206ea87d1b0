#include "input/case_face.hpp"

#include <algorithm>
#include <cmath>

#include "contact/hertz.hpp"

namespace gearfilm {
namespace {

EndFace read_end_face(const ParameterValues& values, const std::string& section) {
  const std::string& name = values.text(section + ".end_face");
  if (name == "half_space") return EndFace::half_space;
  return name == "mirror" ? EndFace::mirror : EndFace::free;
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
  read_end_relief(values, "contact", face.width, face.gap);
  face.end = read_end_face(values, "contact");
  face.mirror_factor = values.real("contact.end_face_factor");
  constexpr double of_steel = 0.3;
  const auto poisson_ratio = [&](const std::string& body) {
    return values.real_if_given("contact.poisson_ratio_" + body).value_or(of_steel);
  };
  double sum = 0.0;
  for (const std::string body : {"1", "2"}) {
    const double nu = poisson_ratio(body);
    const double modulus = values.real_if_given("contact.youngs_modulus_" + body).value_or(1.0);
    face.ending.push_back({.share = (1.0 - nu * nu) / modulus, .poisson_ratio = nu});
    sum += face.ending.back().share;
  }
  for (EndingBody& body : face.ending) body.share /= sum;
  if (face.ending[0].poisson_ratio == face.ending[1].poisson_ratio) {
    face.ending = {{.share = 1.0, .poisson_ratio = face.ending[0].poisson_ratio}};
  }
  return std::make_shared<const Face>(face);
}

bool reaches_ends(const Face& face, const ContactSolids& solids, double load) {
  constexpr double spare = 1.1;
  if (!std::isfinite(solids.radius_y) || face.gap.slope != 0.0) return true;
  return !face.plain_around(0.0, spare * hertz_contact(solids, load).b);
}

RowGrading read_row_grading(const ParameterValues& values, const Face& face) {
  const bool sharp = face.gap.reliefs.empty() && face.gap.logarithmic == 0.0;
  RowGrading grading;
  grading.first = values.real_if_given("grid.first_row").value_or(sharp ? 0.03 : 0.06);
  grading.growth = values.real("grid.row_growth");
  grading.largest = values.real("grid.largest_row");
  return grading;
}

}  // namespace gearfilm
