#include "output/rank_file.hpp"

#include <fstream>
#include <string>

#include "output/checksum.hpp"
#include "output/output_directory.hpp"
#include "output/restart_mark.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

/// Places of one process come far behind those of the one before it.
RankFilesMark mark_of(MPI_Comm comm, const std::vector<double>& values) {
  RankFilesMark mark{processes_in(comm), checksum(values, static_cast<std::uint64_t>(rank_in(comm)) << 40U)};
  MPI_Allreduce(MPI_IN_PLACE, &mark.checksum, 1, MPI_UINT64_T, MPI_SUM, comm);
  return mark;
}

}  // namespace

RankFilesMark write_rank_file(MPI_Comm comm, const std::filesystem::path& path, const std::vector<double>& values) {
  write_together(comm, path, [&] {
    write_bytes(path, restart_mark);
    write_bytes(path, {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)}, std::ios::app);
  });
  return mark_of(comm, values);
}

std::optional<std::vector<double>> read_rank_file(MPI_Comm comm, const std::filesystem::path& path,
                                                  const RankFilesMark& mark) {
  if (processes_in(comm) != mark.processes) return std::vector<double>();
  std::error_code missing;
  const std::uintmax_t size = std::filesystem::file_size(path, missing);
  const bool marked = !missing && size >= restart_mark.size();
  std::vector<double> values(marked ? (size - restart_mark.size()) / sizeof(double) : 0);
  std::string mark_found(restart_mark.size(), ' ');
  std::ifstream file(path, std::ios::binary);
  file.read(mark_found.data(), static_cast<std::streamsize>(mark_found.size()));
  file.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(double)));
  const bool whole = file && marked && mark_found == restart_mark && size % sizeof(double) == 0;
  const bool all_whole = first_of_all_reasons(comm, whole ? "" : "not whole").empty();
  if (mark_of(comm, values).checksum != mark.checksum || !all_whole) return {};
  return values;
}

}  // namespace gearfilm
