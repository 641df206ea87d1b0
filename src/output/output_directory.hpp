// The folder that receives the results of one run.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "parallel/petsc.hpp"

namespace gearfilm {

class OutputDirectory {
public:
  /// Creates the folder where it is missing, makes sure that files can be written into it, and claims it until the
  /// object goes: two runs in one folder would spoil each other's results. Throws InputError on all processes alike,
  /// also where files of the names of results were not written by this program.
  OutputDirectory(MPI_Comm comm, std::filesystem::path path);
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  /// Path of a file in the folder.
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  /// Removes results.h5, results.xmf and summary.json of an earlier run, which would outlive a failure of this one.
  void remove_earlier_results() const;

private:
  MPI_Comm comm_;
  std::filesystem::path path_;
  int claim_ = -1;  ///< descriptor that holds the lock on the folder, on the first process
};

/// Files are written as part_of(path) and renamed when whole, so that a reader never meets half a file. Collective;
/// throws OutputError.
std::filesystem::path part_of(const std::filesystem::path& path);
void finish_part(MPI_Comm comm, const std::filesystem::path& path);
/// Writes a text whole, by the first process.
void write_whole(MPI_Comm comm, const std::filesystem::path& path, const std::string& text);

/// Writes bytes into a new file, or behind those of an old one; for the process that writes alone. Throws
/// std::system_error.
void write_bytes(const std::filesystem::path& path, std::string_view bytes, std::ios::openmode mode = std::ios::trunc);

}  // namespace gearfilm
