#include "film/linearised_film.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include "film/multigrid_level.hpp"

namespace gearfilm {
namespace {

/// How to coarsen a level, if at all. Where long cells keep their rows they are not coarsened once that ends along X.
/// Where rows are relaxed whole, they leave nothing to a coarser level.
std::optional<Coarsening> coarsening_of(const Grid& grid, bool keep_rows, int fewest_nodes, double longest_step) {
  if (grid.keeps_rows()) return {};
  const auto serves = [&](int nodes) { return (nodes - 1) / 2 + 1 >= fewest_nodes; };
  const bool in_x = grid.can_coarsen(Coarsening::x_only) && serves(grid.nx()) && 2.0 * grid.h_x() <= longest_step;
  const bool in_y = !(keep_rows && needs_all_rows(grid)) && grid.can_coarsen(Coarsening::y_only) && serves(grid.ny());
  if (in_x && in_y) return Coarsening::both;
  if (in_x) return Coarsening::x_only;
  if (in_y) return Coarsening::y_only;
  return {};
}

template <class Real>
class FilmMultigrid final : public LinearisedFilm {
public:
  FilmMultigrid(Discretisation& finest, const MultigridOptions& options, double longest_step)
      : options_(options), longest_step_(longest_step) {
    build_levels(finest);
    build_cycle();
  }

  void update(const FilmState& state, double shift, SmootherFactors factors) override {
    update_from(0, state, shift, factors);
  }

  void apply(std::span<const double> residual, std::span<double> change) override {
    petsc_check(VecPlaceArray(right_side_, residual.data()));
    petsc_check(VecPlaceArray(solution_, change.data()));
    petsc_check(PCApply(cycle_, right_side_, solution_));
    petsc_check(VecResetArray(right_side_));
    petsc_check(VecResetArray(solution_));
  }

  bool relax_displacement(std::span<const double> column, std::span<double> change) override {
    return levels() == 1 && levels_.front()->relax_displacement(column, change);
  }

  void relax(std::span<const double> residual, std::span<double> change) override {
    levels_.front()->smooth(residual, change, 1, true);
  }

  bool multiply_together(std::span<const Product> products) override {
    std::vector<typename Level::Product> own;
    for (const Product& product : products) {
      auto* film = dynamic_cast<FilmMultigrid*>(product.film);
      if (!film || &film->finest().discretisation() != &finest().discretisation()) return false;
      own.push_back({&film->finest(), product.change, product.rows});
    }
    Level::multiply_together(own);
    return true;
  }
  void displacement_column(std::span<double> column) override { levels_.front()->displacement_column(column); }

  void project_change(std::span<const double> pressure, std::span<const float> weights,
                      std::span<double> change) override {
    levels_.front()->project_change(pressure, weights, change);
  }

  int levels() const override { return static_cast<int>(levels_.size()) + (whole_ ? whole_->levels() - 1 : 0); }

private:
  using Level = MultigridLevel<Real>;

  /// A level, and the finer one of which it takes residuals and to which it gives corrections, as PETSc's shells see
  /// it.
  struct Shell {
    Level* level;
    Level* finer;  ///< null on the finest

    PetscInt size() const { return level->grid().local_size(); }
    void multiply(Vec in, Vec out) { level->multiply(VecReading(in).values(), VecWriting(out).values()); }
    void smooth(Vec in, Vec out, int sweeps, bool zero_guess) {
      level->smooth(VecReading(in).values(), VecWriting(out).values(), sweeps, zero_guess);
    }
    void relax(Vec in, Vec out) { smooth(in, out, 1, true); }
    void restrict_residual(Vec in, Vec out) {
      level->restrict_from(*finer, VecReading(in).values(), VecWriting(out).values());
    }
    void add_interpolated(Vec in, Vec out) {
      level->interpolate_to(*finer, VecReading(in).values(), VecWriting(out).values());
    }
    void interpolate(Vec in, Vec out) {
      petsc_check(VecSet(out, 0.0));
      add_interpolated(in, out);
    }
  };

  Level& finest() const { return *levels_.front(); }
  std::optional<Coarsening> next_coarsening(const Grid& coarsest) const;
  void build_levels(Discretisation& finest);
  void build_whole_rest(Discretisation& last);
  void build_cycle();
  void configure_smoother(KSP ksp, Mat matrix, Shell& shell, int sweeps);
  void configure_gathered(KSP ksp, Mat matrix);
  void apply_gathered(Vec in, Vec out);
  /// This level and all coarser ones, which see the state injected.
  void update_from(std::size_t level, const FilmState& state, double shift, SmootherFactors factors);
  void update_gathered(const FilmState& state, double shift, SmootherFactors factors);
  OwnedMat interpolation(Shell& shell) const;

