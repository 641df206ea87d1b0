#include "gearfilm/io/output_directory.hpp"

#include <fstream>
#include <string>

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

/// Text of the obstacle, empty if there is none.
std::string obstacle(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) return error.message();
  const std::filesystem::path probe = directory / ".gearfilm_write_probe";
  if (!std::ofstream(probe)) return "no permission to write";
  std::filesystem::remove(probe, error);
  return {};
}

}  // namespace

void prepare_output_directory(MPI_Comm comm, const std::filesystem::path& directory) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  std::string reason;
  if (rank == 0) reason = obstacle(directory);
  int length = static_cast<int>(reason.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, comm);
  reason.resize(length);
  MPI_Bcast(reason.data(), length, MPI_CHAR, 0, comm);
  if (!reason.empty()) {
    throw InputError("cannot write results into '" + directory.string() + "': " + reason +
                     "; choose another folder with -output_dir");
  }
}

void remove_earlier_results(MPI_Comm comm, const std::filesystem::path& directory) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  std::error_code ignored;
  if (rank == 0) {
    for (const char* name : {"results.h5", "results.xmf", "summary.json"}) {
      std::filesystem::remove(directory / name, ignored);
    }
  }
  MPI_Barrier(comm);
}

std::filesystem::path part_of(const std::filesystem::path& path) {
  std::filesystem::path part = path;
  part += ".part";
  return part;
}

void finish_part(MPI_Comm comm, const std::filesystem::path& path) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  if (rank == 0) std::filesystem::rename(part_of(path), path);
  MPI_Barrier(comm);
}

}  // namespace gearfilm
