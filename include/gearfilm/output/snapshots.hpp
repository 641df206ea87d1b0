// Pressure and film fields of a march at chosen times, in results.h5 and as a time series for ParaView.
//
//   /mesh/x, y, mesh                       coordinates of every contact's grid [m] (results_file.hpp)
//   /snapshots/0000                        attributes T, t
//   /snapshots/0000/contact0/P, H          [Pa], [m]; attribute xi
#pragma once

#include "gearfilm/output/film_snapshot.hpp"
#include "gearfilm/output/results_file.hpp"

namespace gearfilm {

class Snapshots {
public:
  /// xdmf: the file that describes them, rewritten whole at every snapshot.
  Snapshots(ResultsFile& file, const Grid& grid, const Scales& scales, std::filesystem::path xdmf);

  void write(const FilmSnapshot& snapshot);

private:
  ResultsFile& file_;
  WholeDomain domain_;
  Scales scales_;
  std::filesystem::path xdmf_;
  std::vector<TimedFields> written_;
};

}  // namespace gearfilm
