// results.xmf beside results.h5: the description by which ParaView opens the fields, as a series in time from 0.
//
// The contacts are blocks, each a series in time of its own. Readers know a block by its name and its place among the
// others, so both stay: the block `pair0`, `pair1`, ... of a contact is what the most contacts at a time leave of its
// number, and a block without a contact has no extent.
#pragma once

#include <mpi.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "grid/grid.hpp"

namespace gearfilm {

/// How every file begins.
constexpr std::string_view xdmf_head = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n  <Domain>\n";

/// A group of results.h5 with the fields of one contact.
struct FieldGroup {
  int contact = 0;
  std::string name;
  std::string mesh;  ///< the dataset of the coordinates
  GridShape shape;
  std::vector<std::string> datasets;
};

/// The contacts at one time [s].
struct TimedFields {
  double time = 0.0;
  std::vector<FieldGroup> groups;
};

void write_xdmf(MPI_Comm comm, const std::filesystem::path& path, const std::string& results_name,
                const std::vector<TimedFields>& series);

}  // namespace gearfilm
