// The table of commands as text: -help and the manual page.
#include "app/command_docs.hpp"

#include "app/command_table.hpp"
#include "gearfilm/input/parameter.hpp"
#include "gearfilm/version.hpp"
#include "input/roff.hpp"

namespace gearfilm {
namespace {

constexpr const char* purpose = "Lubricant films and vibration of spur-gear pairs.";
constexpr const char* general_options[][2] = {{"-help", "print commands and parameters"},
                                              {"-version", "print the version"}};

constexpr const char* introduction = R"(
.SH NAME
gearfilm \- lubricant films and vibration of spur\-gear pairs
.SH SYNOPSIS
.B gearfilm
.I COMMAND CASE.yaml
[\fI\-option value\fR ...]
.br
.B mpiexec \-n
.I N
.B gearfilm
.I COMMAND CASE.yaml
[\fI\-option value\fR ...]
.SH DESCRIPTION
gearfilm computes the lubricant films between the teeth of a spur\-gear pair, and the vibration of the pair that they
carry, on any number of processes.
A case file describes the pair, or one bare contact, in SI units.
Results are written into a folder, that of
.BR \-output_dir .
.SH COMMANDS
)";

constexpr const char* about_parameters = R"(.PP
All others are parameters.
A key such as pinion.teeth stands in the case file (pinion: {teeth: 28}); the option
.B \-pinion_teeth 28
on the command line overrides it.
Options of PETSc and SLEPc are passed on to them.
)";

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
    text += "  " + name + std::string(14 - name.size(), ' ') + meaning + "\n";
  });
  return text + "\n" + parameter_help();
}

std::string manual_page() {
  std::string page = ".TH GEARFILM 1 \"\" \"gearfilm " + roff_text(version) + "\" \"User Commands\"" + introduction;
  for_each_command([&](const std::string& name, const std::string& meaning) { page += roff_entry(name, "", meaning); });
  page += ".SH OPTIONS\n";
  for (const auto& [option, meaning] : general_options) page += roff_entry(option, "", meaning);
  page += about_parameters + parameter_roff();
  return page + ".SH EXIT STATUS\n" + roff_entry("0", "", "done") +
         roff_entry("1", "", "wrong input; nothing is written") +
         roff_entry("2", "", "not solved, or results that cannot be written") +
         roff_entry("3", "", "stopped by a signal or the time limit; -restart goes on");
}

}  // namespace gearfilm
