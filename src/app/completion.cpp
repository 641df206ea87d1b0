// The tables of commands and parameters as a completion for bash. It needs nothing but bash itself, from version 4 on.
#include <sstream>
#include <vector>

#include "app/command_docs.hpp"
#include "app/command_table.hpp"
#include "gearfilm/input/parameter.hpp"

namespace gearfilm {
namespace {

// $current is the word under the cursor, $previous the one before it, $command empty where none is given yet. As in
// CommandLine, a word behind an option is its value.
constexpr const char* beginning = R"(# Completion of gearfilm for bash; the output of 'gearfilm completion'.
_gearfilm() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command='' n
  for ((n = 1; n < COMP_CWORD; n++)); do
    if [[ -z $command && ${COMP_WORDS[n]} != -* && ${COMP_WORDS[n-1]} != -* ]]; then command=${COMP_WORDS[n]}; fi
  done
  COMPREPLY=()
)";

constexpr const char* end = R"(}
_gearfilm_words() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$2")
}
# Folders, and the files that each pattern leaves; it takes out what does not match behind "!".
_gearfilm_files() {
  local pattern
  mapfile -t COMPREPLY < <(compgen -d -- "$1"; for pattern in "${@:2}"; do compgen -f -X "$pattern" -- "$1"; done)
  compopt -o filenames 2>/dev/null || true
}
complete -F _gearfilm gearfilm
)";

std::string words(const std::string& list) { return "_gearfilm_words '" + list + "' \"$current\""; }

// Words with something between each two of them.
class Joined {
public:
  explicit Joined(std::string separator) : separator_(std::move(separator)) {}
  void add(const std::string& word) { text_ += (text_.empty() ? "" : separator_) + word; }
  const std::string& text() const { return text_; }

private:
  std::string separator_;
  std::string text_;
};

// What follows an option: one of its choices, a file or folder, or a number, for which there is nothing to propose.
std::string value_cases() {
  std::ostringstream cases;
  Joined files(" | "), numbers(" | ");
  for (const Parameter& parameter : parameter_table()) {
    if (parameter.type == ParameterType::choice) {
      Joined choices(" ");
      for (const std::string& choice : parameter.choices) choices.add(choice);
      cases << "    " << parameter.option() << ") " << words(choices.text()) << "; return ;;\n";
    } else {
      (parameter.type == ParameterType::text ? files : numbers).add(parameter.option());
    }
  }
  cases << "    " << files.text() << ") _gearfilm_files \"$current\" '!*'; return ;;\n"
        << "    " << numbers.text() << ") return ;;\n";
  return cases.str();
}

}  // namespace

std::string bash_completion() {
  Joined options(" "), names(" "), without_case(" | ");
  for (const Parameter& parameter : parameter_table()) options.add(parameter.option());
  options.add("-help");
  options.add("-version");
  for (const Command& command : commands()) names.add(command.name);
  for (const TextCommand& command : text_commands()) {
    names.add(command.name);
    without_case.add(command.name);
  }
  return std::string(beginning) + "  if [[ $current == -* ]]; then " + words(options.text()) +
         "; return; fi\n"
         "  case $previous in\n" +
         value_cases() +
         "  esac\n"
         "  case $command in\n"
         "    '') " +
         words(names.text()) + " ;;\n    " + without_case.text() +
         ") ;;\n"
         "    *) _gearfilm_files \"$current\" '!*.yaml' '!*.yml' ;;\n"
         "  esac\n" +
         end;
}

}  // namespace gearfilm
