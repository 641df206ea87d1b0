#include "parallel/agreement.hpp"

#include <chrono>
#include <thread>

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

constexpr std::uintmax_t almost_full = 1 << 16;  // [bytes]

constexpr double patience = 5.0;  // [s]

/// Why a write failed, as far as the file system shows it; otherwise what the failed call said.
std::string cause(const std::filesystem::path& path, const std::string& reason) {
  std::error_code error;
  const std::filesystem::path folder = path.parent_path();
  if (!std::filesystem::is_directory(folder, error)) return "its folder is gone";
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  if (!error && space.available < almost_full) return "the disk is full";
  return reason;
}

}  // namespace

int rank_in(MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank;
}

int processes_in(MPI_Comm comm) {
  int processes = 1;
  MPI_Comm_size(comm, &processes);
  return processes;
}

void broadcast(MPI_Comm comm, std::string& text) {
  unsigned long long length = text.size();
  MPI_Bcast(&length, 1, MPI_UNSIGNED_LONG_LONG, 0, comm);
  text.resize(length);
  MPI_Bcast(text.data(), static_cast<int>(length), MPI_CHAR, 0, comm);
}

void wait_asleep(MPI_Request& request) {
  for (int done = 0; !done;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (!done) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

void wait_asleep(MPI_Comm comm) {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(comm, &request);
  wait_asleep(request);
}

bool wait_briefly(MPI_Request& request) {
  int done = 0;
  for (const double begin = MPI_Wtime(); !done && MPI_Wtime() - begin < patience;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (!done) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return done != 0;
}

namespace {

/// The text of a process, on all; empty where there is no such process.
std::string text_of(MPI_Comm comm, int process, std::string own) {
  if (process == processes_in(comm)) return {};
  int length = static_cast<int>(own.size());
  MPI_Bcast(&length, 1, MPI_INT, process, comm);
  own.resize(length);
  MPI_Bcast(own.data(), length, MPI_CHAR, process, comm);
  return own;
}

}  // namespace

std::string first_of_all_reasons(MPI_Comm comm, const std::string& own) {
  int first = own.empty() ? processes_in(comm) : rank_in(comm);
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, comm);
  return text_of(comm, first, own);
}

std::string first_reason(MPI_Comm comm, const std::string& own) {
  const int size = processes_in(comm);
  const int own_place = own.empty() ? size : rank_in(comm);
  int first = size;
  MPI_Request agreement = MPI_REQUEST_NULL;
  MPI_Iallreduce(&own_place, &first, 1, MPI_INT, MPI_MIN, comm, &agreement);
  if (own.empty()) {
    MPI_Wait(&agreement, MPI_STATUS_IGNORE);
  } else if (!wait_briefly(agreement)) {
    return own;  // the others are stuck in what failed here
  }
  return text_of(comm, first, own);
}

void require_written(MPI_Comm comm, const std::filesystem::path& path, const std::string& own_reason) {
  const std::string reason = first_reason(comm, own_reason.empty() ? own_reason : cause(path, own_reason));
  if (reason.empty()) return;
  throw OutputError("cannot write '" + path.string() + "': " + reason +
                    "; correct that and run again (a march or a search goes on with -restart)");
}

}  // namespace gearfilm
