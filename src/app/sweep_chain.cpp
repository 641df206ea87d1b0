#include "app/sweep_chain.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/case_at.hpp"
#include "app/coarse_orbit.hpp"
#include "app/dry_point.hpp"
#include "app/marched_point.hpp"
#include "app/warning.hpp"
#include "gearfilm/error.hpp"
#include "gearfilm/input/case_setup.hpp"
#include "output/file_ownership.hpp"
#include "output/state_file.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

constexpr int periods_from_neighbour = 12;  // then the dry orbit is the better start
constexpr double same_branch = 1.0;         // change of the motion from point to point; farther away is another branch
constexpr double beside = 0.3;              // between the motions of the lubricated and the dry orbit

double distance(const Motion& a, const Motion& b) { return std::hypot(a.H0() - b.H0(), a.V0() - b.V0()); }

const char* name_of(SweepDirection direction) { return direction == SweepDirection::up ? "up" : "down"; }

/// A point that was found, as the beginning of the next.
struct Neighbour {
  double value = 0.0;
  OrbitGuess guess;
  std::optional<DryOrbit> dry;  ///< the damped dry pair's orbit beside it
};

/// Row by row.
Summary monodromy_json(const Monodromy& map) {
  Summary rows = Summary::array();
  for (const auto& row : map.rowwise()) rows.push_back(std::vector<double>(row.begin(), row.end()));
  return rows;
}

Monodromy read_monodromy(const Summary& rows) {
  const auto size = static_cast<Eigen::Index>(rows.size());
  Monodromy map(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) map(i, j) = rows[i][j].get<double>();
  }
  return map;
}

/// The same from a point on disk, but for its films.
Neighbour read_neighbour(const Summary& point) {
  Neighbour neighbour{point["value"].get<double>(), {}, {}};
  neighbour.guess.motion = {point["H0_after_leaving"].get<double>(), point["V0_after_leaving"].get<double>()};
  if (!point.contains("monodromy")) return neighbour;  // of a march
  neighbour.guess.monodromy = read_monodromy(point["monodromy"]);
  if (point.contains("dry_motion")) neighbour.dry.emplace().start = point["dry_motion"].get<Motion>();
  return neighbour;
}

class ChainRun {
public:
  ChainRun(MPI_Comm group, const Case& problem, const SweepPoints& points, const StopRequest& stop)
      : group_(group), problem_(problem), points_(points), stop_(stop) {}

  void run(const SweepChain& chain) {
    last_.reset();
    before_.reset();
    before_point_.reset();
    for (const SweepPoint& point : chain) {
      const double value = problem_.sweep.values[point.index];
      std::optional<Summary> result = points_.read(group_, point);
      if (result) {
        if (result->contains("error")) {
          forget();
        } else {
          keep(read_neighbour(*result));
        }
        if (last_) read_films(point);
      } else {
        result = compute(point, value);
        points_.write(group_, point, *result);
        remove_outdated(point);
      }
      before_point_ = point;
      print_point(group_, problem_, *result);
    }
  }

private:
  /// What a point is computed with.
  struct Point {
    const Case& problem;
    const MeshModel& mesh;
    const SharedDiscretisation& films;
    double value;  ///< of the parameter of the sweep
  };

  void keep(std::optional<Neighbour> found) {
    if (found && found->dry) film_shift_ = found->guess.motion.H0() - found->dry->start.H0();
    before_ = found ? std::move(last_) : std::nullopt;
    last_ = std::move(found);
  }

  /// A point has failed. The dry pair's branch may go on beyond it, and is followed from where it was found last.
  void forget() {
    if (!problem_.dry() || problem_.sweep.marched()) keep({});
  }

  void read_films(const SweepPoint& point) {
    const std::optional<StateFile> found = read_state(group_, points_.file(point, ".films"));
    if (!found) return;
    const Summary& description = found->description;
    last_->guess.neighbour = {description["motion"].get<Motion>(), films_from(found->fields, description["films"]),
                              found->shape};
  }

  void write_films(const SweepPoint& point, const PairState& state) const {
    write_state(Grid(group_, state.shape), points_.file(point, ".films"),
                {{"motion", state.motion}, {"films", field_names(state)}}, fields_of(state));
  }

