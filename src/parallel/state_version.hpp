// Versions of vectors: the same number, the same values. Who computed something from a vector asks for its version
// instead of comparing values, and all processes get the same answer without asking each other.
//
// PETSc raises the state of an object with every write (PetscObjectStateGet), so that identity and state name the
// values. A copy is another object: whoever copies says so. That processes agree rests on two rules: all of them write
// a vector together, those without own changes too, and what else they decide by is the same to the bit on all.
#pragma once

#include <array>
#include <cstdint>

#include "parallel/petsc.hpp"

namespace gearfilm {

/// Version of the values of a whole state; parts of a state are distinguished by their place in it. Zero is the version
/// of values that nobody knows.
using StateVersion = std::uint64_t;

class StateVersions {
public:
  /// Version of the present values of a vector. Different values never have the same version, in whatever object.
  StateVersion of(Vec vec);
  /// `to` has the values of `from`, until it is written again. Throws std::logic_error in builds with assertions where
  /// it has not.
  void copied(Vec from, Vec to);

private:
  struct Name {
    PetscObjectId object = 0;
    PetscObjectState state = 0;
    bool operator==(const Name&) const = default;
  };
  struct Known {
    Name name;
    StateVersion version = 0;
  };
  static Name name_of(Vec vec);
  void remember(const Name& name, StateVersion version);

  std::array<Known, 8> known_{};  ///< the last ones
  std::size_t next_ = 0;
};

}  // namespace gearfilm
