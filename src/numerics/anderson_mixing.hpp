// Anderson's mixing for a fixed point x = G(x).
//
//   x' = x + b f - sum_j c_j (dx_j + b df_j),  f = G(x) - x,  c: least squares of f - sum_j c_j df_j
// dx_j, df_j: differences between the last steps. Without any it is a step by the part b of f.
#pragma once

#include <deque>
#include <vector>

#include "parallel/petsc.hpp"

namespace gearfilm {

class AndersonMixing {
public:
  /// At most `depth` differences are kept; relaxation: b.
  AndersonMixing(MPI_Comm comm, int depth, double relaxation) : comm_(comm), depth_(depth), relaxation_(relaxation) {}

  /// The change x' - x from x and f, of which each process has its own entries; entries count by the squares of their
  /// size. Collective.
  std::vector<double> change(const std::vector<double>& x, const std::vector<double>& f);
  /// Forgets the last steps.
  void restart();

private:
  struct Difference {
    std::vector<double> x, f;
  };

  MPI_Comm comm_;
  int depth_;
  double relaxation_;
  std::vector<double> last_x_, last_f_;
  std::deque<Difference> differences_;
};

}  // namespace gearfilm
