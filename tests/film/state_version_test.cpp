// Versions of vectors.
#include "parallel/state_version.hpp"

#include <gtest/gtest.h>

namespace gearfilm {
namespace {

OwnedVec vector_of(double value) {
  OwnedVec vec;
  petsc_check(VecCreateMPI(PETSC_COMM_WORLD, 3, PETSC_DETERMINE, vec.put()));
  petsc_check(VecSet(vec, value));
  return vec;
}

TEST(StateVersion, changes_with_every_write_and_with_nothing_else) {
  StateVersions versions;
  const OwnedVec vec = vector_of(1.0);
  const StateVersion first = versions.of(vec);
  EXPECT_NE(first, 0U);
  PetscReal norm = 0.0;
  petsc_check(VecNorm(vec, NORM_2, &norm));
  EXPECT_EQ(VecReading(vec)[0], 1.0);
  EXPECT_EQ(versions.of(vec), first);
  petsc_check(VecSet(vec, 1.0));
  EXPECT_NE(versions.of(vec), first);
}

TEST(StateVersion, of_a_copy_is_that_of_the_original_until_it_is_written) {
  StateVersions versions;
  const OwnedVec from = vector_of(1.0), to = vector_of(2.0);
  const StateVersion version = versions.of(from);
  EXPECT_NE(versions.of(to), version);
  petsc_check(VecCopy(from, to));
  versions.copied(from, to);
  EXPECT_EQ(versions.of(to), version);
  petsc_check(VecSet(from, 3.0));
  EXPECT_EQ(versions.of(to), version);
  EXPECT_NE(versions.of(from), version);
  petsc_check(VecScale(to, 2.0));
  EXPECT_NE(versions.of(to), version);
}

TEST(StateVersion, that_is_forgotten_is_never_given_again) {
  StateVersions versions, others;
  const OwnedVec first = vector_of(1.0);
  std::vector<StateVersion> seen = {versions.of(first)};
  for (int n = 0; n < 20; ++n) {
    const OwnedVec next = vector_of(1.0);
    for (StateVersions* each : {&versions, &others}) {
      const StateVersion version = each->of(next);
      for (const StateVersion before : seen) EXPECT_NE(version, before);
      seen.push_back(version);
    }
  }
  const StateVersion again = versions.of(first);
  for (const StateVersion before : seen) EXPECT_NE(again, before);
}

}  // namespace
}  // namespace gearfilm
