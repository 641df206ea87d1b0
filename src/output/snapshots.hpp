// Pressure and film fields of a march at chosen times, in results.h5 and as a time series for ParaView.
//
//   /mesh/x, y, mesh                       coordinates of every contact's grid [m] (results_file.hpp)
//   /mesh1/..., /mesh2/...                 the same once the grid was widened
//   /snapshots/0000                        attributes T, t, mesh: the group with its coordinates
//   /snapshots/0000/contact0/P, H          [Pa], [m]; attribute xi
#pragma once

#include <memory>

#include "output/film_snapshot.hpp"
#include "output/results_file.hpp"
#include "output/xdmf.hpp"

namespace gearfilm {

/// Writes the fields of one contact in SI, by what is to be known of their names; axes: the group of their coordinates.
/// Returns the names of the datasets. Collective.
std::vector<std::string> write_fields(ResultsFile& file, const std::string& group, const WholeDomain& domain,
                                      const Scales& scales, const std::vector<NamedField>& fields,
                                      const std::string& axes);

class Snapshots {
public:
  /// xdmf: the file that describes them, rewritten whole at every snapshot.
  Snapshots(ResultsFile& file, Scales scales, std::filesystem::path xdmf);

  void write(const FilmSnapshot& snapshot);

private:
  /// A grid in the file.
  struct Mesh {
    Mesh(Grid of, std::string in) : grid(std::move(of)), domain(grid), group(std::move(in)) {}

    Grid grid;
    WholeDomain domain;
    std::string group;
  };

  const Mesh& mesh_of(const GridShape& shape);

  ResultsFile& file_;
  std::vector<std::unique_ptr<Mesh>> meshes_;
  Scales scales_;
  std::filesystem::path xdmf_;
  std::vector<TimedFields> written_;
};

}  // namespace gearfilm