  /// What only a point that is still to be computed needs.
  void remove_outdated(const SweepPoint& done) const {
    if (rank_in(group_) != 0) return;
    remove_all_written_here(points_.file(done, ".checkpoint"));
    if (before_point_) remove_if_written_here(points_.file(*before_point_, ".films"));
  }

  Case case_of(double value) const {
    if (problem_.sweep.kind == SweepKind::basins) return problem_;
    return case_at(problem_, problem_.sweep.parameter, value);
  }

  Summary compute(const SweepPoint& point, double value) {
    const Case here = case_of(value);
    Summary result = {{"direction", name_of(point.direction)}, {"value", value}};
    result["speed_rpm"] = here.parameters.real("pinion.speed_rpm");
    result["torque"] = here.pair.torque;
    result["m_ge"] = *here.pair.equivalent_mass;
    const MeshModel mesh = mesh_after_leaving(here);
    result["I_n"] = mesh.inertia;
    result["f_m"] = mesh.mesh_frequency_si();
    result["f_n"] = mesh.frequency_si();
    try {
      if (here.sweep.marched()) {
        march(here, mesh, value, point, result);
      } else if (here.dry()) {
        find_dry(here, mesh, value, result);
      } else {
        find_lubricated(here, mesh, value, point, result);
      }
    } catch (const SolveError& error) {
      result["error"] = error.what();
      forget();
    }
    return result;
  }

  void march(const Case& here, const MeshModel& mesh, double value, const SweepPoint& point, Summary& result) {
    std::optional<PairState> from;
    if (here.sweep.kind == SweepKind::basins) {
      const Motion& start = here.sweep.starts[point.index];
      result["H0"] = start.H0();
      result["V0"] = start.V0();
      from = PairState{start, {}};
    } else if (last_) {
      const PairState& state = last_->guess.neighbour.value_or(PairState{last_->guess.motion, {}});
      from = rescaled(state, case_of(last_->value).scales, here.scales);
    } else if (here.march.start_motion) {
      from = PairState{*here.march.start_motion, {}};
    }
    SharedDiscretisation films;
    std::optional<Checkpoint> checkpoint;
    if (!here.dry()) {
      films = discretise(group_, here);
      checkpoint.emplace(films->grid(), points_.file(point, ".checkpoint"), Checkpoint::Begin::where_it_stopped);
    }
    const auto watch = [&](double T, bool is_new) {
      if (is_new) stop_.check(group_, mesh.path.mesh_periods(T));
    };
    const MarchedPoint marched = march_point(here, mesh, films, from, checkpoint ? &*checkpoint : nullptr, watch);
    result.update(marched_summary(here, marched));
    OrbitGuess end;
    end.motion = marched.end.motion;
    if (!marched.end.films.empty()) {
      write_films(point, marched.end);
      end.neighbour = marched.end;
    }
    keep(Neighbour{value, end, {}});
  }

  void find_dry(const Case& here, const MeshModel& mesh, double value, Summary& result) {
    stop_.check(group_, value);
    const auto neighbour = last_ ? std::optional(BranchState{last_->guess.motion, last_->value}) : std::nullopt;
    const DryPointFound found = find_dry_point(problem_, value, neighbour, stopping(group_, stop_));
    add_dry_orbit(here, mesh, found, result);
    keep(Neighbour{value, {found.orbit.start, found.orbit.monodromy, {}}, {}});
  }

  void find_lubricated(const Case& here, const MeshModel& mesh, double value, const SweepPoint& point,
                       Summary& result) {
    const SharedDiscretisation films = discretise(group_, here);
    Checkpoint checkpoint(films->grid(), points_.file(point, ".checkpoint"), Checkpoint::Begin::where_it_stopped);
    std::optional<DryOrbit> dry;
    const OrbitRun run = search({here, mesh, films, value}, checkpoint, dry, result);
    write_films(point, run.orbit.end);
    result.update(orbit_summary(mesh, run));
    result["monodromy"] = monodromy_json(run.orbit.monodromy);
    if (!dry) dry = dry_beside(mesh, run.orbit.start.motion);
    if (dry) result["dry_motion"] = dry->start;
    keep(Neighbour{value, {run.orbit.start.motion, run.orbit.monodromy, run.orbit.end}, dry});
  }

