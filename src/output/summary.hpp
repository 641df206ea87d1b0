// summary.json: the main results of a run, values in SI, dimensionless ones under their symbol.
#pragma once

#include <complex>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "mesh/motion.hpp"
#include "parallel/petsc.hpp"

namespace gearfilm {

/// Keeps the order in which results were added.
using Summary = nlohmann::ordered_json;

/// A motion is the list of its q and its v.
inline void to_json(Summary& json, const Motion& motion) {
  const Eigen::VectorXd x = to_vector(motion);
  json = std::vector<double>(x.begin(), x.end());
}
inline void from_json(const Summary& json, Motion& motion) { motion = motion_from(json.get<std::vector<double>>()); }

/// Writes the file (first process); throws SolveError, and writes nothing, where a number is not finite.
void write_json(MPI_Comm comm, const std::filesystem::path& path, const Summary& values);

/// Writes summary.json of a folder, with the provenance of the results (provenance.hpp) behind them.
void write_summary(MPI_Comm comm, const std::filesystem::path& folder, Summary summary);

}  // namespace gearfilm

/// Real and imaginary part.
template <>
struct nlohmann::adl_serializer<std::complex<double>> {
  static void to_json(ordered_json& json, const std::complex<double>& value) { json = {value.real(), value.imag()}; }
};
