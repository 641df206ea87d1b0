// An array of a file, cut among the processes.
#pragma once

#include <hdf5.h>

#include <vector>

namespace gearfilm {

struct DistributedArray {
  std::vector<hsize_t> all;    ///< its extents
  std::vector<hsize_t> begin;  ///< of this process's part
  std::vector<hsize_t> count;  ///< extents of that part
  std::vector<double> values;  ///< of that part, the last index fastest
};

}  // namespace gearfilm
