// `gearfilm steady`: the stationary film of one contact at one position on the line of action.
#include <iomanip>

#include "app/commands.hpp"
#include "app/result_warnings.hpp"
#include "input/case_setup.hpp"
#include "output/output_directory.hpp"
#include "output/progress.hpp"
#include "output/screen.hpp"
#include "output/screen_table.hpp"
#include "results/steady_result.hpp"

namespace gearfilm {
namespace {

/// Says where the films are less accurate than they should be.
void warn_of_errors(MPI_Comm comm, const CaseInput& problem, const std::optional<GridErrors>& errors) {
  const bool chosen = chooses_nodes(problem);
  const double aim = chosen ? problem.parameters.real("grid.accuracy") : tolerable_error(problem);
  if (errors && errors->left() <= aim) return;
  warn(comm,
       errors ? worded(std::setprecision(2), "the films have an error of about ", 100.0 * errors->worst(), " %")
              : "the error of the films is not known, since a grid of half the nodes has no film",
       chosen ? "; lower grid.accuracy" : "; raise grid.nx and grid.ny, or leave them to the program");
}

void print_shear(MPI_Comm comm, const Summary& summary) {
  if (!summary.contains("shear_factor")) return;
  const auto real = [&](const char* name) { return summary[name].get<double>(); };
  petsc_check(PetscPrintf(comm,
                          "of a Newtonian oil %.4f um central, %.4f um smallest: factors of shear thinning %.3f and "
                          "%.3f; settled to %.1e in %d turns\n",
                          1e6 * real("h_central_newtonian"), 1e6 * real("h_min_newtonian"), real("shear_factor"),
                          real("shear_factor_min"), real("shear_change"), summary["shear_turns"].get<int>()));
}

void print_heating(MPI_Comm comm, const Summary& summary) {
  if (!summary.contains("thermal_factor")) return;
  const auto real = [&](const char* name) { return summary[name].get<double>(); };
  petsc_check(PetscPrintf(comm,
                          "without heat in the film %.4f um central, %.4f um smallest: thermal factors %.3f and %.3f, "
                          "Murch-Wilson's for rolling %.3f; settled to %.1e in %d turns\n",
                          1e6 * real("h_central_isothermal"), 1e6 * real("h_min_isothermal"), real("thermal_factor"),
                          real("thermal_factor_min"),
                          summary["predictions"]["murch_wilson_thermal_factor"].get<double>(), real("thermal_change"),
                          summary["thermal_turns"].get<int>()));
}

void print_friction(MPI_Comm comm, const Summary& summary, bool line) {
  if (!summary.contains("friction_coefficient")) return;
  const auto real = [&](const char* name) { return summary[name].get<double>(); };
  std::string heat;
  if (summary.contains("film_temperature_max")) {
    heat = worded(std::setprecision(4), "; largest temperature of the film ", real("film_temperature_max"),
                  " K, of the flanks ", real("surface_temperature_pinion"), " K and ",
                  real("surface_temperature_wheel"), " K");
  }
  const char* watt = line ? " W/m" : " W";
  say(comm, std::setprecision(4), "friction coefficient ", real("friction_coefficient"), "; lost by sliding ",
      real("power_sliding"), watt, ", by rolling ", real("power_rolling"), watt, heat);
}

void print_result(MPI_Comm comm, const std::filesystem::path& folder, const SteadyPosition& position,
                  const Summary& summary) {
  const Summary& predicted = summary["predictions"];
  ScreenTable(summary)
      .text("stationary film of", worded(position.label, ", ", summary["nx"], " x ", summary["ny"], " nodes"))
      .add("central film", "h_central", 1e6, "um")
      .add("  towards finer grids", "h_central_extrapolated", 1e6, "um")
      .add(predicted, "  by Hamrock and Dowson", "hamrock_dowson_h_central", 1e6, "um")
      .add(predicted, "  of a line contact, by Moes", "moes_line_h_central", 1e6, "um")
      .add(predicted, "  by Nijenbanning and others", "nijenbanning_venner_moes_h_central", 1e6, "um")
      .add("smallest film", "h_min", 1e6, "um")
      .add("  towards finer grids", "h_min_extrapolated", 1e6, "um")
      .add(predicted, "  by Hamrock and Dowson", "hamrock_dowson_h_min", 1e6, "um")
      .add("  more than a from the ends", "h_min_inner", 1e6, "um")
      .add("  its place on the face", "h_min_y", 1e3, "mm")
      .add("largest pressure", "p_max", 1e-9, "GPa")
      .add("  in the centre", "p_central", 1e-9, "GPa")
      .add("  of the outlet's spike", "p_spike", 1e-9, "GPa")
      .add("largest von Mises stress, pinion", "von_mises_max_pinion", 1e-6, "MPa")
      .add("  its depth", "von_mises_depth_pinion", 1e6, "um")
      .add("  in the wheel", "von_mises_max_wheel", 1e-6, "MPa")
      .add("force", "force", 1.0, position.solids.line ? "N/m" : "N")
      .add("tilting moment", "tilting_moment", 1.0, "N m")
      .text("work", worded(summary["newton_iterations"], " Newton and ", summary["krylov_iterations"],
                           " Krylov iterations on this grid, residual ", std::setprecision(3),
                           summary["residual"].get<double>()))
      .print(comm, folder);
}

/// Says where film and heat or shear still change each other.
void warn_of_unrest(MPI_Comm comm, const SolvedContact& solved) {
  constexpr double tolerable = 1e-3;
  if (!solved.coupled || solved.coupled->change <= tolerable) return;
  warn(comm, std::setprecision(2),
       "the film did not quite settle with its heat or shear thinning: it still changes by ",
       100.0 * solved.coupled->change, " % from one turn of both to the next; raise grid.nx and grid.ny");
}

}  // namespace

void run_steady(MPI_Comm comm, const CaseInput& problem) {
  require_standing_heights(problem, "steady");
  const SteadyPosition position = steady_position(problem);
  const WideningObserver notice = widening_notice(problem.scales, 1, heated_points(problem));
  const Grid grid(comm, steady_grid(comm, problem, position, notice));  // wrong ones are said before files are removed
  const OutputDirectory directory(comm, problem.run.directory);
  directory.remove_earlier_results();
  const SteadyResult result = [&] {
    LongWork work(comm);
    return solve_steady(grid, problem, position, [&](const std::string& text) { work.report(text); });
  }();
  const Summary& summary = result.summary;
  write_results(comm, problem, result);
  print_result(comm, directory.path(), position, summary);
  note_spike(comm, summary);
  print_shear(comm, summary);
  print_heating(comm, summary);
  print_friction(comm, summary, problem.scales.solids.line);
  warn_of_errors(comm, problem, result.solved.errors);
  warn_of_heating(comm, problem, summary["predictions"]);
  warn_of_unrest(comm, result.solved);
  warn_of_validity(comm, problem, summary);
}

}  // namespace gearfilm
