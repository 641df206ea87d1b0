// `gearfilm wear`: flanks that wear over many revolutions of the pinion, with the profiles that wear makes of them.
#include <algorithm>
#include <iomanip>

#include "app/commands.hpp"
#include "app/result_warnings.hpp"
#include "dynamics/worn_flanks.hpp"
#include "gearfilm/error.hpp"
#include "input/case_setup.hpp"
#include "orbits/orbit_chain.hpp"
#include "output/results_file.hpp"
#include "output/run_identity.hpp"
#include "output/screen.hpp"
#include "output/screen_table.hpp"
#include "output/sweep_points.hpp"
#include "parallel/agreement.hpp"
#include "results/sweep_point.hpp"
#include "results/wear_result.hpp"

namespace gearfilm {
namespace {

constexpr int places_across = 41;

void check_wear(const CaseInput& problem) {
  if (!problem.wear)
    throw InputError("the case '" + problem.name +
                     "' has nothing that wears; give wear.coefficient_pinion or wear.coefficient_wheel");
  if (problem.dry()) problem.parameters.refuse("model", "is dry, but asperities wear beside films; set it to dynamic");
  require_moving_train(problem, "wear");
  if (!problem.wearing.cycles) throw InputError("'wear.cycles' is missing; give the revolutions of the pinion");
}

class Wearing {
public:
  Wearing(MPI_Comm comm, const CaseInput& problem)
      : comm_(comm),
        problem_(problem),
        points_(comm, problem, "wear"),
        stop_(problem.run.time_limit),
        mesh_(mesh_after_leaving(problem)),
        worn_(worn_pair()) {}

  void run() {
    for (std::size_t n = 0; worn_.revolutions() < *problem_.wearing.cycles; ++n) {
      const SweepPoint point{SweepDirection::up, n};
      std::optional<Summary> step = points_.read(comm_, point);
      if (!step) {
        step = compute();
        points_.write(comm_, point, *step);
      }
      print(*step);
      worn_.wear(read_period_wear(*step), (*step)["step_revolutions"].get<double>());
      for (const char* name : {"lost_pinion", "lost_wheel"}) step->erase(name);
      steps_.push_back(std::move(*step));
    }
    finish();
  }

private:
  FlankWear recorder(const MeshModel& mesh) const {
    return {mesh, problem_.pair.gears->face_width, problem_.wearing.points, places_across};
  }

  WornPair worn_pair() const {
    const FlankWear flanks = recorder(mesh_);
    std::optional<RunningIn> running_in;
    if (problem_.wearing.final_roughness)
      running_in = RunningIn{*problem_.wearing.final_roughness, *problem_.wearing.running_in_work};
    return {{flanks.places(0), flanks.places(1)},
            problem_.pair.line->speed_ratio(),
            problem_.scales.solids.rough->sigma(),
            running_in};
  }

  WornFlank worn_flank(std::size_t gear, double base_radius) const {
    const FlankPlaces& places = worn_.places(gear);
    WornFlank flank;
    for (int j = 0; j < places.across; ++j) {
      flank.y.push_back(places.y(j));
      flank.removed.push_back(worn_.profile(gear, base_radius, j));
    }
    return flank;
  }

  CaseInput present_case() const {
    WornFlanks worn{.flanks = {}, .roughness_ratio = worn_.roughness() / problem_.scales.solids.rough->sigma()};
    if (worn_.revolutions() > 0.0) {
      worn.flanks = {worn_flank(0, problem_.pair.line->base_radius_pinion()),
                     worn_flank(1, problem_.pair.line->base_radius_wheel())};
    }
    CaseInput here = make_case_like(problem_, problem_.parameters, worn);
    here.search.with_multipliers = false;
    return here;
  }

  /// Depth that a flank may lose until its profile is that of the step's end.
  double depth_of_step() const {
    constexpr double part_of_approach = 0.05;
    return std::min(problem_.wearing.largest_step * worn_.roughness(),
                    part_of_approach * problem_.scales.approach * problem_.scales.thickness);
  }

