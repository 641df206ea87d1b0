#include "app/sweep_chain.hpp"

#include <sstream>

#include "film/domain_margins.hpp"
#include "gearfilm/error.hpp"
#include "input/case_setup.hpp"
#include "input/case_with_parameter.hpp"
#include "orbits/orbit_chain.hpp"
#include "output/file_ownership.hpp"
#include "output/screen.hpp"
#include "output/state_file.hpp"
#include "parallel/agreement.hpp"
#include "results/flank_result.hpp"
#include "results/pair_conditions.hpp"
#include "results/poincare_result.hpp"
#include "results/rating_result.hpp"
#include "results/sweep_point.hpp"

namespace gearfilm {
namespace {

constexpr const char *own_checkpoint = ".checkpoint", *whole_face_checkpoint = ".whole_face.checkpoint";

const char* name_of(SweepDirection direction) { return direction == SweepDirection::up ? "up" : "down"; }

/// The chain with its points on disk.
class ChainRun {
public:
  ChainRun(MPI_Comm group, const CaseInput& problem, const SweepPoints& points, const StopRequest& stop)
      : group_(group),
        problem_(problem),
        points_(points),
        stop_(stop),
        case_at_(cases_of_sweep(problem)),
        chain_(problems_of_sweep(case_at_)) {}

  void run(const SweepChain& chain) {
    for (const SweepPoint& point : chain) {
      std::optional<Summary> result = points_.read(group_, point);
      if (result) {
        resume_from(point, *result);
      } else {
        result = compute(point, problem_.sweep.values[point.index]);
        points_.write(group_, point, *result);
        remove_outdated(point);
      }
      before_point_ = point;
      print_point(group_, problem_, *result);
    }
  }

private:
  /// A point on its own grid, or over the whole face.
  struct Attempt {
    SweepPoint point;
    double value = 0.0;
    CaseInput here;
    const char* checkpoint = own_checkpoint;  ///< extension of its name
  };

  /// Goes on from a point that is on disk, since a program before has computed it.
  void resume_from(const SweepPoint& point, const Summary& result) {
    if (result.contains("error")) {
      forget();
    } else {
      chain_.keep(read_link(result));
    }
    if (chain_.last()) read_films(point);
  }

  /// A point has failed. The dry pair's branch may go on beyond it, and is followed from where it was found last.
  void forget() {
    if (!problem_.dry() || problem_.sweep.marched()) chain_.forget();
  }

  void read_films(const SweepPoint& point) {
    const std::optional<StateFile> found = read_state(group_, points_.file(point, ".films"));
    if (!found) return;
    const Summary& description = found->description;
    chain_.last()->guess.neighbour = {description["motion"].get<Motion>(),
                                      films_from(found->fields, description["films"]), found->shape};
  }

  void write_films(const SweepPoint& point, const PairState& state) const {
    write_state(Grid(group_, state.shape), points_.file(point, ".films"),
                {{"motion", state.motion}, {"films", field_names(state)}}, fields_of(state));
  }

  /// What only a point that is still to be computed needs.
  void remove_outdated(const SweepPoint& done) const {
    if (rank_in(group_) != 0) return;
    for (const char* kept : {own_checkpoint, whole_face_checkpoint}) remove_all_written_here(points_.file(done, kept));
    if (before_point_) remove_if_written_here(points_.file(*before_point_, ".films"));
  }

  Checkpoint checkpoint(const Attempt& at, const SharedDiscretisation& films) const {
    return {films->grid(), points_.file(at.point, at.checkpoint), Checkpoint::Begin::where_it_stopped};
  }

  /// On its own grid; where the load comes to the ends of the face, over all of it.
  Summary compute(const SweepPoint& point, double value) {
    const Attempt own{point, value, case_at_(value)};
    try {
      return compute(own);
    } catch (const EdgesReached& error) {
      try {
        return compute({point, value, case_of_sweep(over_whole_face(problem_), value), whole_face_checkpoint});
      } catch (const InputError& refusal) {
        Summary result = begun(own, orbit_problem(own.here).mesh);
        result["error"] = worded(error.what(), "; but ", refusal.what());
        forget();
        return result;
      }
    }
  }

  /// What the record of a point begins with.
  static Summary begun(const Attempt& at, const MeshModel& mesh) {
    Summary result = {{"direction", name_of(at.point.direction)}, {"value", at.value}};
    add_conditions({at.here, mesh}, result);
    return result;
  }

  Summary compute(const Attempt& at) {
    const OrbitProblem search = orbit_problem(at.here);
    const MeshModel& mesh = search.mesh;
    Summary result = begun(at, mesh);
    try {
      if (at.here.sweep.marched()) {
        march(search, at, result);
      } else if (at.here.dry()) {
        stop_.check(group_, at.value);
        add_dry_orbit(search, chain_.find_dry(at.value, counted(stop_.check_in(group_))), result);
      } else {
        find_on_films(search, at, result);
      }
    } catch (const EdgesReached&) {
      throw;
    } catch (const SolveError& error) {
      result["error"] = error.what();
      forget();
    }
    return result;
  }

