// The wish from outside that a long run should stop: SIGTERM and SIGUSR1, which batch systems send before their limit,
// or a limit of the program's own.
#pragma once

#include <array>
#include <csignal>
#include <functional>
#include <optional>

#include "parallel/petsc.hpp"

namespace gearfilm {

class StopRequest {
public:
  /// From here on the signals end the run at its next check(). time_limit [s], counted from here.
  explicit StopRequest(std::optional<double> time_limit);
  ~StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  /// Throws Stopped on all processes where any of them is to stop. mesh_period: how far the run is. Collective.
  void check(MPI_Comm comm, double mesh_period) const;
  /// check() as a function of the mesh periods that a run has come to; it must not outlive this request.
  std::function<void(double)> check_in(MPI_Comm comm) const;

private:
  std::optional<double> time_limit_;
  double start_;
  std::array<struct sigaction, 3> before_{};  ///< what the signals did before
};

}  // namespace gearfilm
