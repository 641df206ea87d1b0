#include "output/output_directory.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include "gearfilm/error.hpp"
#include "output/file_ownership.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

constexpr std::array results = {"results.h5", "results.xmf", "summary.json", "run.json", "shares.txt"};

// Less room than this would end a run that has just removed earlier results.
constexpr std::size_t least_room = 1 << 18;  // [bytes]

/// Text of the obstacle to writing into a folder, empty if there is none.
std::string obstacle(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) return error.message();
  const std::filesystem::path probe = directory / ".gearfilm_write_probe";
  std::string reason;
  try {
    write_bytes(probe, std::string(least_room, ' '));
  } catch (const std::system_error& failure) {
    reason = failure.code().message();
  }
  std::filesystem::remove(probe, error);
  return reason;
}

}  // namespace

OutputDirectory::OutputDirectory(MPI_Comm comm, std::filesystem::path path) : comm_(comm), path_(std::move(path)) {
  std::string reason;
  if (rank_in(comm_) == 0) {
    reason = obstacle(path_);
    if (reason.empty()) {
      // The system lets go of the lock with the process, however this ends. Where folders cannot be locked (some
      // network file systems), two runs are not told apart.
      claim_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (claim_ >= 0 && flock(claim_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        reason = "another run is at work there";
      }
    }
  }
  broadcast(comm_, reason);
  try {
    if (!reason.empty()) {
      throw InputError("cannot write results into '" + path_.string() + "': " + reason +
                       "; choose another folder with -output_dir");
    }
    std::vector<std::filesystem::path> files;
    files.reserve(results.size());
    for (const char* name : results) files.push_back(path_ / name);
    require_replaceable(comm_, files);
  } catch (const InputError&) {
    if (claim_ >= 0) close(claim_);
    throw;
  }
}

OutputDirectory::~OutputDirectory() {
  if (claim_ >= 0) close(claim_);
}

void OutputDirectory::remove_earlier_results() const {
  if (rank_in(comm_) == 0) {
    for (const char* name : results) remove_if_written_here(path_ / name);
  }
  MPI_Barrier(comm_);
}

std::filesystem::path part_of(const std::filesystem::path& path) {
  std::filesystem::path part = path;
  part += ".part";
  return part;
}

void finish_part(MPI_Comm comm, const std::filesystem::path& path) {
  write_together(comm, path, [&] {
    if (rank_in(comm) == 0) std::filesystem::rename(part_of(path), path);
  });
}

void write_whole(MPI_Comm comm, const std::filesystem::path& path, const std::string& text) {
  write_together(comm, path, [&] {
    if (rank_in(comm) == 0) write_bytes(part_of(path), text);
  });
  finish_part(comm, path);
}

void write_bytes(const std::filesystem::path& path, std::string_view bytes, std::ios::openmode mode) {
  errno = 0;
  std::ofstream file(path, std::ios::binary | mode);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw std::system_error(errno, std::generic_category());
}

}  // namespace gearfilm
