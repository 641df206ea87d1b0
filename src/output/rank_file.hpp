// Values that each process keeps for itself, in a file of its own, with a checksum over the files of all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "parallel/petsc.hpp"

namespace gearfilm {

/// What was written: by how many processes, and the checksum.
struct RankFilesMark {
  int processes = 0;
  std::uint64_t checksum = 0;
};

/// Writes the values of each process to a file of its own. Collective, as is read_rank_file(). Throws OutputError.
RankFilesMark write_rank_file(MPI_Comm comm, const std::filesystem::path& path, const std::vector<double>& values);

/// Reads the values of each process back: an empty list where another number of processes wrote them, nothing where the
/// file of any process is missing, not whole, or damaged. Collective.
std::optional<std::vector<double>> read_rank_file(MPI_Comm comm, const std::filesystem::path& path,
                                                  const RankFilesMark& mark);

}  // namespace gearfilm
