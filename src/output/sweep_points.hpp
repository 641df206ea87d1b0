// The points of a sweep on disk: one small JSON file each, written when the point is done, so that an interrupted sweep
// goes on where it stopped.
//
//   sweep.json                the parameters of the sweep; another sweep must not mix its points with these
//   points/up_0003.json       the fourth point of the way up: its results, or the error that ended it
//   points/up_0003.films      the films of its periodic state, until the next point is done
//   points/up_0003.checkpoint the search for it, as long as it goes on; over the whole face, where it came to the ends
//                             of the face, in points/up_0003.whole_face.checkpoint
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/case.hpp"
#include "output/summary.hpp"

namespace gearfilm {

enum class SweepDirection { up, down };

/// index counts the values of the sweep in ascending order, whatever the direction.
struct SweepPoint {
  SweepDirection direction = SweepDirection::up;
  std::size_t index = 0;
};

class SweepPoints {
public:
  /// Collective. Throws InputError where the folder holds points of another sweep.
  SweepPoints(MPI_Comm comm, const CaseInput& problem, const std::string& command = "sweep");

  std::filesystem::path file(const SweepPoint& point, const std::string& extension = ".json") const;
  /// What is known of a point; nothing where it is still to be computed. Collective on a group of processes, as are
  /// the others: the first one reads, since a file system may show the same file to some processes later than to
  /// others.
  std::optional<Summary> read(MPI_Comm group, const SweepPoint& point) const;
  void write(MPI_Comm group, const SweepPoint& point, const Summary& result) const;
  /// All points are done: removes what only further ones would need. Collective.
  void complete(MPI_Comm comm) const;

private:
  std::filesystem::path folder_;
};

}  // namespace gearfilm
