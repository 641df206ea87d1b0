// A case file (YAML) and the command line that overrides it.
//
// Every key of the file goes into PETSc's options database, unless the command line has set that option already;
// all values are then read back from there. So a key and its option are the same thing, checked alike. What the file
// has put there goes again, for the next case of the same process.
#pragma once

#include <petscsys.h>

#include <map>
#include <string>
#include <vector>

#include "input/parameter_values.hpp"

namespace gearfilm {

/// One "key: value" of a case file.
struct CaseFileEntry {
  std::string name;   ///< key path, "pinion.teeth"
  std::string value;  ///< as written
  int line = 0;       ///< counted from 1
};

/// The keys and values of YAML text; file is its name for messages. Throws InputError for malformed YAML and for
/// keys that are unknown, repeated, empty, or whose value is a list.
std::vector<CaseFileEntry> parse_case_text(const std::string& file, const std::string& text);

/// Content of a file, read on rank 0 and given to all. Throws InputError on all ranks when it cannot be read; title is
/// what its message calls the file.
std::string read_text(MPI_Comm comm, const std::string& file, const std::string& title);

/// The complete set of values of a case file under the present command line. Collective. Throws InputError, on all
/// ranks alike, for everything that is wrong with the file or with an option, unknown options included.
ParameterValues read_parameters(MPI_Comm comm, const std::string& file);

/// AvailableModels values in the place of what there is, completed by defaults; the files that they name are read.
/// origin: what messages call the place where they stand. Collective; throws InputError on all ranks alike.
ParameterValues with_values(MPI_Comm comm, ParameterValues values, const std::map<std::string, std::string>& given,
                            const std::string& origin);

}  // namespace gearfilm
