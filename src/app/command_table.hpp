// The table of commands, one record each: usage, manual page, completion and dispatch follow from it.
#pragma once

#include <mpi.h>

#include <span>
#include <string>

namespace gearfilm {

struct CaseInput;

/// A command that computes something of a case.
struct Command {
  const char* name;
  void (*run)(MPI_Comm, const CaseInput&);
  bool resumable;   ///< can be stopped and continued
  bool shares_out;  ///< gives every process work of its own, however small the grid
  const char* meaning;
};

/// A command that prints a text made from the tables of commands and parameters; it takes nothing.
struct TextCommand {
  const char* name;
  std::string (*text)();
  const char* meaning;
};

std::span<const Command> commands();
std::span<const TextCommand> text_commands();

/// The names of all, as "info, steady, ...".
std::string command_names();

}  // namespace gearfilm