  /// Where a march begins: given, or where the one before has come to.
  std::optional<PairState> march_start(const OrbitProblem& search, const SweepPoint& point) const {
    if (problem_.sweep.kind == SweepKind::basins) return PairState{problem_.sweep.starts[point.index], {}};
    if (const std::optional<ChainLink>& last = chain_.last()) {
      const PairState& state = last->guess.neighbour.value_or(PairState{last->guess.motion, {}});
      return rescaled(state, case_of_sweep(problem_, last->value).scales, search.mesh.scales);
    }
    return search.search.start ? std::optional(PairState{*search.search.start, {}}) : std::nullopt;
  }

  void march(const OrbitProblem& search, const Attempt& at, Summary& result) {
    const std::optional<PairState> from = march_start(search, at.point);
    if (problem_.sweep.kind == SweepKind::basins) {
      result["H0"] = from->motion.H0();
      result["V0"] = from->motion.V0();
    }
    const MarchLength length{problem_.sweep.march_periods, problem_.sweep.kept_periods};
    SearchWatch watch{.check_stop = stop_.check_in(group_)};
    SettledMarch marched;
    if (problem_.dry()) {
      marched = march_dry(search, from ? std::optional(from->motion) : std::nullopt, length, watch.check_stop);
    } else {
      const SharedDiscretisation films = discretise(group_, search);
      Checkpoint kept = checkpoint(at, films);
      watch.store = &kept;
      marched = march_on_films(search, films, from, length, watch);
      write_films(at.point, marched.end);
    }
    result.update(marched_summary(marched, search.mesh.scales, !problem_.dry()));
    ChainLink link{at.value, {}, {}};
    link.guess.motion = marched.end.motion;
    if (!problem_.dry()) link.guess.neighbour = marched.end;
    chain_.keep(std::move(link));
  }

  void find_on_films(const OrbitProblem& problem, const Attempt& at, Summary& result) {
    const SharedDiscretisation films = discretise(group_, problem);
    Checkpoint kept = checkpoint(at, films);
    result["search"] = Summary::array();
    const auto list = [&](const char* name) {
      return [&result, name](const SearchPeriod& period) {
        result[name].push_back({period.defect, period.film_defect});
      };
    };
    RatingHistory ratings(problem.mesh);
    const SearchWatch watch{
        .on_step = [&](const StepRecord& record, const std::vector<ActiveContact>&) { ratings.add(record); },
        .on_period = list("search"),
        .on_coarse_period = list("coarse_search"),
        .on_trouble = [&](const std::string& trouble) { result["coarse_error"] = trouble; },
        .check_stop = stop_.check_in(group_),
        .store = &kept};
    OrbitChain::Search search;
    const auto describe_search = [&] {
      result["start"] = search.from_neighbour ? "neighbour" : "dry orbit";
      if (!search.neighbour_error.empty()) result["neighbour_error"] = search.neighbour_error;
    };
    try {
      const DescribedOrbit found = chain_.find_on_films(at.value, problem, films, watch, search);
      describe_search();
      write_films(at.point, found.orbit.end);
      add_orbit(problem.mesh, found, result);
      if (problem.mesh.rating) {
        result["safety"] = ratings.safeties(found.orbit.begin, found.orbit.begin + problem.mesh.period());
      }
      if (problem.mesh.fatigue) {
        add_flanks(problem.mesh, flank_results(problem, films, found.orbit, watch.check_stop), result);
      }
      if (const std::optional<DryOrbit>& dry = chain_.last()->dry) result["dry_motion"] = dry->start;
    } catch (const SolveError&) {
      describe_search();
      throw;
    }
  }

  MPI_Comm group_;
  const CaseInput& problem_;
  const SweepPoints& points_;
  const StopRequest& stop_;
  CaseAt case_at_;
  OrbitChain chain_;
  std::optional<SweepPoint> before_point_;
};

}  // namespace

void print_point(MPI_Comm group, const CaseInput& problem, const Summary& point) {
  std::ostringstream text;
  text << point["direction"].get<std::string>() << " " << point["value"].get<double>() << " " << problem.sweep.unit
       << ": ";
  if (point.contains("error")) {
    text << "failed: " << point["error"].get<std::string>();
  } else {
    text << "force ratio " << point["force_ratio_max"].get<double>();
    if (problem.sweep.marched()) {
      const Summary& period = point["settles_on"];
      const char* how = point["repeats_every"].is_null() ? ", settles on " : ", repeats every ";
      text << (period.is_null() ? ", does not settle" : how + period.dump() + " mesh period(s)");
    } else if (!problem.dry()) {
      text << ", smallest film " << 1e6 * point["h_min"].get<double>() << " um, " << point["periods_used"].get<int>()
           << " mesh periods";
    }
    if (point.contains("stable") && !point["stable"].get<bool>()) text << ", unstable";
    if (point["contact_lost"].get<bool>()) text << ", contact is lost";
  }
  say(group, text.str());
}

void run_chain(MPI_Comm group, const CaseInput& problem, const SweepPoints& points, const SweepChain& chain,
               const StopRequest& stop) {
  ChainRun(group, problem, points, stop).run(chain);
}

}  // namespace gearfilm
