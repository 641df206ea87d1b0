// A case: a gear pair in mesh or one bare contact, its oil, and how it is computed, by the keys and values of case
// files (docs/parameters.md).
//
// The library is used under MPI, PETSc and SLEPc, which the program that uses it starts (SlepcInitialize). Errors are
// exceptions (error.hpp), raised on all processes alike. The tuned constants of the algorithms (docs/constants.md) are
// the same for all cases of a program: those of PETSc's options when the last case was made.
#pragma once

#include <mpi.h>

#include <map>
#include <memory>
#include <string>

namespace gearfilm {

struct CaseInput;

class Case {
public:
  /// Values by their keys, as written in a case file: {"pinion.teeth", "17"}.
  using Values = std::map<std::string, std::string>;

  /// From values alone; keys that are not given have their defaults. Throws InputError where a key is unknown or lacks,
  /// or a value is wrong. Collective.
  Case(MPI_Comm comm, const Values& values);
  /// From a case file under the options of PETSc's database, as the program gearfilm reads it. Throws InputError.
  /// Collective.
  static Case read(MPI_Comm comm, const std::string& file);
  /// A copy of this case in which some keys have other values. Throws InputError. Collective.
  Case with(MPI_Comm comm, const Values& values) const;

  std::string name() const;
  /// The value that a key has, given or by default, as a case file has it; empty without one.
  std::string value(const std::string& key) const;

  /// Half axis of the Hertz ellipse along X at the reference contact, the pitch point of a pair [m].
  double half_axis() const;
  /// Largest pressure of the dry contact there [Pa].
  double hertz_pressure() const;
  /// Static force on it [N].
  double static_force() const;
  /// Mean velocity of the flanks there [m/s].
  double entrainment_velocity() const;
  /// Time from one tooth to the next [s]; of a gear pair.
  double mesh_period() const;

  /// The case as the library's own code reads it.
  const CaseInput& input() const { return *input_; }

private:
  explicit Case(CaseInput input);

  std::shared_ptr<const CaseInput> input_;
};

}  // namespace gearfilm
