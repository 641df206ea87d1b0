#include "app/command_table.hpp"

#include <array>
#include <map>

#include "app/commands.hpp"
#include "bench/bench_pair.hpp"
#include "gearfilm/error.hpp"
#include "input/parameter.hpp"
#include "numerics/tuned.hpp"
#include "output/results_docs.hpp"
#include "results/contact_map_result.hpp"
#include "results/continuation_result.hpp"
#include "results/derived.hpp"
#include "results/eigen_summary.hpp"
#include "results/flank_result.hpp"
#include "results/march_summary.hpp"
#include "results/orbit_summary.hpp"
#include "results/pair_conditions.hpp"
#include "results/poincare_result.hpp"
#include "results/rating_result.hpp"
#include "results/spectrum_result.hpp"
#include "results/static_summary.hpp"
#include "results/steady_result.hpp"
#include "results/sweep_tables.hpp"
#include "results/train_motion.hpp"
#include "results/wear_result.hpp"

namespace gearfilm {
namespace {

/// By their names.
std::string constants_markdown() {
  std::map<std::string, const TunedConstant*> sorted;
  for (const TunedConstant* constant = TunedConstant::first(); constant; constant = constant->next())
    sorted[constant->name()] = constant;
  std::string text =
      "# Tuned constants\n\nThis page is the output of `gearfilm constants`.\n\n"
      "Constants of the algorithms that were chosen by measurement. The option `-NAME` gives one another value; such "
      "values\nare written into the results. No result may change with them by more than its error bar: "
      "`scripts/studies/scan_constants/run`\ntries half and twice of each. Lengths and times without unit are "
      "dimensionless.\n\n| Name | Default | Kind | Meaning |\n|---|---|---|---|\n";
  for (const auto& [name, constant] : sorted)
    text += worded("| `", name, "` | ", constant->by_default(), constant->whole() ? " | count | " : " | number | ",
                   constant->meaning(), " |\n");
  return text;
}

std::string all_quantities() {
  return quantities_markdown() + steady_markdown() + run_markdown() + poincare_markdown() + spectrum_markdown() +
         orbit_markdown() + contact_map_markdown() + flank_markdown() + rating_markdown() + conditions_markdown() +
         basins_markdown() + continuation_markdown() + StaticLoad::markdown() + wear_markdown() + modes_markdown() +
         train_markdown() + train_motion_markdown() + derived_markdown() + bench_markdown();
}

constexpr std::array<Command, 10> case_commands = {{
    {"info", run_info, false, false, "derived quantities of a case, no field solve"},
    {"steady", run_steady, false, false, "stationary film of one contact"},
    {"static", run_static, false, false,
     "transmission error, load shares and mesh stiffness of the dry pair turned slowly"},
    {"transient", run_transient, true, false, "the gear pair marched in time"},
    {"periodic", run_periodic, true, false, "periodic state by shooting, with Floquet multipliers"},
    {"eigen", run_eigen, true, false, "natural frequencies and damping of the pair, dry and on its films"},
    {"sweep", run_sweep, true, true, "periodic states over a range of speeds, torques or masses"},
    {"wear", run_wear, true, false, "flanks that wear over many revolutions, with their profiles"},
    {"continuation", run_continuation, true, false,
     "branches of periodic states through folds and flips, all bifurcations located"},
    {"bench", run_bench, false, true, "speed of the kernels, of stationary films and of a mesh period"},
}};

constexpr std::array<TextCommand, 3> printing_commands = {{
    {"parameters", parameter_markdown, "the table of all parameters in Markdown (needs no case)"},
    {"constants", constants_markdown, "the table of tuned constants of the algorithms in Markdown (needs no case)"},
    {"figures", all_quantities, "the tables of all quantities in the results in Markdown (needs no case)"},
}};

}  // namespace

std::span<const Command> commands() { return case_commands; }
std::span<const TextCommand> text_commands() { return printing_commands; }

std::string command_names() {
  std::string names;
  for (const Command& command : commands()) names += (names.empty() ? "" : ", ") + std::string(command.name);
  for (const TextCommand& command : text_commands()) names += ", " + std::string(command.name);
  return names;
}

}  // namespace gearfilm
