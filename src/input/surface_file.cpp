#include "input/surface_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <sstream>

#include "input/point_table.hpp"

namespace gearfilm {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return text;
}

/// An ASCII file of ISO 25178-71: its mark, lines "key = value" up to one with a star, heights up to the next star.
class SdfFile {
public:
  SdfFile(const ParameterValues& values, std::string name) : values_(values), name_(std::move(name)) {
    std::istringstream stream(values.attached(name_));
    std::string line;
    std::getline(stream, line);
    const std::string mark = trimmed(line);
    if (mark != "aISO-1.0" && mark != "aISO-2.0" && mark != "aBCR-1.0")
      refuse("begins with '" + mark + "'; give an ASCII file, whose first line is aISO-1.0, aISO-2.0 or aBCR-1.0");
    while (std::getline(stream, line) && trimmed(line) != "*") {
      const std::size_t sign = line.find('=');
      if (sign != std::string::npos) header_[in_small_letters(trimmed(line.substr(0, sign)))] = line.substr(sign + 1);
    }
    for (std::string word; stream >> word && word != "*";) words_.push_back(word);
  }

  double number(const std::string& key) const {
    const auto found = header_.find(in_small_letters(key));
    double value = 0.0;
    if (found == header_.end() || !(std::istringstream(found->second) >> value) || !(value > 0.0))
      refuse("has no positive " + key + " in its header");
    return value;
  }

  std::vector<double> heights() const {
    std::vector<double> heights;
    for (const std::string& word : words_) {
      double height = 0.0;
      std::string more;
      std::istringstream one(word);
      if (!(one >> height) || one >> more)
        refuse("has '" + word + "' among its heights; fill in points that are missing before");
      heights.push_back(height);
    }
    return heights;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    values_.refuse(name_, "is '" + values_.text(name_) + "', which " + what);
  }

private:
  const ParameterValues& values_;
  std::string name_;
  std::map<std::string, std::string> header_;
  std::vector<std::string> words_;
};

std::vector<std::pair<double, double>> read_sdf(const ParameterValues& values, const std::string& name, double middle) {
  const SdfFile file(values, name);
  const double points = file.number("NumPoints"), profiles = file.number("NumProfiles");
  if (profiles != 1.0)
    file.refuse("holds " + format_value(profiles) +
                " profiles; films are mirror images across the face, give the one profile that stands for it");
  const double step = file.number("Xscale"), unit = file.number("Zscale");
  const std::vector<double> heights = file.heights();
  if (static_cast<double>(heights.size()) != points)
    file.refuse("has " + std::to_string(heights.size()) + " heights where its header says " + format_value(points));
  std::vector<std::pair<double, double>> result;
  for (std::size_t k = 0; k < heights.size(); ++k)
    result.emplace_back(middle + (static_cast<double>(k) - 0.5 * (points - 1.0)) * step, unit * heights[k]);
  return result;
}

}  // namespace

std::vector<std::pair<double, double>> read_surface(const ParameterValues& values, const std::string& name,
                                                    double middle) {
  const bool sdf = in_small_letters(values.text(name)).ends_with(".sdf");
  std::vector<std::pair<double, double>> points =
      sdf ? read_sdf(values, name, middle)
          : read_ascending_points(values, name, "a point of the surface; give two numbers, length s and height z [m]");
  constexpr std::size_t fewest = 16;
  if (points.size() < fewest)
    values.refuse(name, "is '" + values.text(name) + "', which has " + std::to_string(points.size()) +
                            " points; a profile needs at least " + std::to_string(fewest));
  return points;
}

}  // namespace gearfilm
