#include "gearfilm/case.hpp"

#include <algorithm>
#include <cmath>

#include "gearfilm/error.hpp"
#include "gearfilm/oil.hpp"
#include "input/case_file.hpp"
#include "input/case_numerics.hpp"
#include "input/case_setup.hpp"

namespace gearfilm {
namespace {

constexpr const char* origin = "value given by the program";

}  // namespace

// The library prints nothing.
Case::Case(CaseInput input) {
  input.numerics.on_widening = widening_check(contacts_at_a_time(input), heated_points(input));
  input_ = std::make_shared<const CaseInput>(std::move(input));
}

Case::Case(MPI_Comm comm, const Values& values)
    : Case(make_case(with_values(comm, ParameterValues("values given by the program"), values, origin))) {}

Case Case::read(MPI_Comm comm, const std::string& file) { return Case(read_case(comm, file)); }

Case Case::with(MPI_Comm comm, const Values& values) const {
  return Case(make_case_like(*input_, with_values(comm, input_->parameters, values, origin)));
}

std::string Case::name() const { return input_->name; }

std::string Case::value(const std::string& key) const {
  require_known_key(key, origin);
  const std::vector<EchoedValue> all = input_->parameters.echo();
  const auto found = std::ranges::find(all, key, &EchoedValue::name);
  return found == all.end() ? "" : found->value;
}

double Case::half_axis() const { return input_->scales.length; }
double Case::hertz_pressure() const { return input_->scales.pressure; }
double Case::static_force() const { return input_->scales.operation.load; }
double Case::entrainment_velocity() const { return input_->scales.operation.entrainment_velocity; }

double Case::mesh_period() const {
  if (!input_->pair.line) throw InputError("the case '" + name() + "' is a bare contact, which has no mesh");
  return gearfilm::mesh_period(*input_) * input_->scales.time;
}

double Oil::viscosity(double pressure) const {
  const Lubricant& oil = case_.input().scales.oil;
  return oil.viscosity * std::exp(log_relative_viscosity(oil, pressure).value);
}

double Oil::density_ratio(double pressure) const { return relative_density(case_.input().scales.oil, pressure).value; }

double Oil::pressure_viscosity() const { return case_.input().scales.oil.pressure_viscosity; }
double Oil::temperature() const { return case_.input().scales.oil.temperature; }

}  // namespace gearfilm
