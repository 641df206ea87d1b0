// The table of commands as text: -help and the manual page.
#include "gearfilm/app/command_docs.hpp"

#include "gearfilm/app/command_table.hpp"
#include "gearfilm/input/parameter.hpp"
#include "gearfilm/input/roff.hpp"
#include "gearfilm/version.hpp"

namespace gearfilm {
namespace {

constexpr const char* purpose = "Lubricant films and vibration of spur-gear pairs.";
constexpr const char* general_options[][2] = {{"-help", "print commands and parameters"},
                                              {"-version", "print the version"}};

// Calls each(name, meaning) for all commands.
template <class Each>
void for_each_command(Each each) {
  for (const Command& command : commands()) each(command.name, command.meaning);
  for (const TextCommand& command : text_commands()) each(command.name, command.meaning);
}

}  // namespace

std::string help_text() {
  std::string text = "gearfilm " + std::string(version) + "\n" + purpose +
                     "\n\n"
                     "  gearfilm COMMAND CASE.yaml [-option value ...]\n"
                     "  mpiexec -n N gearfilm COMMAND CASE.yaml [-option value ...]\n\nCommands\n";
  for_each_command([&](const std::string& name, const std::string& meaning) {
    text += "  " + name + std::string(12 - name.size(), ' ') + meaning + "\n";
  });
  return text + "\n" + parameter_help();
}

std::string manual_page() {
  std::string page = ".TH GEARFILM 1 \"\" \"gearfilm " + roff_text(version) +
                     "\" \"User Commands\"\n"
                     ".SH NAME\n"
                     "gearfilm \\- lubricant films and vibration of spur\\-gear pairs\n"
                     ".SH SYNOPSIS\n"
                     ".B gearfilm\n"
                     ".I COMMAND CASE.yaml\n"
                     "[\\fI\\-option value\\fR ...]\n"
                     ".br\n"
                     ".B mpiexec \\-n\n"
                     ".I N\n"
                     ".B gearfilm\n"
                     ".I COMMAND CASE.yaml\n"
                     "[\\fI\\-option value\\fR ...]\n"
                     ".SH DESCRIPTION\n"
                     "gearfilm computes the lubricant films between the teeth of a spur\\-gear pair, and the vibration "
                     "of the pair that they carry, on any number of processes.\n"
                     "A case file describes the pair, or one bare contact, in SI units.\n"
                     "Results are written into a folder, that of\n"
                     ".BR \\-output_dir .\n"
                     ".SH COMMANDS\n";
  for_each_command([&](const std::string& name, const std::string& meaning) { page += roff_entry(name, "", meaning); });
  page += ".SH OPTIONS\n";
  for (const auto& [option, meaning] : general_options) page += roff_entry(option, "", meaning);
  page +=
      ".PP\n"
      "All others are parameters. A key such as pinion.teeth stands in the case file (pinion: {teeth: 28}); the "
      "option\n"
      "\\fB\\-pinion_teeth 28\\fR on the command line overrides it. Options of PETSc and SLEPc are passed on to "
      "them.\n" +
      parameter_roff();
  return page + ".SH EXIT STATUS\n" + roff_entry("0", "", "done") +
         roff_entry("1", "", "wrong input; nothing is written") +
         roff_entry("2", "", "not solved, or results that cannot be written") +
         roff_entry("3", "", "stopped by a signal or the time limit; -restart goes on");
}

}  // namespace gearfilm
