// The values a case has for the parameters of the table, each with the place it came from.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gearfilm/error.hpp"
#include "input/parameter.hpp"

namespace gearfilm {

/// One parameter as written into the results.
struct EchoedValue {
  std::string name;
  std::string value;
  std::string unit;
};

class ParameterValues {
public:
  /// file: the case file, named in messages that have no closer place.
  explicit ParameterValues(std::string file = {}) : file_(std::move(file)) {}

  /// Reads text as the value of a parameter, by its key or its former one. origin says where it stands ("case.yaml:12",
  /// "option -grid_nx"). Throws InputError when the name is unknown or the type or the range is wrong.
  void set(const std::string& name, const std::string& text, const std::string& origin);

  /// Completes the set: defaults for what has one, and an InputError for keys of the other kind of case or
  /// for required keys that are missing (all of them in one message).
  void complete();

  const std::string& file() const { return file_; }
  bool has(const std::string& name) const { return entries_.contains(name); }
  /// Whether the case or the command line says it, if only what is the default.
  bool given(const std::string& name) const { return has(name) && origin(name) != by_default; }
  /// The values, and where one came from. Only for parameters that have a value of that type.
  int integer(const std::string& name) const { return std::get<int>(entries_.at(name).value); }
  double real(const std::string& name) const { return std::get<double>(entries_.at(name).value); }
  const std::string& text(const std::string& name) const { return std::get<std::string>(entries_.at(name).value); }
  const std::string& origin(const std::string& name) const { return entries_.at(name).origin; }
  /// The value of a real parameter, nothing where neither case nor default gives one.
  std::optional<double> real_if_given(const std::string& name) const {
    return has(name) ? std::optional(real(name)) : std::nullopt;
  }
  /// The keys of a quantity of both bodies: in sections pinion and wheel of a pair, section contact of a bare contact.
  std::array<std::string, 2> body_keys(const std::string& quantity) const;
  bool yes(const std::string& name) const { return text(name) == "yes"; }
  /// What may be "no" was given and is not.
  bool asked_for(const std::string& name) const { return given(name) && text(name) != "no"; }

  /// Throws InputError: where the value stands, "'NAME' ", and what is said of it.
  [[noreturn]] void refuse(const std::string& name, const std::string& what) const;
  /// Throws it where one of two is given without the other; remedy: "give both ends".
  void require_both(const std::string& first, const std::string& second, const std::string& remedy) const;
  /// Throws it where both are; remedy: "; delete one".
  void require_not_both(const std::string& first, const std::string& second, const std::string& remedy) const;

  /// The content of the file that a value names; the physics know no files.
  void attach(const std::string& name, std::string content) { attached_[name] = std::move(content); }
  const std::string& attached(const std::string& name) const { return attached_.at(name); }

  /// All values, defaults included, in the order of the table.
  std::vector<EchoedValue> echo() const;

private:
  struct Entry {
    ParameterValue value;
    std::string origin;
  };

  void check_scope() const;
  void check_required() const;
  Scope scope() const;
  bool in_scope(const Parameter& parameter) const;

  static constexpr const char* by_default = "default";  ///< origin of a value that nobody gave

  std::string file_;
  std::map<std::string, Entry> entries_;
  std::map<std::string, std::string> attached_;
};

/// Throws InputError for a key that is in no record, naming the nearest one. origin as for set().
void require_known_key(const std::string& name, const std::string& origin);

/// What make() returns. The physics know no files: what they find wrong gets the name of the file here.
template <class Make>
auto in_file_of(const ParameterValues& values, Make make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw InputError(values.file() + ": " + error.what());
  }
}

}  // namespace gearfilm
