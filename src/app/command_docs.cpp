#include "app/command_docs.hpp"

#include "app/command_table.hpp"
#include "gearfilm/version.hpp"
#include "input/parameter.hpp"

namespace gearfilm {

std::string help_text() {
  std::string text = "gearfilm " + std::string(version) +
                     "\nLubricant films and vibration of spur-gear pairs.\n\n"
                     "  gearfilm COMMAND CASE.yaml [-option value ...]\n"
                     "  mpiexec -n N gearfilm COMMAND CASE.yaml [-option value ...]\n\nCommands\n";
  const auto add = [&](const std::string& name, const char* meaning) {
    text += "  " + name + std::string(14 - name.size(), ' ') + meaning + "\n";
  };
  for (const Command& command : commands()) add(command.name, command.meaning);
  for (const TextCommand& command : text_commands()) add(command.name, command.meaning);
  return text + "\n" + parameter_help();
}

}  // namespace gearfilm
