// Whether the inertia of a pair is part of its motion.
#pragma once

#include "gearfilm/input/case.hpp"

namespace gearfilm {

/// The case with the motion that it asks for or, where it says nothing and the pair swings many times in a mesh period,
/// without inertia, which is said in one line. For the commands `transient` and `periodic`.
Case with_chosen_motion(MPI_Comm comm, const Case& problem);

/// As in case files.
const char* word_of(PairMotion motion);

/// For all other commands. Throws InputError for a pair without inertia.
void require_dynamic(const Case& problem, const std::string& command);

}  // namespace gearfilm