  /// Each from the dry pair's orbit, so that a run that goes on finds the same.
  Summary compute() {
    const CaseInput here = present_case();
    const OrbitProblem search = orbit_problem(here);
    const SharedDiscretisation films = discretise(comm_, search);
    FlankWear flanks = recorder(search.mesh);
    PeriodWear period;
    const SearchWatch watch{
        .on_step = [&](const StepRecord& record,
                       const std::vector<ActiveContact>& contacts) { flanks.add(record, contacts); },
        .on_period = [&](const SearchPeriod&) { period.volumes = flanks.take(comm_); },
        .on_coarse_period = [](const SearchPeriod&) {},
        .check_stop = stop_.check_in(comm_)};
    OrbitChain chain([&](double) { return OrbitProblem(search); });
    OrbitChain::Search how;
    Summary step = {{"direction", "up"}, {"value", worn_.revolutions()}};
    step.update(worn_summary(worn_));
    add_orbit(search.mesh, chain.find_on_films(worn_.revolutions(), search, films, watch, how), step);
    period.work = asperity_work(period);
    const double left = *problem_.wearing.cycles - worn_.revolutions();
    step.update(period_wear_summary(period, std::min(left, worn_.revolutions_to(period, depth_of_step()))));
    return step;
  }

  /// Friction work of the asperities in a mesh period [J]: mu_b times the volume that a flank loses over its
  /// coefficient of wear, which is the integral of their pressure times sliding.
  double asperity_work(const PeriodWear& period) const {
    const std::array<double, 2> coefficients = {problem_.wear->pinion, problem_.wear->wheel};
    for (std::size_t gear = 0; gear < coefficients.size(); ++gear) {
      if (!(coefficients[gear] > 0.0)) continue;
      double volume = 0.0;
      for (const double lost : period.volumes[gear]) volume += lost;
      return problem_.traction ? problem_.traction->boundary_coefficient * volume / coefficients[gear] : 0.0;
    }
    return 0.0;
  }

  void print(const Summary& step) const {
    say(comm_, std::setprecision(4), step["revolutions"].get<double>(), " revolutions: depth of pinion ",
        1e6 * step["worn_depth_pinion"].get<double>(), " um, of wheel ", 1e6 * step["worn_depth_wheel"].get<double>(),
        " um, part on asperities ", step["asperity_load_share_mean"].get<double>());
  }

  void finish() {
    ResultsFile file(comm_, problem_.run.directory / "results.h5");
    write_identity(file, problem_, "wear");
    write_wear(file, steps_, worn_,
               {problem_.pair.line->base_radius_pinion(), problem_.pair.line->base_radius_wheel()});
    file.finish();
    Summary summary = {{"case", problem_.name}};
    summary.update(worn_summary(worn_));
    summary["steps"] = steps_;
    write_summary(comm_, problem_.run.directory, summary);
    points_.complete(comm_);
    ScreenTable(summary)
        .add("depth of the pinion's flanks", "worn_depth_pinion", 1e6, "um")
        .add("depth of the wheel's flanks", "worn_depth_wheel", 1e6, "um")
        .add("volume of a tooth of the pinion", "worn_volume_pinion", 1e9, "mm^3")
        .add("volume of a tooth of the wheel", "worn_volume_wheel", 1e9, "mm^3")
        .add("roughness of both flanks", "roughness", 1e6, "um")
        .print(comm_, problem_.run.directory);
  }

  MPI_Comm comm_;
  const CaseInput& problem_;
  SweepPoints points_;
  StopRequest stop_;
  MeshModel mesh_;
  WornPair worn_;
  Summary steps_ = Summary::array();
};

}  // namespace

void run_wear(MPI_Comm comm, const CaseInput& given) {
  check_wear(given);
  std::string remark;
  CaseInput problem = periodic_case(given, remark);
  if (!remark.empty()) say(comm, remark);
  const OutputDirectory directory(comm, problem.run.directory);
  Wearing wearing(comm, problem);
  directory.remove_earlier_results();
  wearing.run();
}

}  // namespace gearfilm
