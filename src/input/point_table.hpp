// Tables of points in text files that a case names: two numbers a line, # begins a remark.
#pragma once

#include <utility>
#include <vector>

#include "input/parameter_values.hpp"

namespace gearfilm {

/// The points of the file that a parameter names; what: what a line should be, for the message of one that is not.
/// Throws InputError.
std::vector<std::pair<double, double>> read_points(const ParameterValues& values, const std::string& name,
                                                   const std::string& what);

/// Reads points whose first numbers must grow; at least two.
std::vector<std::pair<double, double>> read_ascending_points(const ParameterValues& values, const std::string& name,
                                                             const std::string& what);

/// The numbers of a list, separated by commas or blanks, within a range; what: what each of them is. Throws InputError.
std::vector<double> read_numbers(const ParameterValues& values, const std::string& name, double smallest,
                                 double largest, const std::string& what);
/// Reads numbers from the file that a parameter names; # begins a remark.
std::vector<double> read_numbers_in_file(const ParameterValues& values, const std::string& name, double smallest,
                                         double largest, const std::string& what);

}  // namespace gearfilm
