// Fields of a grid with a description, in one file that is there whole or not at all.
//
//   16 bytes      restart_mark.hpp
//   16 bytes      length of the description, and its checksum
//   description   JSON; "format", "fields" (how many), "nodes" ([nx, rows]), "edges" ([X_min, X_max, Y_half]) and
//                 "checksum" of the fields are added to it
//   fields        doubles, one field after the other as (nx, rows), rows those with Y >= 0
// Does not depend on the number of processes. Written and read by all together (MPI-IO). What was damaged since, even
// if it kept its size, is as good as missing.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "dynamics/pair_state.hpp"
#include "grid/grid.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Compact fields, this process's part.
using CompactFields = std::vector<std::vector<double>>;

/// The films of a state as fields, contact after contact, and the names of each contact's for the description.
CompactFields fields_of(const PairState& state);
Summary field_names(const PairState& state);
/// Back from the first of a list.
std::vector<ContactFields> films_from(const CompactFields& fields, const Summary& names);

/// Collective; throws OutputError. The file is on the disk, under its name, when the call returns. The description is
/// that of the first process.
void write_state(const Grid& grid, const std::filesystem::path& path, Summary description, const CompactFields& fields);

struct StateFile {
  Summary description;
  GridShape shape;
  CompactFields fields;
};

/// Nothing where the file is missing, not whole, or damaged. Throws InputError where it is of another format version.
/// Collective.
std::optional<StateFile> read_state(MPI_Comm comm, const std::filesystem::path& path);

}  // namespace gearfilm
