// The file of a drive train (train_parts.hpp).
#include <algorithm>
#include <sstream>

#include "gearfilm/error.hpp"
#include "input/parameter.hpp"
#include "input/train_parts.hpp"
#include "input/train_torques.hpp"

namespace gearfilm {
namespace {

/// One line: what is wrong with it is said with its place.
class TrainLine {
public:
  TrainLine(std::string place, const std::string& text) : place_(std::move(place)) {
    std::istringstream stream(text);
    for (std::string word; stream >> word;) words_.push_back(word);
  }

  bool empty() const { return words_.empty(); }
  std::size_t size() const { return words_.size(); }
  const std::string& place() const { return place_; }
  const std::string& kind() const { return words_.front(); }
  const std::string& word(std::size_t n) const { return words_[n]; }

  [[noreturn]] void refuse(const std::string& what) const { throw InputError(place_ + ": " + what); }

  /// The numbers behind the first words, so many as one of the counts says.
  std::vector<double> numbers(std::size_t first, std::initializer_list<std::size_t> counts,
                              const std::string& form) const {
    const std::size_t count = words_.size() < first ? 0 : words_.size() - first;
    if (words_.size() < first || std::ranges::find(counts, count) == counts.end()) {
      refuse("'" + kind() + "' needs the form: " + form);
    }
    std::vector<double> found;
    for (std::size_t n = first; n < words_.size(); ++n) found.push_back(number(words_[n]));
    return found;
  }

  double positive(double value, const std::string& what) const {
    if (value > 0.0) return value;
    refuse("the " + what + " is " + format_value(value) + "; give a number > 0");
  }

  double not_negative(double value, const std::string& what) const {
    if (value >= 0.0) return value;
    refuse("the " + what + " is " + format_value(value) + "; give a number >= 0");
  }

