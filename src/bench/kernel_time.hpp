// The time of one kernel on one grid, as `bench` reports it.
#pragma once

#include <string>

#include "results/members.hpp"

namespace gearfilm {

struct KernelTime {
  std::string name;
  double seconds = 0.0;
  double nodes = 0.0;  ///< of the grid
  double unit = 0.0;   ///< a convolution's time on it [s]

  double ns_per_node() const { return 1e9 * seconds / nodes; }
  double convolutions() const { return seconds / unit; }
};

inline constexpr auto kernel_members = std::to_array<Member<KernelTime>>({
    {"kernel", "", "", "what was done", [](const KernelTime& of) -> Summary { return of.name; }},
    {"seconds", "", "s", "median time", [](const KernelTime& of) -> Summary { return of.seconds; }},
    {"ns_per_node", "", "ns", "time a node", [](const KernelTime& of) -> Summary { return of.ns_per_node(); }},
    {"convolutions", "", "-", "the same in convolution times of the grid",
     [](const KernelTime& of) -> Summary { return of.convolutions(); }},
});

}  // namespace gearfilm
