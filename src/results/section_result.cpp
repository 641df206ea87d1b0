#include "results/section_result.hpp"

#include <algorithm>

#include "stress/place_sums.hpp"

namespace gearfilm {
namespace {

/// At own depths, [depth][line].
std::vector<Stress> stresses_of(const SectionRecord& record) {
  std::vector<Stress> stresses;
  for (int depth = 0; depth < record.depths; ++depth) {
    for (int line = 0; line < record.places.count; ++line) {
      stresses.push_back(record.at(depth, record.places.first + line * record.places.step));
    }
  }
  return stresses;
}

double largest_von_mises(const SectionRecord& record) {
  double largest = 0.0;
  for (const Stress& stress : stresses_of(record)) largest = std::max(largest, von_mises(stress));
  return largest;
}

}  // namespace

void write_stresses(ResultsFile& file, const std::string& group, const std::string& ending, int depths, int lines,
                    const std::vector<Stress>& stresses) {
  constexpr std::array<const char*, stress_components> names = {"xx", "yy", "zz", "yz", "xz", "xy"};
  const auto write = [&](const std::string& name, const auto& value) {
    std::vector<double> values(stresses.size());
    std::ranges::transform(stresses, values.begin(), value);
    file.rows(group, name + ending, "Pa", depths, lines, values);
  };
  write("von_mises", [](const Stress& stress) { return von_mises(stress); });
  for (std::size_t c = 0; c < names.size(); ++c) {
    write(std::string("sigma_") + names[c], [c](const Stress& stress) { return stress.components()[c]; });
  }
}

WorstSection worst_section(MPI_Comm comm, std::span<const int> depth_ranges, const std::vector<Passage>& passages,
                           std::size_t body) {
  std::vector<std::pair<const SectionRecord*, std::size_t>> all;
  std::vector<double> largest;
  for (const Passage& passage : passages) {
    for (std::size_t row = 0; row < passage.size(); ++row) {
      for (const SectionRecord& record : passage[row][body].records()) {
        all.emplace_back(&record, row);
        largest.push_back(largest_von_mises(record));
      }
    }
  }
  // The same records on all processes, each with its depths.
  MPI_Allreduce(MPI_IN_PLACE, largest.data(), static_cast<int>(largest.size()), MPI_DOUBLE, MPI_MAX, comm);
  const auto& [record, row] = all[std::ranges::max_element(largest) - largest.begin()];
  WorstSection worst{record->xi, row, {}, {}};
  for (int line = 0; line < record->places.count; ++line) {
    worst.x.push_back(record->places.first + line * record->places.step);
  }
  worst.stress = gather_stresses(comm, depth_ranges, worst.x.size(), stresses_of(*record));
  return worst;
}

}  // namespace gearfilm
