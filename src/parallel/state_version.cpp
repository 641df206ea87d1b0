#include "parallel/state_version.hpp"

#include <petsc/private/petscimpl.h>  // declares PetscObjectStateGet

#include <algorithm>
#include <stdexcept>

namespace gearfilm {

StateVersions::Name StateVersions::name_of(Vec vec) {
  Name name;
  auto* object = reinterpret_cast<PetscObject>(vec);
  petsc_check(PetscObjectGetId(object, &name.object));
  petsc_check(PetscObjectStateGet(object, &name.state));
  return name;
}

void StateVersions::remember(const Name& name, StateVersion version) {
  known_[next_] = {name, version};
  next_ = (next_ + 1) % known_.size();
}

StateVersion StateVersions::of(Vec vec) {
  static StateVersion last = 0;
  const Name name = name_of(vec);
  const auto found = std::ranges::find(known_, name, &Known::name);
  if (found != known_.end()) return found->version;
  remember(name, ++last);
  return last;
}

void StateVersions::copied(Vec from, Vec to) {
#ifndef NDEBUG
  PetscBool same = PETSC_FALSE;
  petsc_check(VecEqual(from, to, &same));
  if (same != PETSC_TRUE) throw std::logic_error("a vector is called a copy of another one, but has other values");
#endif
  const StateVersion version = of(from);
  const Name name = name_of(to);
  const auto found = std::ranges::find(known_, name, &Known::name);
  if (found != known_.end()) {
    found->version = version;
  } else {
    remember(name, version);
  }
}

}  // namespace gearfilm
