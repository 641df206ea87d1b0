// PETSc's options database: which options are ours, which are PETSc's own, and which nobody knows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "input/parameter_values.hpp"

namespace gearfilm {

struct CaseFileEntry;

/// True for an option, with its dash, that begins like one of PETSc's or SLEPc's own ("-ksp_type").
bool is_petsc_option(std::string_view option);

/// Throws InputError for the first option that is neither in the table of parameters nor one of PETSc's, and that
/// stands among the words of the command line: PETSC_OPTIONS and .petscrc are shared with other programs.
void require_known_options(const std::vector<std::string>& arguments);

/// Throws InputError for an option of ours that stands twice among the words of the command line: PETSc would take the
/// last one without a word.
void require_single_options(const std::vector<std::string>& arguments);

/// Puts the entries into the database where the command line has no such option, reads the values of all parameters
/// back, and leaves the database as it was. file names the case file in messages.
ParameterValues merge_with_options(const std::string& file, const std::vector<CaseFileEntry>& entries);

/// Options of PETSc's ("-ksp_tpye cg") that nothing has read so far: for a warning when the work is done.
std::vector<std::string> unused_options();

}  // namespace gearfilm
