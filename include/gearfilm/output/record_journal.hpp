// The steps of a march, to the bit, in a file that only grows: whatever of it is on disk is whole.
//
// One step: the number of its contacts, T, dT, H_0, V_0, Newton and Krylov iterations, seconds; then for each contact
// its number, xi [m] and its figures. All doubles. The first process reads and writes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "gearfilm/dynamics/step_record.hpp"

namespace gearfilm {

class RecordJournal {
public:
  RecordJournal(MPI_Comm comm, std::filesystem::path path) : comm_(comm), path_(std::move(path)) {}

  /// Puts steps at an offset [bytes] in the place of what follows there, down to the disk; returns the offset behind
  /// them. Throws OutputError.
  std::uint64_t write(std::uint64_t offset, const std::vector<StepRecord>& records) const;
  /// The steps between two offsets, on all processes. Throws InputError where they are not there.
  std::vector<StepRecord> read(std::uint64_t begin, std::uint64_t end) const;

private:
  MPI_Comm comm_;
  std::filesystem::path path_;
};

}  // namespace gearfilm
