// Bearings of a gear by its keys (train_parts.hpp): all together, or two at a distance.
#include "gearfilm/error.hpp"
#include "input/parameter.hpp"
#include "input/plain_text.hpp"
#include "input/train_parts.hpp"

namespace gearfilm {
namespace {

/// The matrix of bearing_stiffness and its parts.
Eigen::Matrix2d read_stiffness(const ParameterValues& values, const std::string& all) {
  const std::string x = all + "_x", y = all + "_y", xy = all + "_xy";
  const double coupling = values.real_if_given(xy).value_or(0.0);
  Eigen::Matrix2d stiffness{{values.real(values.has(all) ? all : x), coupling},
                            {coupling, values.real(values.has(all) ? all : y)}};
  if (!is_positive(stiffness)) {
    values.refuse(xy, "is " + format_value(coupling) +
                          " N/m, with which the bearings do not hold the gear in every direction; its square must be "
                          "below the product of the other two");
  }
  return stiffness;
}

/// Where a span is given.
std::optional<TwoBearings> read_two(const ParameterValues& values, const std::string& gear,
                                    const Eigen::Matrix2d& stiffness) {
  const std::string span = gear + ".bearing_span", offset = gear + ".bearing_offset";
  const std::string all = gear + ".bearing_stiffness", second = all + "_2";
  if (!values.has(span)) {
    for (const std::string& key : {offset, second}) {
      if (values.has(key)) {
        values.refuse(key, "is given, but not " + in_quotes(span) + "; give the distance of both bearings");
      }
    }
    return {};
  }
  if (values.has(second) && !values.has(all)) {
    values.refuse(second,
                  "is given beside a stiffness by directions, in which both bearings are alike; delete it, or "
                  "give " +
                      in_quotes(all));
  }
  TwoBearings two{
      .span = values.real(span), .offset = values.real_if_given(offset).value_or(0.0), .stiffness = stiffness};
  if (values.has(second)) two.ratio = values.real(all) / values.real(second);
  return two;
}

}  // namespace

void add_gear_bearings(const ParameterValues& values, std::size_t gear, TrainParts& parts) {
  const std::string of = parts.nodes[gear].name + ".bearing_";
  const std::string all = of + "stiffness", x = all + "_x", y = all + "_y", xy = all + "_xy";
  const std::string ratio = of + "damping_ratio";
  for (const std::string& part : {x, y, xy}) values.require_not_both(all, part, "; delete one");
  values.require_both(x, y, "give both, or " + in_quotes(all));
  if (!values.has(all) && !values.has(x)) {
    for (const std::string& key : {xy, ratio, of + "span", of + "offset", all + "_2"}) {
      if (values.has(key)) values.refuse(key, "is given without a stiffness; give " + in_quotes(all));
    }
    return;
  }
  const Eigen::Matrix2d stiffness = read_stiffness(values, all);
  parts.two_bearings[gear] = read_two(values, parts.nodes[gear].name, stiffness);
  parts.bearings.push_back({gear,
                            {.stiffness = parts.two_bearings[gear] ? parts.two_bearings[gear]->at_gear() : stiffness,
                             .damping_ratio = values.real_if_given(ratio)}});
}

}  // namespace gearfilm
