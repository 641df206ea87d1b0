// YAML events rather than yaml-cpp's nodes: nodes keep one of two equal keys without a word.
#include "input/case_file.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include "gearfilm/error.hpp"
#include "input/options.hpp"
#include "input/text_file.hpp"
#include "numerics/tuned.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

bool is_section(const std::string& name) {
  return std::ranges::any_of(parameter_table(),
                             [&](const Parameter& parameter) { return parameter.section() == name; });
}

// Collects the leaves of nested maps under their full names.
class EntryCollector : public YAML::EventHandler {
public:
  explicit EntryCollector(std::string file) : file_(std::move(file)) {}

  std::vector<CaseFileEntry> take_entries() { return std::move(entries_); }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) fail(mark, "a second YAML document begins; give one case a file");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    // An empty file is a case without keys: what is missing is said later.
    if (open_maps_.empty()) return;
    if (expects_key()) fail(mark, "a key is empty; give it a name");
    reject_empty(mark);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& text) override {
    reject_decoration(mark, tag, anchor);
    if (text.find('\n') != std::string::npos)
      fail(mark, "a key or value goes over several lines; close its quotes in the line where they open");
    if (open_maps_.empty()) fail(mark, "'" + text + "' is not a case; give keys with values, 'section: {key: value}'");
    if (expects_key()) return begin_key(mark, text);
    if (is_section(key_))
      fail(mark, "'" + key_ + "' is a section, but has the value '" + text + "'; give keys under it");
    require_known_key(key_, place(mark));
    if (text.empty()) reject_empty(mark);
    entries_.push_back({key_, text, mark.line + 1});
    key_.clear();
  }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    reject_decoration(mark, tag, anchor);
    if (open_maps_.size() > deepest) fail(mark, "keys are nested too deeply; a section has keys, but no sections");
    if (!open_maps_.empty() && expects_key()) fail(mark, "a key is itself a list of keys; give it a name");
    open_maps_.push_back(std::exchange(key_, {}));
  }
  void OnMapEnd() override { open_maps_.pop_back(); }

  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
    fail(mark,
         (key_.empty() ? "the content" : "'" + key_ + "'") + " is a list; no parameter takes one, give one value");
  }
  void OnSequenceEnd() override {}

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    fail(mark, "YAML aliases ('*name') are not read; write the value out");
  }

private:
  static constexpr std::size_t deepest = 2;

  bool expects_key() const { return key_.empty(); }
  std::string place(const YAML::Mark& mark) const { return file_ + ":" + std::to_string(mark.line + 1); }
  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& message) const {
    throw InputError(place(mark) + ": " + message);
  }

  // They would change what a value means elsewhere, and here do nothing. A plain scalar has the tag "?", a quoted one
  // "!".
  void reject_decoration(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) const {
    if (anchor != 0) fail(mark, "YAML anchors ('&name') are not read; delete it");
    if (!tag.empty() && tag != "?" && tag != "!") fail(mark, "YAML tags ('" + tag + "') are not read; delete it");
  }

  [[noreturn]] void reject_empty(const YAML::Mark& mark) const {
    if (is_section(key_)) fail(mark, "section '" + key_ + "' is empty; give keys under it or delete it");
    require_known_key(key_, place(mark));
    fail(mark, "'" + key_ + "' has no value; give " + describe_allowed(*find_parameter(key_)));
  }

  void begin_key(const YAML::Mark& mark, const std::string& text) {
    if (text.empty()) fail(mark, "a key is empty; give it a name");
    key_ = open_maps_.back().empty() ? text : open_maps_.back() + "." + text;
    std::string formerly;
    if (const Parameter* parameter = find_parameter(key_); parameter && !parameter->former.empty()) {
      key_ = parameter->name;
      formerly = " (formerly '" + parameter->former + "')";
    }
    const auto [earlier, is_new] = lines_.emplace(key_, mark.line + 1);
    if (!is_new)
      fail(mark, "duplicate key '" + key_ + "'" + formerly + ", first given in line " +
                     std::to_string(earlier->second) + "; delete one of the two");
  }

  std::string file_;
  std::vector<CaseFileEntry> entries_;
  std::vector<std::string> open_maps_;  // full names of the maps that are open; the outermost has none
  std::string key_;                     // full name, not a former one, of the key whose value comes next
  std::map<std::string, int> lines_;    // where each key was first given
  int documents_ = 0;
};

