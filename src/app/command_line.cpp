#include "gearfilm/app/command_line.hpp"

#include <array>
#include <cctype>
#include <cmath>

#include "gearfilm/app/commands.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/input/memory.hpp"
#include "gearfilm/input/oddities.hpp"
#include "gearfilm/input/options.hpp"
#include "gearfilm/input/plain_text.hpp"
#include "gearfilm/output/results_docs.hpp"
#include "gearfilm/parallel/petsc.hpp"
#include "gearfilm/version.hpp"

namespace gearfilm {
namespace {

struct Command {
  const char* name;
  void (*run)(MPI_Comm, const Case&);
  bool resumable;  ///< can be stopped and continued
  const char* meaning;
};

constexpr std::array<Command, 7> commands = {{
    {"info", run_info, false, "derived quantities of a case, no field solve"},
    {"steady", run_steady, false, "stationary film of one contact"},
    {"transient", run_transient, true, "the gear pair marched in time"},
    {"periodic", run_periodic, true, "periodic state by shooting, with Floquet multipliers"},
    {"eigen", run_eigen, true, "natural frequencies and damping of the pair, dry and on its films"},
    {"sweep", run_sweep, true, "periodic states over a range of speeds, torques or masses"},
    {"bench", run_bench, false, "speed of the kernels, of stationary films and of a mesh period"},
}};

/// A page of the manual that follows from a table.
struct Page {
  const char* name;
  std::string (*text)();
  const char* meaning;
};

constexpr std::array<Page, 2> pages = {{
    {"parameters", parameter_markdown, "the table of all parameters in Markdown (needs no case)"},
    {"figures", figures_markdown, "the tables of all figures in the results in Markdown (needs no case)"},
}};

std::string usage() {
  std::string text = "gearfilm " + std::string(version) +
                     "\nLubricant films and vibration of spur-gear pairs.\n\n"
                     "  gearfilm COMMAND CASE.yaml [-option value ...]\n"
                     "  mpiexec -n N gearfilm COMMAND CASE.yaml [-option value ...]\n\nCommands\n";
  const auto add_line = [&](const auto& command) {
    text += "  " + std::string(command.name) + std::string(12 - std::string(command.name).size(), ' ') +
            command.meaning + "\n";
  };
  for (const Command& command : commands) add_line(command);
  for (const Page& page : pages) add_line(page);
  return text + "\n";
}

// A dash or two and a letter. PETSc skips words with a dash and something else without a word, unless they are values.
bool starts_option(const std::string& word) {
  const std::size_t letter = word.starts_with("--") ? 2 : 1;
  return word.starts_with("-") && word.size() > letter && std::isalpha(static_cast<unsigned char>(word[letter]));
}

// Of a march. Contacts of a pair share its grid, one that is followed by itself is alone.
int contacts_at_a_time(const Case& problem) {
  const bool all = problem.line && problem.geometry != MeshGeometry::single;
  return all ? static_cast<int>(std::ceil(problem.line->contact_ratio())) : 1;
}

void warn(MPI_Comm comm, const std::string& text) {
  petsc_check(PetscFPrintf(comm, stderr, "gearfilm: warning: %s\n", one_line(text).c_str()));
}

bool is_case_file(const std::string& word) { return word.ends_with(".yaml") || word.ends_with(".yml"); }

}  // namespace

// The command and the case are ours; PETSc gets the rest. A case file behind an option is still the case: PETSc's
// options of either kind, with and without a value ("-log_view"), cannot be told apart here.
CommandLine::CommandLine(int argc, char** argv) {
  petsc_arguments_.emplace_back(argc > 0 ? argv[0] : "gearfilm");
  bool after_option = false;
  for (int n = 1; n < argc; ++n) {
    const std::string word = argv[n];
    const bool option = starts_option(word);
    if (word == "-help" || word == "--help" || word == "-h") {
      help_ = true;
    } else if (word == "-version" || word == "--version") {
      version_ = true;
    } else if (option || (after_option && !(is_case_file(word) && case_file_.empty()))) {
      petsc_arguments_.push_back(word);
    } else {
      std::string& place = command_.empty() ? command_ : case_file_.empty() ? case_file_ : surplus_;
      if (place.empty()) place = word;
    }
    after_option = option;
  }
}

void run(MPI_Comm comm, const CommandLine& command_line) {
  if (command_line.wants_version()) {
    petsc_check(PetscPrintf(comm, "gearfilm %s\n", version));
    return;
  }
  if (command_line.wants_help()) {
    petsc_check(PetscPrintf(comm, "%s%s", usage().c_str(), parameter_help().c_str()));
    return;
  }
  for (const Page& page : pages) {
    if (command_line.command() != page.name) continue;
    if (!command_line.case_file().empty()) {
      throw InputError("cannot use '" + command_line.case_file() + "'; the command " + page.name + " takes nothing");
    }
    petsc_check(PetscPrintf(comm, "%s", page.text().c_str()));
    return;
  }
  std::string known;
  for (const Command& command : commands) {
    known += (known.empty() ? "" : ", ") + std::string(command.name);
    if (command_line.command() != command.name) continue;
    if (command_line.case_file().empty()) {
      throw InputError("no case file given; run 'gearfilm " + command_line.command() + " CASE.yaml'");
    }
    if (!command_line.surplus().empty()) {
      throw InputError("cannot use '" + command_line.surplus() + "'; one command takes one case file");
    }
    require_known_options(command_line.petsc_arguments());
    require_single_options(command_line.petsc_arguments());
    const Case problem = read_case(comm, command_line.case_file());
    require_memory(comm, problem.nx, problem.ny, command.resumable ? contacts_at_a_time(problem) : 1);
    if (problem.restart && !command.resumable) {
      throw InputError(problem.parameters.origin("restart") + ": " + command.name +
                       " has nothing to go on from; run it without -restart");
    }
    for (const std::string& oddity : oddities(problem)) warn(comm, oddity);
    command.run(comm, problem);
    for (const std::string& option : unused_options()) warn(comm, "option " + option + " was not used");
    return;
  }
  for (const Page& page : pages) known += ", " + std::string(page.name);
  throw InputError(
      (command_line.command().empty() ? "no command given" : "unknown command '" + command_line.command() + "'") +
      "; use one of " + known + ", or -help");
}

}  // namespace gearfilm
