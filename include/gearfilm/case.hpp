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

  /// Makes a case of these values; keys that are not given have their defaults. Throws InputError where a key is
  /// unknown, a required key is missing, or a value is wrong. Collective.
  Case(MPI_Comm comm, const Values& values);
  /// Reads a case file as the program gearfilm does: options of PETSc's database override the file. Throws InputError.
  /// Collective.
  static Case read(MPI_Comm comm, const std::string& file);
  /// A copy of this case in which some keys have other values. Throws InputError. Collective.
  Case with(MPI_Comm comm, const Values& values) const;

  std::string name() const;
  /// The value of a key, given or by default, as text of a case file; empty where the key has no value.
  std::string value(const std::string& key) const;

  /// Half axis of the Hertz ellipse along X at the reference contact, which is that of a pair at its pitch point [m].
  double half_axis() const;
  /// Largest pressure of the dry reference contact [Pa].
  double hertz_pressure() const;
  /// Static force on the reference contact [N].
  double static_force() const;
  /// Mean velocity of both surfaces at the reference contact [m/s].
  double entrainment_velocity() const;
  /// Mesh period of a gear pair, the time from one tooth to the next [s].
  double mesh_period() const;

  /// The case as the library's own sources use it; no part of the public interface.
  const CaseInput& input() const { return *input_; }

private:
  explicit Case(CaseInput input);

  std::shared_ptr<const CaseInput> input_;
};

}  // namespace gearfilm
