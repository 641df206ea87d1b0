#include "output/summary.hpp"

#include <cmath>

#include "gearfilm/error.hpp"
#include "output/output_directory.hpp"
#include "output/provenance.hpp"

namespace gearfilm {
namespace {

void require_finite(const Summary& value, const std::string& name) {
  if (value.is_structured()) {
    for (const auto& [key, item] : value.items()) require_finite(item, name.empty() ? key : name + "." + key);
  } else if (value.is_number_float() && !std::isfinite(value.get<double>())) {
    throw SolveError("result '" + name + "' is not finite; nothing of it is written");
  }
}

}  // namespace

void write_json(MPI_Comm comm, const std::filesystem::path& path, const Summary& values) {
  require_finite(values, "");
  write_whole(comm, path, values.dump(2) + '\n');
}

void write_summary(MPI_Comm comm, const std::filesystem::path& folder, Summary summary) {
  summary["provenance"] = provenance(comm);
  write_json(comm, folder / "summary.json", summary);
}

}  // namespace gearfilm
