// The tables of commands and parameters as text: -help, the manual page made of it, and the completion.
#include "app/command_docs.hpp"

#include <regex>

#include "app/command_table.hpp"
#include "gearfilm/version.hpp"
#include "input/parameter.hpp"

namespace gearfilm {
namespace {

constexpr const char* description =
    "\n\nDescription\n"
    "gearfilm computes the lubricant films between the teeth of a spur-gear pair, and the vibration of the pair that "
    "they\ncarry, on any number of processes.\n"
    "A case file describes the pair, or one bare contact, in SI units.\n"
    "Results are written into a folder, that of -output_dir.";

constexpr const char* behind_parameters =
    "\nOther options\n"
    "  -help  print commands and parameters\n"
    "  -version  print the version\n"
    "\nThose of PETSc and SLEPc are passed on to them.\n"
    "\nExit status\n"
    "  0  done\n"
    "  1  wrong input; nothing is written\n"
    "  2  not solved, or results that cannot be written\n"
    "  3  stopped by a signal or the time limit; -restart goes on\n";

// From plain text to roff with its macros "man", one after the other: characters that mean something there; lines set
// in by two blanks, terms with what stands behind them or, after more blanks, below; lines set in farther; headings.
constexpr const char* typesetting[][2] = {{R"(\\)", R"(\e)"},
                                          {"-", R"(\-)"},
                                          {"'", R"(\(aq)"},
                                          {R"(\^)", R"(\(ha)"},
                                          {"~", R"(\(ti)"},
                                          {R"(\n  (\S+)  +)", "\n.TP\n\\fB$1\\fR\n"},
                                          {R"(\n  (\S+) )", "\n.TP\n\\fB$1\\fR "},
                                          {R"(\n +)", "\n"},
                                          {R"(\n\n(\w+( \w+)?)\n)", "\n.SH $1\n"},
                                          {R"(\n\n(\w+( \w+)?) (\(for .*\)))", "\n.SS $1\n$3"},
                                          {R"(\n\n)", "\n.PP\n"}};

// It needs nothing but bash itself, from version 4 on. $current is the word under the cursor, $previous the one before
// it, $command empty where none is given yet. As in CommandLine, a word behind an option is its value.
constexpr const char* completion_begin = R"(# Completion of gearfilm for bash; the output of 'gearfilm completion'.
_gearfilm() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command='' n
  for ((n = 1; n < COMP_CWORD; n++)); do
    if [[ -z $command && ${COMP_WORDS[n]} != -* && ${COMP_WORDS[n-1]} != -* ]]; then command=${COMP_WORDS[n]}; fi
  done
  COMPREPLY=()
)";

constexpr const char* completion_end = R"(    *) _gearfilm_files '!*.yaml' '!*.yml' ;;
  esac
}
_gearfilm_words() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current")
}
# Folders, and the files that each pattern leaves; it takes out what does not match behind "!".
_gearfilm_files() {
  local pattern
  mapfile -t COMPREPLY < <(compgen -d -- "$current"; for pattern; do compgen -f -X "$pattern" -- "$current"; done)
  compopt -o filenames 2>/dev/null || true
}
complete -F _gearfilm gearfilm
)";

// Calls each(name, meaning) for all commands.
template <class Each>
void for_each_command(Each each) {
  for (const Command& command : commands()) each(command.name, command.meaning);
  for (const TextCommand& command : text_commands()) each(command.name, command.meaning);
}

}  // namespace

std::string help_text() {
  std::string text = "gearfilm " + std::string(version) +
                     "\nLubricant films and vibration of spur-gear pairs.\n\n"
                     "  gearfilm COMMAND CASE.yaml [-option value ...]\n"
                     "  mpiexec -n N gearfilm COMMAND CASE.yaml [-option value ...]\n\nCommands\n";
  for_each_command([&](const std::string& name, const std::string& meaning) {
    text += "  " + name + std::string(14 - name.size(), ' ') + meaning + "\n";
  });
  return text + "\n" + parameter_help();
}

std::string manual_page() {
  const std::string help = help_text();
  const std::size_t usage = help.find("\n  "), commands = help.find("\n\nCommands");
  std::string page = "\n\nName\ngearfilm - lubricant films and vibration of spur-gear pairs\n\nSynopsis" +
                     help.substr(usage, commands - usage) + description + help.substr(commands) + behind_parameters;
  for (const auto& [plain, roff] : typesetting) page = std::regex_replace(page, std::regex(plain), roff);
  return ".TH GEARFILM 1 \"\" \"gearfilm " + std::string(version) + "\" \"User Commands\"" + page;
}

std::string bash_completion() {
  const auto words = [](const std::string& list) { return "_gearfilm_words '" + list + "'"; };
  std::string options = "-help -version", names, values, files, numbers, without_case;
  const auto add = [](std::string& list, const std::string& separator, const std::string& word) {
    list += (list.empty() ? "" : separator) + word;
  };
  for (const Parameter& parameter : parameter_table()) {
    const std::string option = parameter.option();
    add(options, " ", option);
    if (parameter.type != ParameterType::choice) {
      add(parameter.type == ParameterType::text ? files : numbers, " | ", option);
      continue;
    }
    std::string choices;
    for (const std::string& choice : parameter.choices) add(choices, " ", choice);
    values += "    " + option + ") " + words(choices) + "; return ;;\n";
  }
  for_each_command([&](const std::string& name, const std::string&) { add(names, " ", name); });
  for (const TextCommand& command : text_commands()) add(without_case, " | ", command.name);
  return completion_begin + ("  if [[ $current == -* ]]; then " + words(options)) +
         "; return; fi\n  case $previous in\n" + values + "    " + files + ") _gearfilm_files '!*'; return ;;\n    " +
         numbers + ") return ;;\n  esac\n  case $command in\n    '') " + words(names) + " ;;\n    " + without_case +
         ") ;;\n" + completion_end;
}

}  // namespace gearfilm
