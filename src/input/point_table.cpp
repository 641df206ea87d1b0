#include "input/point_table.hpp"

#include <algorithm>
#include <sstream>

#include "gearfilm/error.hpp"

namespace gearfilm {

std::vector<std::pair<double, double>> read_points(const ParameterValues& values, const std::string& name,
                                                   const std::string& what) {
  std::istringstream stream(values.attached(name));
  std::vector<std::pair<double, double>> points;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    line.erase(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r,") == std::string::npos) continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    double first = 0.0, second = 0.0;
    std::string more;
    if (!(words >> first >> second) || words >> more) {
      throw InputError(values.text(name), ":", number, ": is not ", what);
    }
    points.emplace_back(first, second);
  }
  return points;
}

std::vector<std::pair<double, double>> read_ascending_points(const ParameterValues& values, const std::string& name,
                                                             const std::string& what) {
  std::vector<std::pair<double, double>> points = read_points(values, name, what);
  if (points.size() < 2) {
    throw InputError(values.text(name), ": has ", points.size(), " points, and a curve needs two; each is ", what);
  }
  for (std::size_t n = 1; n < points.size(); ++n) {
    if (points[n].first > points[n - 1].first) continue;
    throw InputError(values.text(name) + ": the first numbers must grow from line to line, and " +
                     format_value(points[n].first) + " comes after " + format_value(points[n - 1].first));
  }
  return points;
}

namespace {

/// where: what a message begins with.
std::vector<double> numbers_in(std::string text, const std::string& where, double smallest, double largest,
                               const std::string& what) {
  std::ranges::replace(text, ',', ' ');
  std::istringstream words(text);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    std::istringstream one(word);
    double number = 0.0;
    std::string more;
    if (!(one >> number) || one >> more || !(number >= smallest && number <= largest)) {
      throw InputError(where + " has '" + word + "', which is no " + what + "; give numbers in [" +
                       format_value(smallest) + ", " + format_value(largest) + "]");
    }
    numbers.push_back(number);
  }
  if (numbers.empty()) throw InputError(where + " is empty; give at least one " + what);
  return numbers;
}

}  // namespace

std::vector<double> read_numbers(const ParameterValues& values, const std::string& name, double smallest,
                                 double largest, const std::string& what) {
  return numbers_in(values.text(name), values.origin(name) + ": '" + name + "'", smallest, largest, what);
}

std::vector<double> read_numbers_in_file(const ParameterValues& values, const std::string& name, double smallest,
                                         double largest, const std::string& what) {
  std::istringstream stream(values.attached(name));
  std::string text;
  for (std::string line; std::getline(stream, line);) {
    line.erase(std::min(line.find('#'), line.size()));
    std::ranges::replace(line, '\r', ' ');
    text += line + ' ';
  }
  return numbers_in(text, values.text(name) + ":", smallest, largest, what);
}

}  // namespace gearfilm