// yaml-cpp reads an indenting tab as part of the value before, a no-break space as part of the key, and complains about
// something else.
void reject_odd_indents(const std::string& file, const std::string& text) {
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const std::size_t content = line.find_first_not_of(" \t\r");
    if (content == std::string::npos) continue;
    const bool tab = line.substr(0, content).find('\t') != std::string::npos;
    if (tab || line.compare(content, 2, "\u00a0") == 0)
      throw InputError(file, ":", number, ": malformed YAML (a ", (tab ? "tab" : "no-break space"),
                       " indents the line); use spaces");
  }
}

/// A file that a value names: in the case file beside it, on the command line where the program was called.
std::string named_file(const ParameterValues& values, const std::string& name) {
  const bool in_case = values.origin(name).starts_with(values.file() + ":");
  const std::filesystem::path beside = in_case ? std::filesystem::path(values.file()).parent_path() : "";
  return (beside / values.text(name)).string();
}

// The processes make their cases from the same text, read once.
void attach_tables(MPI_Comm comm, ParameterValues& values) {
  const auto attach = [&](const std::string& name, const std::string& kind) {
    if (!values.has(name) || (!kind.empty() && values.text(kind) != "table")) return;
    values.attach(name, read_text(comm, named_file(values, name), values.origin(name) + ": table"));
  };
  attach("roughness.table", "roughness.asperity_law");
  attach("load_sharing.file", "load_sharing.kind");
  attach("gear.compliance_file", "gear.tooth_compliance");
  attach("train.file", "");
  for (const std::string gear : {"pinion", "wheel"}) {
    attach(gear + ".profile_file", "");
    attach(gear + ".surface", "");
    attach(gear + ".lead_file", "");
    attach(gear + ".pitch_errors_file", "");
    attach(gear + ".hardness_file", "");
    attach(gear + ".residual_file", "");
  }
}

}  // namespace

std::vector<CaseFileEntry> parse_case_text(const std::string& file, const std::string& text) {
  reject_odd_indents(file, text);
  EntryCollector collector(file);
  // yaml-cpp lets a quote run on to the end of the text, taking all further keys for its content; an end-of-document
  // mark stops it.
  const auto lines = 1 + std::ranges::count(text, '\n');
  std::istringstream stream(text + "\n...\n");
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(collector)) {
    }
  } catch (const YAML::Exception& error) {
    if (error.mark.line >= lines)
      throw InputError(file + ": malformed YAML (the end comes inside a quote or brackets); close them");
    throw InputError(file, ":", error.mark.line + 1, ": malformed YAML (", error.msg,
                     "); check indentation, colons and quotes");
  }
  return collector.take_entries();
}

std::string read_text(MPI_Comm comm, const std::string& file, const std::string& title) {
  TextFile content = rank_in(comm) == 0 ? read_text_file(file) : TextFile();
  broadcast(comm, content.obstacle);
  if (!content.obstacle.empty()) throw InputError(title + " '" + file + "' " + content.obstacle);
  broadcast(comm, content.text);
  return content.text;
}

ParameterValues read_parameters(MPI_Comm comm, const std::string& file) {
  const std::vector<CaseFileEntry> entries = parse_case_text(file, read_text(comm, file, "case file"));
  ParameterValues values = merge_with_options(file, entries);
  TunedConstant::read_all();
  values.complete();
  attach_tables(comm, values);
  return values;
}

ParameterValues with_values(MPI_Comm comm, ParameterValues values, const std::map<std::string, std::string>& given,
                            const std::string& origin) {
  TunedConstant::read_all();
  for (const auto& [name, text] : given) values.set(name, text, origin);
  values.complete();
  attach_tables(comm, values);
  return values;
}

}  // namespace gearfilm
