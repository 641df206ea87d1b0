// The table of parameters as text: -help and docs/parameters.md.
#include <sstream>

#include "input/parameter.hpp"

namespace gearfilm {
namespace {

std::string describe_scope(Scope scope) {
  if (scope == Scope::gear_pair) return "for case.kind: gear_pair";
  if (scope == Scope::contact) return "for case.kind: contact";
  if (scope == Scope::line) return "for case.kind: line";
  if (scope == Scope::bare) return "for case.kind: contact or line";
  return "for every case";
}

std::string describe_presence(const Parameter& parameter) {
  if (parameter.presence == Presence::required) return "required";
  if (parameter.presence == Presence::preset) return "default " + parameter.fallback;
  return "when absent: " + parameter.fallback;
}

std::string symbol_and_unit(const Parameter& parameter) {
  std::string text = parameter.symbol;
  if (!parameter.unit.empty() && parameter.unit != "-") text += (text.empty() ? "[" : " [") + parameter.unit + "]";
  return text;
}

std::string meaning_of(const Parameter& parameter) {
  return parameter.former.empty() ? parameter.meaning : parameter.meaning + "; formerly " + parameter.former;
}

std::string heading(const Parameter& parameter) {
  return parameter.section().empty() ? "top level" : parameter.section();
}

// Calls begin(parameter) at the first record of each section.
template <class Begin, class Each>
void for_each_in_sections(Begin begin, Each each) {
  std::string current;
  for (const Parameter& parameter : parameter_table()) {
    if (heading(parameter) != current) begin(parameter);
    current = heading(parameter);
    each(parameter);
  }
}

std::string markdown_code(const std::string& text) { return text.empty() ? text : "`" + text + "`"; }

}  // namespace

std::string parameter_help() {
  std::ostringstream help;
  help << "Parameters. A key such as pinion.teeth stands in the case file (pinion: {teeth: 28}); the option\n"
          "-pinion_teeth 28 on the command line overrides it.\n";
  for_each_in_sections(
      [&](const Parameter& first) { help << "\n"
                                         << heading(first) << " (" << describe_scope(first.scope) << ")\n"; },
      [&](const Parameter& parameter) {
        const std::string symbol = symbol_and_unit(parameter);
        help << "  " << parameter.option() << " <" << describe_allowed(parameter) << ">  ("
             << describe_presence(parameter) << ")\n      " << meaning_of(parameter)
             << (symbol.empty() ? "" : "; " + symbol) << "\n";
      });
  return help.str();
}

std::string parameter_markdown() {
  std::ostringstream text;
  text
      << "# Parameters\n\n"
         "This page is the output of `gearfilm parameters`.\n\n"
         "A key stands in the case file, nested (`pinion: {teeth: 28}`) or dotted (`pinion.teeth: 28`). The option on\n"
         "the command line has underscores for dots (`-pinion_teeth 28`) and overrides the case file. Values are SI\n"
         "unless the key says otherwise (`_deg`, `_rpm`). `true` and `false` are read as `yes` and `no`. Unknown keys\n"
         "and options are errors.\n";
  for_each_in_sections(
      [&](const Parameter& first) {
        text << "\n## " << heading(first) << "\n\n"
             << "Keys " << describe_scope(first.scope) << ".\n\n"
             << "| Key | Symbol | Unit | Allowed | Default | Meaning |\n"
             << "|---|---|---|---|---|---|\n";
      },
      [&](const Parameter& parameter) {
        text << "| " << markdown_code(parameter.name) << " | " << markdown_code(parameter.symbol) << " | "
             << parameter.unit << " | " << describe_allowed(parameter) << " | " << describe_presence(parameter) << " | "
             << meaning_of(parameter) << " |\n";
      });
  return text.str();
}

}  // namespace gearfilm
