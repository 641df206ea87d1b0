#include "input/case_with_parameter.hpp"

#include <algorithm>
#include <deque>
#include <memory>
#include <utility>

#include "input/case_setup.hpp"

namespace gearfilm {

CaseInput case_with_parameter(const CaseInput& problem, const std::string& parameter, double value) {
  ParameterValues values = problem.parameters;
  values.set(parameter, format_value(value), "value of what is varied");
  // Films go from point to point: all are on the grid that the case has by itself.
  const PairNumerics& numerics = problem.numerics;
  const auto keep = [&](const std::string& name, const std::string& text) {
    if (!values.has(name)) values.set(name, text, "grid of what is varied");
  };
  keep("grid.nx", std::to_string(numerics.nx));
  keep("grid.x_min", format_value(numerics.domain.x_min));
  keep("grid.x_max", format_value(numerics.domain.x_max));
  if (!numerics.face_rows) {
    keep("grid.ny", std::to_string(numerics.ny));
    keep("grid.y_half", format_value(numerics.domain.y_half));
  }
  return make_case_like(problem, values);
}

CaseInput over_whole_face(const CaseInput& problem) {
  ParameterValues values = problem.parameters;
  values.set(whole_face_parameter, "yes", "the choice of rows by the program");
  return make_case_like(problem, values);
}

CaseInput case_of_sweep(const CaseInput& problem, double value) {
  return problem.sweep.kind == SweepKind::basins ? problem
                                                 : case_with_parameter(problem, problem.sweep.parameter, value);
}

namespace {

/// Those of a point and its neighbour are asked for again and again.
template <class Value>
std::function<Value(double)> remembered(std::function<Value(double)> make) {
  constexpr std::size_t most = 8;
  auto kept = std::make_shared<std::deque<std::pair<double, Value>>>();
  return [make = std::move(make), kept](double value) {
    const auto known = std::ranges::find(*kept, value, &std::pair<double, Value>::first);
    if (known != kept->end()) return known->second;
    if (kept->size() == most) kept->pop_front();
    kept->emplace_back(value, make(value));
    return kept->back().second;
  };
}

}  // namespace

CaseAt cases_of_sweep(const CaseInput& problem) {
  return remembered<CaseInput>([&problem](double value) { return case_of_sweep(problem, value); });
}

ProblemAt problems_of_sweep(const CaseAt& case_at) {
  return remembered<OrbitProblem>([case_at](double value) { return orbit_problem(case_at(value)); });
}

ProblemAt problems_at_speeds(const CaseInput& problem) {
  return [&problem](double ratio) {
    const std::string speed = "pinion.speed_rpm";
    return orbit_problem(case_with_parameter(problem, speed, ratio * problem.parameters.real(speed)));
  };
}

}  // namespace gearfilm
