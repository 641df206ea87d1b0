#include "output/stop_request.hpp"

#include <array>

#include "gearfilm/error.hpp"

namespace gearfilm {
namespace {

struct StopSignal {
  int number;
  const char* name;
};
constexpr std::array<StopSignal, 3> stop_signals = {{{SIGTERM, "SIGTERM"}, {SIGINT, "Ctrl-C"}, {SIGUSR1, "SIGUSR1"}}};

volatile std::sig_atomic_t received = 0;

/// The second Ctrl-C ends the program at once.
void receive(int signal) {
  received = signal;
  if (signal == SIGINT) std::signal(SIGINT, SIG_DFL);
}

}  // namespace

StopRequest::StopRequest(std::optional<double> time_limit) : time_limit_(time_limit), start_(MPI_Wtime()) {
  struct sigaction action = {};
  action.sa_handler = receive;
  action.sa_flags = SA_RESTART;  // writing goes on
  static_assert(std::tuple_size_v<decltype(before_)> == stop_signals.size());
  for (std::size_t n = 0; n < stop_signals.size(); ++n) sigaction(stop_signals[n].number, &action, &before_[n]);
}

StopRequest::~StopRequest() {
  for (std::size_t n = 0; n < stop_signals.size(); ++n) sigaction(stop_signals[n].number, &before_[n], nullptr);
}

void StopRequest::check(MPI_Comm comm, double mesh_period) const {
  const bool late = time_limit_ && MPI_Wtime() - start_ > *time_limit_;
  std::array<int, 2> wishes = {static_cast<int>(received), late};
  MPI_Allreduce(MPI_IN_PLACE, wishes.data(), 2, MPI_INT, MPI_MAX, comm);
  if (wishes[0] == 0 && wishes[1] == 0) return;
  std::string why = wishes[0] == 0 ? worded("after the time limit of ", *time_limit_, " s") : "by ";
  for (const StopSignal& signal : stop_signals) {
    if (wishes[0] == signal.number) why += signal.name;
  }
  throw Stopped("at mesh period ", mesh_period, ", ", why,
                "; everything up to there is written; go on with the same command and -restart");
}

std::function<void(double)> StopRequest::check_in(MPI_Comm comm) const {
  return [this, comm](double mesh_periods) { check(comm, mesh_periods); };
}

}  // namespace gearfilm