  double number(const std::string& word) const {
    std::istringstream stream(word);
    double value = 0.0;
    std::string more;
    if (!(stream >> value) || stream >> more || !std::isfinite(value)) refuse("'" + word + "' is no number");
    return value;
  }

private:
  std::string place_;
  std::vector<std::string> words_;
};

std::size_t node_named(const TrainParts& parts, const TrainLine& line, const std::string& name) {
  const auto found = std::ranges::find(parts.nodes, name, &TrainNode::name);
  if (found == parts.nodes.end()) line.refuse("there is no node '" + name + "' yet; give it in a line before");
  return static_cast<std::size_t>(found - parts.nodes.begin());
}

double entry(const std::vector<double>& numbers, std::size_t n) { return n < numbers.size() ? numbers[n] : 0.0; }

void add_node(const TrainLine& line, TrainParts& parts) {
  const std::vector<double> numbers = line.numbers(3, {1, 2}, "node NAME pinion|wheel inertia [mass]");
  const std::string &name = line.word(1), &side = line.word(2);
  if (side != "pinion" && side != "wheel") line.refuse("'" + side + "' is no side; give pinion or wheel");
  if (std::ranges::find(parts.nodes, name, &TrainNode::name) != parts.nodes.end()) {
    line.refuse("the node '" + name + "' is there already; give another name");
  }
  const std::size_t gear = side == "pinion" ? TrainParts::pinion : TrainParts::wheel;
  TrainNode node{.name = name, .inertia = line.positive(numbers[0], "inertia"), .radius = parts.nodes[gear].radius};
  if (numbers.size() > 1) node.mass = line.positive(numbers[1], "mass");
  parts.nodes.push_back(std::move(node));
  parts.sides.push_back(side == "pinion" ? TrainSide::pinion : TrainSide::wheel);
}

void add_shaft(const TrainLine& line, TrainParts& parts) {
  const std::vector<double> numbers = line.numbers(3, {1, 2, 3}, "shaft A B k [c [I]]");
  const std::size_t a = node_named(parts, line, line.word(1)), b = node_named(parts, line, line.word(2));
  if (a == b) line.refuse("a shaft joins two nodes, and '" + line.word(1) + "' is one; give another");
  if (parts.sides[a] != parts.sides[b]) {
    line.refuse("'" + line.word(1) + "' and '" + line.word(2) +
                "' turn with different gears, which only their teeth join; join nodes of one side");
  }
  parts.shafts.push_back({a,
                          b,
                          {.stiffness = line.positive(numbers[0], "stiffness"),
                           .damping = line.not_negative(entry(numbers, 1), "damping"),
                           .inertia = line.not_negative(entry(numbers, 2), "inertia")}});
}

void add_bearing(const TrainLine& line, TrainParts& parts) {
  const std::vector<double> k = line.numbers(2, {2, 4, 6}, "bearing NODE kx ky [kxy kyx [cx cy]]");
  const std::size_t node = node_named(parts, line, line.word(1));
  Bearing bearing{
      .stiffness = Eigen::Matrix2d{{k[0], entry(k, 2)}, {entry(k, 3), k[1]}},
      .damping = Eigen::Vector2d(line.not_negative(entry(k, 4), "damping"), line.not_negative(entry(k, 5), "damping"))
                     .asDiagonal()};
  if (!is_positive(bearing.stiffness)) {
    line.refuse("the stiffness of '" + line.word(1) +
                "' does not hold it in every direction; give kx ky > ((kxy + kyx)/2)^2, both positive");
  }
  if (node > TrainParts::wheel && !parts.nodes[node].mass) {
    line.refuse("'" + line.word(1) + "' has a bearing, but no mass; give it behind the inertia of its node");
  }
  if (node <= TrainParts::wheel && parts.two_bearings[node]) {
    line.refuse("'" + line.word(1) + "' is on two bearings already, by '" + line.word(1) +
                ".bearing_span'; delete one of both");
  }
  parts.bearings.push_back({node, bearing});
}

void add_ground(const TrainLine& line, TrainParts& parts) {
  const std::vector<double> numbers = line.numbers(2, {1, 2}, "ground NODE k [c]");
  parts.grounds.push_back({node_named(parts, line, line.word(1)), line.positive(numbers[0], "stiffness"),
                           line.not_negative(entry(numbers, 1), "damping")});
}

void add_torque(const TrainLine& line, TrainParts& parts) {
  const std::string form = "torque NODE mean [order amplitude phase]...";
  if (line.size() < 3 || line.size() % 3 != 0) line.refuse("'torque' needs the form: " + form);
  TorquePart torque{.node = node_named(parts, line, line.word(1)),
                    .mean = line.number(line.word(2)),
                    .origin = line.place() + ": the torque "};
  for (std::size_t n = 3; n < line.size(); n += 3) {
    const std::string words = line.word(n) + " " + line.word(n + 1) + " " + line.word(n + 2);
    const auto harmonic = read_harmonic(words);
    if (!harmonic) {
      line.refuse("'" + words + "' is no order > 0 or frequency as 300Hz, amplitude and phase in degrees");
    }
    torque.harmonics.push_back(*harmonic);
  }
  parts.torques.push_back(std::move(torque));
}

void fix(const TrainLine& line, TrainParts& parts) {
  line.numbers(2, {0}, "fixed NODE");
  parts.nodes[node_named(parts, line, line.word(1))].fixed = true;
}

void add_line(const TrainLine& line, TrainParts& parts) {
  if (line.kind() == "node") return add_node(line, parts);
  if (line.kind() == "shaft") return add_shaft(line, parts);
  if (line.kind() == "bearing") return add_bearing(line, parts);
  if (line.kind() == "ground") return add_ground(line, parts);
  if (line.kind() == "torque") return add_torque(line, parts);
  if (line.kind() == "fixed") return fix(line, parts);
  line.refuse("'" + line.kind() + "' is no element; give node, shaft, bearing, ground, torque or fixed");
}

}  // namespace

bool is_positive(const Eigen::Matrix2d& stiffness) {
  const double coupling = 0.5 * (stiffness(0, 1) + stiffness(1, 0));
  return stiffness(0, 0) > 0.0 && stiffness(0, 0) * stiffness(1, 1) > coupling * coupling;
}

void add_train_file(const ParameterValues& values, TrainParts& parts) {
  const std::string name = "train.file";
  std::istringstream stream(values.attached(name));
  int number = 0;
  for (std::string text; std::getline(stream, text);) {
    text.erase(std::min(text.find('#'), text.size()));
    const TrainLine line(worded(values.text(name), ":", ++number), text);
    if (!line.empty()) add_line(line, parts);
  }
}

}  // namespace gearfilm
