#include "app/command_line.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "app/command_docs.hpp"
#include "app/command_table.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/version.hpp"
#include "input/case.hpp"
#include "input/case_numerics.hpp"
#include "input/case_setup.hpp"
#include "input/memory.hpp"
#include "input/options.hpp"
#include "input/plausibility.hpp"
#include "input/useful_processes.hpp"
#include "output/provenance.hpp"
#include "output/screen.hpp"
#include "parallel/agreement.hpp"
#include "parallel/first_processes.hpp"
#include "parallel/petsc.hpp"

namespace gearfilm {
namespace {

// A dash or two and a letter. PETSc skips words with a dash and something else without a word, unless they are values.
bool starts_option(const std::string& word) {
  const std::size_t letter = word.starts_with("--") ? 2 : 1;
  return word.starts_with("-") && word.size() > letter && std::isalpha(static_cast<unsigned char>(word[letter]));
}

constexpr const char* prefix_hint = "; options of PETSc's solvers have a prefix here, as in -steady_snes_monitor";

/// Whether PETSc would read the option of a solver that has no prefix.
bool of_a_solver(const std::string& option) {
  const auto begins = [&](const char* kind) { return option.starts_with(kind); };
  return std::ranges::any_of(std::array{"-snes_", "-ksp_", "-pc_", "-ts_", "-eps_"}, begins);
}

/// The libraries that this program works with, a line each.
std::string libraries_text(MPI_Comm comm) {
  std::string text;
  const std::map<std::string, std::string> names = {
      {"petsc", "PETSc"}, {"slepc", "SLEPc"}, {"mpi", "MPI"}, {"hdf5", "HDF5"}, {"fftw", "FFTW"}};
  for (const auto& [key, name] : names) text += name + ": " + provenance(comm).at(key).get<std::string>() + "\n";
  return text;
}

bool is_case_file(const std::string& word) { return word.ends_with(".yaml") || word.ends_with(".yml"); }

/// "-word", "--word", or as a command by its name alone.
bool asks_for(const std::string& word, const std::string& what, bool as_command) {
  return word == "-" + what || word == "--" + what || (as_command && word == what);
}

/// Reads the case and runs the command on it, with what is to be said before and behind.
void run_on_case(MPI_Comm comm, const Command& command, const CommandLine& command_line) {
  if (command_line.case_file.empty()) {
    throw InputError("no case file given; run 'gearfilm " + command_line.command + " CASE.yaml'");
  }
  if (!command_line.surplus.empty()) {
    throw InputError("cannot use '" + command_line.surplus + "'; one command takes one case file");
  }
  require_known_options(command_line.petsc_arguments);
  require_single_options(command_line.petsc_arguments);
  const CaseInput problem = read_case(comm, command_line.case_file);
  require_memory(comm, problem.numerics.nx, problem.numerics.ny, command.resumable ? contacts_at_a_time(problem) : 1,
                 heated_points(problem));
  if (problem.run.restart && !command.resumable) {
    throw InputError(problem.parameters.origin("restart") + ": " + command.name +
                     " has nothing to go on from; run it without -restart");
  }
  for (const std::string& oddity : plausibility_warnings(problem)) warn(comm, oddity);
  const bool films = command.name != std::string_view("static") && !problem.dry();
  if (const std::string remark = thin_film_remark(problem); films && !remark.empty()) warn(comm, remark);
  const int present = processes_in(comm);
  const bool all = !films || command.shares_out || problem.run.all_processes;
  const FirstProcesses working(comm,
                               all ? present : useful_processes(case_grid(problem), heated_points(problem), present));
  if (!working.contain_this()) return;
  if (const int count = processes_in(working.comm()); count < present) {
    say(working.comm(), "on ", count, " of ", present, " processes: more do not shorten the work on ",
        problem.numerics.nx, " x ", problem.numerics.ny, " nodes (-solver_processes all uses them)");
  }
  try {
    command.run(working.comm(), problem);
  } catch (const NothingLeft& reason) {
    say(working.comm(), reason.what());
  }
  for (const std::string& option : unused_options()) {
    warn(working.comm(), "option ", option, " was not used", of_a_solver(option) ? prefix_hint : "");
  }
}

}  // namespace

// The command and the case are ours; PETSc gets the rest. A case file behind an option is still the case: PETSc's
// options of either kind, with and without a value ("-log_view"), cannot be told apart here.
CommandLine::CommandLine(int argc, char** argv) {
  petsc_arguments.emplace_back(argc > 0 ? argv[0] : "gearfilm");
  bool after_option = false;
  for (int n = 1; n < argc; ++n) {
    const std::string word = argv[n];
    const bool option = starts_option(word);
    if (asks_for(word, "help", n == 1) || word == "-h") {
      wants_help = true;
    } else if (asks_for(word, "version", n == 1)) {
      wants_version = true;
    } else if (option || (after_option && !(is_case_file(word) && case_file.empty()))) {
      petsc_arguments.push_back(word);
    } else {
      std::string& place = command.empty() ? command : case_file.empty() ? case_file : surplus;
      if (place.empty()) place = word;
    }
    after_option = option;
  }
  if (wants_help || wants_version || argc < 2 || !starts_option(argv[1])) return;
  // PETSc would take the command for the option's value.
  misplaced = argv[1];
  petsc_arguments.resize(1);
}

void run(MPI_Comm comm, const CommandLine& command_line) {
  if (command_line.wants_version) {
    petsc_check(PetscPrintf(comm, "gearfilm %s\n%s", version, libraries_text(comm).c_str()));
    return;
  }
  if (!command_line.misplaced.empty()) {
    throw InputError("the option " + command_line.misplaced +
                     " stands before the command; options come last: gearfilm COMMAND CASE.yaml [-option value ...]");
  }
  if (command_line.wants_help) {
    petsc_check(PetscPrintf(comm, "%s", help_text().c_str()));
    return;
  }
  for (const TextCommand& command : text_commands()) {
    if (command_line.command != command.name) continue;
    if (!command_line.case_file.empty()) {
      throw InputError("cannot use '" + command_line.case_file + "'; the command " + command.name + " takes nothing");
    }
    require_known_options(command_line.petsc_arguments);
    petsc_check(PetscPrintf(comm, "%s", command.text().c_str()));
    return;
  }
  for (const Command& command : commands()) {
    if (command_line.command != command.name) continue;
    run_on_case(comm, command, command_line);
    return;
  }
  throw InputError(
      (command_line.command.empty() ? "no command given" : "unknown command '" + command_line.command + "'") +
      "; use one of " + command_names() + ", or -help");
}

}  // namespace gearfilm