  MultigridOptions options_;
  double longest_step_;
  std::vector<std::unique_ptr<Level>> levels_;  ///< finest first
  std::vector<std::unique_ptr<Shell>> shells_;  ///< one a level
  std::vector<OwnedMat> matrices_;
  OwnedPC cycle_;
  OwnedVec right_side_, solution_;  ///< wrap the caller's arrays
  // The rest of the hierarchy, whole on every process; null where the cut grids go down to the coarsest.
  const Gather* gather_ = nullptr;
  std::unique_ptr<LinearisedFilm> whole_;
  std::vector<double> whole_residual_, whole_change_;
};

/// Of the coarsest level so far; nothing where there are enough.
template <class Real>
std::optional<Coarsening> FilmMultigrid<Real>::next_coarsening(const Grid& coarsest) const {
  constexpr int fewest_nodes = 33, fewest_if_asked = 3;
  if (options_.levels == 0) return coarsening_of(coarsest, options_.keep_rows, fewest_nodes, longest_step_);
  if (static_cast<int>(levels_.size()) >= options_.levels) return {};
  return coarsening_of(coarsest, options_.keep_rows, fewest_if_asked, HUGE_VAL);
}

template <class Real>
void FilmMultigrid<Real>::build_levels(Discretisation& finest) {
  levels_.push_back(std::make_unique<Level>(finest));
  Discretisation* last = &finest;
  while (const auto along = next_coarsening(last->grid())) {
    Discretisation* next = last->prepare_coarser(*along);
    if (!next) {
      build_whole_rest(*last);
      return;
    }
    last = next;
    levels_.push_back(std::make_unique<Level>(*last));
  }
}

/// All coarser levels, whole on every process: the cut grid has too few rows.
template <class Real>
void FilmMultigrid<Real>::build_whole_rest(Discretisation& last) {
  Discretisation* whole = last.prepare_replicated();
  gather_ = &last.prepare_gather();
  MultigridOptions rest = options_;
  if (rest.levels > 0) rest.levels -= static_cast<int>(levels_.size()) - 1;
  whole_ = std::make_unique<FilmMultigrid<Real>>(*whole, rest, longest_step_);
  whole_residual_.resize(whole->grid().local_size());
  whole_change_.resize(whole->grid().local_size());
}

// PETSc's convention: a transfer matrix is fine by coarse for interpolation, coarse by fine for restriction.
template <class Real>
OwnedMat FilmMultigrid<Real>::interpolation(Shell& shell) const {
  OwnedMat matrix = shell_matrix<&Shell::interpolate>(shell.level->grid().comm(), shell.finer->grid().local_size(),
                                                      shell.size(), shell);
  const auto add = +[](Mat mat, Vec in, Vec before, Vec out) -> PetscErrorCode {
    return petsc_callback([&] {
      if (before != out) petsc_check(VecCopy(before, out));
      context_of<Shell>(mat).add_interpolated(in, out);
    });
  };
  petsc_check(MatShellSetOperation(matrix, MATOP_MULT_ADD, reinterpret_cast<void (*)()>(add)));
  return matrix;
}

template <class Real>
void FilmMultigrid<Real>::configure_smoother(KSP ksp, Mat matrix, Shell& shell, int sweeps) {
  petsc_check(KSPSetType(ksp, KSPRICHARDSON));
  petsc_check(KSPSetNormType(ksp, KSP_NORM_NONE));
  petsc_check(KSPSetTolerances(ksp, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, sweeps));
  petsc_check(KSPSetOperators(ksp, matrix, matrix));
  PC pc = use_shell_preconditioner<&Shell::relax>(ksp, "distributive line relaxation", shell);
  petsc_check(PCShellSetApplyRichardson(
      pc,
      [](PC shell_pc, Vec in, Vec out, Vec, PetscReal, PetscReal, PetscReal, PetscInt its, PetscBool zero_guess,
         PetscInt* done, PCRichardsonConvergedReason* reason) -> PetscErrorCode {
        return petsc_callback([&] {
          // PCMG says that no guess is zero, but has just cleared it before the first sweep.
          PetscReal norm = 0.0;
          PetscBool known = PETSC_FALSE;
          petsc_check(VecNormAvailable(out, NORM_2, &known, &norm));
          const bool zero = zero_guess == PETSC_TRUE || (known == PETSC_TRUE && norm == 0.0);
          context_of<Shell>(shell_pc).smooth(in, out, its, zero);
          *done = its;
          *reason = PCRICHARDSON_CONVERGED_ITS;
        });
      }));
}

template <class Real>
void FilmMultigrid<Real>::configure_gathered(KSP ksp, Mat matrix) {
  petsc_check(KSPSetType(ksp, KSPPREONLY));
  petsc_check(KSPSetOperators(ksp, matrix, matrix));
  use_shell_preconditioner<&FilmMultigrid::apply_gathered>(ksp, "coarse levels whole on every process", *this);
}

template <class Real>
void FilmMultigrid<Real>::apply_gathered(Vec in, Vec out) {
  gather_->to_all(VecReading(in).values(), whole_residual_);
  whole_->apply(whole_residual_, whole_change_);
  gather_->own_part(whole_change_, VecWriting(out).values());
}

template <class Real>
void FilmMultigrid<Real>::build_cycle() {
  const int count = static_cast<int>(levels_.size());
  const Grid& grid = levels_.front()->grid();
  petsc_check(PCCreate(grid.comm(), cycle_.put()));
  petsc_check(PCSetType(cycle_, PCMG));
  petsc_check(PCMGSetLevels(cycle_, count, nullptr));
  petsc_check(PCMGSetType(cycle_, PC_MG_MULTIPLICATIVE));
  petsc_check(PCMGSetCycleType(cycle_, PC_MG_CYCLE_V));
  for (int l = 0; l < count; ++l) {
    shells_.push_back(std::make_unique<Shell>(Shell{levels_[l].get(), l > 0 ? levels_[l - 1].get() : nullptr}));
  }
  // PCMG numbers its levels from the coarsest.
  for (int l = 0; l < count; ++l) {
    const int petsc_level = count - 1 - l;
    Shell& shell = *shells_[l];
    matrices_.push_back(shell_matrix<&Shell::multiply>(grid.comm(), shell.size(), shell.size(), shell));
    Mat matrix = matrices_.back();
    if (l == 0) petsc_check(PCSetOperators(cycle_, matrix, matrix));
    if (petsc_level == 0) {
      KSP coarse = nullptr;
      petsc_check(PCMGGetCoarseSolve(cycle_, &coarse));
      if (whole_) {
        configure_gathered(coarse, matrix);
      } else {
        const bool once = options_.levels == 1 || grid.keeps_rows();
        configure_smoother(coarse, matrix, shell, once ? options_.smoothing_sweeps : options_.coarse_sweeps);
      }
    } else {
      KSP smoother = nullptr;
      petsc_check(PCMGGetSmoother(cycle_, petsc_level, &smoother));
      configure_smoother(smoother, matrix, shell, options_.smoothing_sweeps);
    }
    if (l > 0) {
      const int finer = petsc_level + 1;
      matrices_.push_back(interpolation(shell));
      petsc_check(PCMGSetInterpolation(cycle_, finer, matrices_.back()));
      matrices_.push_back(
          shell_matrix<&Shell::restrict_residual>(grid.comm(), shell.size(), shells_[l - 1]->size(), shell));
      petsc_check(PCMGSetRestriction(cycle_, finer, matrices_.back()));
    }
  }
  petsc_check(VecCreateMPIWithArray(grid.comm(), 1, grid.local_size(), PETSC_DETERMINE, nullptr, right_side_.put()));
  petsc_check(VecCreateMPIWithArray(grid.comm(), 1, grid.local_size(), PETSC_DETERMINE, nullptr, solution_.put()));
  petsc_check(PCSetUp(cycle_));
}

template <class Real>
void FilmMultigrid<Real>::update_from(std::size_t level, const FilmState& state, double shift,
                                      SmootherFactors factors) {
  levels_[level]->update(state, shift, factors);
  if (level + 1 < levels_.size()) {
    const Discretisation& coarser = levels_[level + 1]->discretisation();
    update_from(level + 1, injected_state(levels_[level]->grid(), coarser.grid(), coarser.halo(), state), shift,
                factors);
  } else if (whole_) {
    update_gathered(state, shift, factors);
  }
}

template <class Real>
void FilmMultigrid<Real>::update_gathered(const FilmState& state, double shift, SmootherFactors factors) {
  const Discretisation& everywhere = *levels_.back()->discretisation().replicated();
  FilmState whole_state(everywhere.grid());
  std::vector<double> own(levels_.back()->grid().local_size());
  std::vector<double> whole(whole_change_.size());
  const auto gather = [&](const Field<double>& from, Field<double>& to) {
    from.store(own);
    gather_->to_all(own, whole);
    to.load(whole);
  };
  whole_state.of_rates = state.of_rates;
  for (const auto field : state_fields) gather(state.*field, whole_state.*field);
  if (state.across) gather(*state.across, whole_state.across.emplace(everywhere.grid()));
  if (state.rough) {
    RoughGap& gap = whole_state.rough.emplace(everywhere.grid());
    for (const auto field : rough_gap_fields) gather((*state.rough).*field, gap.*field);
  }
  exchange_ghosts(everywhere.halo(), whole_state);
  whole_->update(whole_state, shift, factors);
}

}  // namespace

std::unique_ptr<LinearisedFilm> make_linearised_film(Discretisation& discretisation, const MultigridOptions& options,
                                                     double longest_step) {
  if (options.precision == Precision::single_precision) {
    return std::make_unique<FilmMultigrid<float>>(discretisation, options, longest_step);
  }
  return std::make_unique<FilmMultigrid<double>>(discretisation, options, longest_step);
}

}  // namespace gearfilm
