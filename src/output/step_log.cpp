#include "output/step_log.hpp"

#include <fstream>

#include "dynamics/binary_stream.hpp"
#include "gearfilm/error.hpp"
#include "output/checksum.hpp"
#include "output/output_directory.hpp"
#include "output/restart_mark.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

void pack(const StepRecord& record, std::vector<double>& values) {
  values.insert(values.end(), {static_cast<double>(record.contacts.size()), record.T, record.dT});
  append(values, record.motion);
  values.insert(values.end(),
                {record.back_force, static_cast<double>(record.newton), static_cast<double>(record.krylov),
                 static_cast<double>(record.halvings), record.wall_seconds});
  for (const ContactRecord& contact : record.contacts) {
    values.insert(values.end(), {static_cast<double>(contact.number), contact.position});
    values.insert(values.end(), contact.quantities.values.begin(), contact.quantities.values.end());
  }
}

StepRecord unpack(ValueReader& values) {
  StepRecord record;
  record.contacts.resize(values.count());
  record.T = values.value();
  record.dT = values.value();
  record.motion = values.motion();
  record.back_force = values.value();
  record.newton = values.whole();
  record.krylov = values.whole();
  record.halvings = values.whole();
  record.wall_seconds = values.value();
  for (ContactRecord& contact : record.contacts) {
    contact.number = values.whole();
    contact.position = values.value();
    for (double& quantity : contact.quantities.values) quantity = values.value();
  }
  return record;
}

}  // namespace

// The seconds of a step are not the same on all processes: those of the first one are kept.
StepLogMark StepLog::write(const StepLogMark& before, const std::vector<StepRecord>& records) const {
  std::vector<double> values;
  for (const StepRecord& record : records) pack(record, values);
  const std::uint64_t size = values.size() * sizeof(double);
  std::uint64_t part = checksum(values, before.end / sizeof(double));
  MPI_Bcast(&part, 1, MPI_UINT64_T, 0, comm_);
  write_together(comm_, path_, [&] {
    if (rank_in(comm_) != 0) return;
    if (before.end > 0) {
      std::filesystem::resize_file(path_, restart_mark.size() + before.end);
    } else {
      write_bytes(path_, restart_mark);
    }
    write_bytes(path_, {reinterpret_cast<const char*>(values.data()), size}, std::ios::app);
  });
  return {before.end + size, before.checksum + part};
}

StepLogMark StepLog::mark_at(std::uint64_t end, const StepLogMark& before) const {
  std::uint64_t part = 0;
  if (rank_in(comm_) == 0) part = checksum(values_between(before.end, end), before.end / sizeof(double));
  MPI_Bcast(&part, 1, MPI_UINT64_T, 0, comm_);
  return {end, before.checksum + part};
}

/// Empty where they are not all there.
std::vector<double> StepLog::values_between(std::uint64_t begin, std::uint64_t end) const {
  std::vector<double> values((end - begin) / sizeof(double));
  std::ifstream file(path_, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(restart_mark.size() + begin));
  file.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(end - begin));
  return file ? values : std::vector<double>();
}

std::vector<StepRecord> StepLog::read(std::uint64_t begin, std::uint64_t end) const {
  const std::size_t count = (end - begin) / sizeof(double);
  std::vector<double> values;
  std::string reason;
  if (rank_in(comm_) == 0) {
    values = values_between(begin, end);
    if (values.size() < count) reason = path_.string() + " lacks steps that were there; start again without -restart";
  }
  broadcast(comm_, reason);
  if (!reason.empty()) throw InputError(reason);
  values.resize(count);
  MPI_Bcast(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, 0, comm_);
  std::vector<StepRecord> records;
  for (ValueReader rest(values); !rest.at_end();) records.push_back(unpack(rest));
  return records;
}

}  // namespace gearfilm