  /// The dry orbit next to a lubricated one, if there is any.
  std::optional<DryOrbit> dry_beside(const MeshModel& mesh, const Motion& motion) const {
    const Motion near{motion.H0() - film_shift_, motion.V0()};
    std::optional<DryOrbit> dry = follow_dry_orbit(mesh, typical_film_damping, near);
    if (dry && distance(dry->start, near) > beside) dry.reset();
    return dry;
  }

  /// From the neighbour, and where that fails from the dry orbit. Leaves the dry orbit beside the one found.
  OrbitRun search(const Point& at, Checkpoint& checkpoint, std::optional<DryOrbit>& dry, Summary& result) const {
    result["search"] = Summary::array();
    const auto list = [&](const char* name) {
      return [&result, name](const SearchPeriod& period) {
        result[name].push_back({period.defect, period.film_defect});
      };
    };
    const OrbitObservers observers{.on_period = list("search"),
                                   .on_coarse_period = list("coarse_search"),
                                   .on_trouble = [&](const std::string& trouble) { result["coarse_error"] = trouble; },
                                   .checkpoint = checkpoint,
                                   .stop = stop_};
    if (last_) {
      result["start"] = "neighbour";
      Case brief = at.problem;
      brief.search.options.max_periods = std::min(brief.search.options.max_periods, periods_from_neighbour);
      try {
        return find_orbit_near(brief, at.films, at.mesh, from_neighbour(at, dry), observers);
      } catch (const SolveError& error) {
        result["neighbour_error"] = error.what();
      }
    }
    result["start"] = "dry orbit";
    dry = dry_start(at.mesh);
    return find_orbit(at.problem, at.films, at.mesh, *dry, observers).run;
  }

  /// The neighbour moved as the dry pair's orbit moves from there to here, with its Jacobian; where the dry orbit
  /// cannot be followed, extrapolated from the last two points.
  OrbitGuess from_neighbour(const Point& at, std::optional<DryOrbit>& dry) const {
    OrbitGuess guess = last_->guess;
    if (last_->dry) {
      const Motion before = last_->dry->start;
      dry = follow_dry_orbit(at.mesh, typical_film_damping, before);
      if (dry && distance(dry->start, before) < same_branch) {
        guess.motion.H0() += dry->start.H0() - before.H0();
        guess.motion.V0() += dry->start.V0() - before.V0();
        guess.monodromy = dry->monodromy;
        return guess;
      }
      dry.reset();
    }
    guess.motion = extrapolated(at.value);
    return guess;
  }

  /// The motion of the last point, and how it changed from the one before.
  Motion extrapolated(double value) const {
    const Motion& last = last_->guess.motion;
    if (!before_) return last;
    const double part = (value - last_->value) / (last_->value - before_->value);
    const Motion before = before_->guess.motion;
    const Motion step{part * (last.H0() - before.H0()), part * (last.V0() - before.V0())};
    if (distance(step, {}) >= beside) return last;
    return {last.H0() + step.H0(), last.V0() + step.V0()};
  }

  MPI_Comm group_;
  const Case& problem_;
  const SweepPoints& points_;
  const StopRequest& stop_;
  std::optional<SweepPoint> before_point_;
  std::optional<Neighbour> last_, before_;
  double film_shift_ = 0.0;  ///< H_0 of the last lubricated orbit less that of the dry one beside it
};

}  // namespace

void add_dry_orbit(const Case& here, const MeshModel& mesh, const DryPointFound& found, Summary& result) {
  const OrbitRun run = describe_dry_orbit(here, mesh, found.orbit, unseen);
  result["start"] = found.start;
  result.update(orbit_summary(mesh, run));
  result["monodromy"] = monodromy_json(run.orbit.monodromy);
}

void print_point(MPI_Comm group, const Case& problem, const Summary& point) {
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

void run_chain(MPI_Comm group, const Case& problem, const SweepPoints& points, const SweepChain& chain,
               const StopRequest& stop) {
  ChainRun(group, problem, points, stop).run(chain);
}

}  // namespace gearfilm
