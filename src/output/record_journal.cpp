#include "gearfilm/output/record_journal.hpp"

#include <fstream>

#include "gearfilm/error.hpp"
#include "gearfilm/output/output_directory.hpp"
#include "gearfilm/parallel/agreement.hpp"

namespace gearfilm {
namespace {

void pack(const StepRecord& record, std::vector<double>& values) {
  values.insert(values.end(),
                {static_cast<double>(record.contacts.size()), record.T, record.dT, record.motion.H0, record.motion.V0,
                 static_cast<double>(record.newton), static_cast<double>(record.krylov), record.wall_seconds});
  for (const ContactRecord& contact : record.contacts) {
    values.insert(values.end(), {static_cast<double>(contact.contact), contact.position});
    values.insert(values.end(), contact.figures.values.begin(), contact.figures.values.end());
  }
}

/// Takes values off the front of a list.
class Unpacking {
public:
  explicit Unpacking(const std::vector<double>& values) : values_(values) {}
  bool done() const { return next_ >= values_.size(); }
  double real() { return values_.at(next_++); }
  int whole() { return static_cast<int>(real()); }

private:
  const std::vector<double>& values_;
  std::size_t next_ = 0;
};

StepRecord unpack(Unpacking& values) {
  StepRecord record;
  record.contacts.resize(static_cast<std::size_t>(values.whole()));
  record.T = values.real();
  record.dT = values.real();
  record.motion.H0 = values.real();
  record.motion.V0 = values.real();
  record.newton = values.whole();
  record.krylov = values.whole();
  record.wall_seconds = values.real();
  for (ContactRecord& contact : record.contacts) {
    contact.contact = values.whole();
    contact.position = values.real();
    for (double& figure : contact.figures.values) figure = values.real();
  }
  return record;
}

}  // namespace

std::uint64_t RecordJournal::write(std::uint64_t offset, const std::vector<StepRecord>& records) const {
  std::vector<double> values;
  for (const StepRecord& record : records) pack(record, values);
  const std::uint64_t size = values.size() * sizeof(double);
  write_together(comm_, path_, [&] {
    if (rank_in(comm_) != 0) return;
    if (offset > 0) std::filesystem::resize_file(path_, offset);
    write_bytes(path_, {reinterpret_cast<const char*>(values.data()), size},
                offset > 0 ? std::ios::app : std::ios::trunc);
    flush_to_disk(path_);
  });
  return offset + size;
}

std::vector<StepRecord> RecordJournal::read(std::uint64_t begin, std::uint64_t end) const {
  std::vector<double> values((end - begin) / sizeof(double));
  std::string reason;
  if (rank_in(comm_) == 0) {
    std::ifstream file(path_, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(begin));
    file.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(end - begin));
    if (!file) reason = path_.string() + " lacks steps that were there; start anew, without -restart";
  }
  broadcast(comm_, reason);
  if (!reason.empty()) throw InputError(reason);
  MPI_Bcast(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, 0, comm_);
  std::vector<StepRecord> records;
  for (Unpacking rest(values); !rest.done();) records.push_back(unpack(rest));
  return records;
}

}  // namespace gearfilm
