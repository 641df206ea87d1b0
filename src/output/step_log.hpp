// The steps of a march, to the bit, in a file that only grows.
//
// One step: the number of its contacts, T, dT, H_0, V_0, Newton and Krylov iterations, seconds; then for each contact
// its number, xi [m] and its quantities. All doubles. The first process reads and writes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "dynamics/step_record.hpp"

namespace gearfilm {

/// How far the steps go, and what they are up to there.
struct StepLogMark {
  std::uint64_t end = 0;       ///< bytes of the steps up to the last one, without the file's mark
  std::uint64_t checksum = 0;  ///< of all values before it (checksum.hpp)
};

class StepLog {
public:
  StepLog(MPI_Comm comm, std::filesystem::path path) : comm_(comm), path_(std::move(path)) {}

  const std::filesystem::path& path() const { return path_; }

  /// Puts steps behind a mark in the place of what follows there; returns the mark behind them. Throws OutputError.
  StepLogMark write(const StepLogMark& before, const std::vector<StepRecord>& records) const;
  /// The mark behind a later step, from what is on the disk: another one than was written, where that is damaged.
  StepLogMark mark_at(std::uint64_t end, const StepLogMark& before) const;
  /// The steps between two offsets, on all processes. Throws InputError where they are not there.
  std::vector<StepRecord> read(std::uint64_t begin, std::uint64_t end) const;

private:
  std::vector<double> values_between(std::uint64_t begin, std::uint64_t end) const;

  MPI_Comm comm_;
  std::filesystem::path path_;
};

}  // namespace gearfilm
