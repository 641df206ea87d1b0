#include "output/checkpoint.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "gearfilm/error.hpp"
#include "grid/remap.hpp"
#include "output/file_ownership.hpp"
#include "output/rank_file.hpp"
#include "output/state_file.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

constexpr std::size_t states_kept = 2;
// A run done again on another number of processes begins with the same motion within the solvers' tolerance.
constexpr double same_begin = 1e-6;

/// Both: T and the motion.
bool same_run_begin(const Summary& kept, const Summary& now) {
  const auto motion = [](const Summary& begin) { return begin[1].get<Motion>(); };
  return std::abs(kept[0].get<double>() - now[0].get<double>()) < same_begin &&
         length(difference(motion(kept), motion(now))) < same_begin;
}

/// What the step log has of a contact, in its order.
Summary quantity_names() {
  Summary names = Summary::array();
  for (const auto& quantity : contact_quantities) names.push_back(std::string(quantity.name));
  return names;
}

Summary description_of(const FilmSnapshot& snapshot) {
  Summary contacts = Summary::array();
  for (const ContactSnapshot& contact : snapshot.contacts) {
    Summary names = Summary::array();
    for (const auto& [name, field] : contact.fields) names.push_back(name);
    contacts.push_back({contact.number, contact.position, names});
  }
  return {{"T", snapshot.T}, {"contacts", contacts}, {"of_sections", snapshot.of_sections}};
}

void append_fields(const Grid& grid, const FilmSnapshot& snapshot, CompactFields& fields) {
  for (const ContactSnapshot& contact : snapshot.contacts) {
    for (const auto& [name, field] : contact.fields) {
      fields.emplace_back(static_cast<std::size_t>(grid.local_size()));
      field.store(fields.back());
    }
  }
}

/// The snapshots of a state; their fields come behind those of the films.
void read_snapshots(const Grid& grid, const Summary& description, const CompactFields& fields,
                    std::deque<FilmSnapshot>& snapshots, std::deque<FilmSnapshot>& sections) {
  std::size_t next = 0;
  for (const Summary& names : description["films"]) next += names.size();
  for (const Summary& entry : description["snapshots"]) {
    FilmSnapshot snapshot{entry["T"].get<double>(), {}, grid.shape()};
    for (const Summary& contact : entry["contacts"]) {
      snapshot.contacts.push_back({contact[0].get<int>(), contact[1].get<double>(), {}});
      for (const Summary& name : contact[2]) {
        Field<double> field(grid);
        field.load(fields.at(next++));
        snapshot.contacts.back().fields.push_back({name.get<std::string>(), std::move(field)});
      }
    }
    snapshot.of_sections = entry.value("of_sections", false);
    (snapshot.of_sections ? sections : snapshots).push_back(std::move(snapshot));
  }
}

/// Values that all processes have, in as many fields as hold them, node by node.
void append_sums(const Grid& grid, const std::vector<double>& sums, CompactFields& fields) {
  const auto rows = static_cast<std::size_t>(grid.rows()), first = static_cast<std::size_t>(grid.y_begin());
  const std::size_t nodes = static_cast<std::size_t>(grid.nx()) * rows;
  for (std::size_t begin = 0; begin < sums.size(); begin += nodes) {
    std::vector<double>& field = fields.emplace_back();
    for (std::size_t i = 0; i < static_cast<std::size_t>(grid.nx()); ++i) {
      for (std::size_t j = 0; j < static_cast<std::size_t>(grid.y_count()); ++j) {
        const std::size_t n = begin + i * rows + first + j;
        field.push_back(n < sums.size() ? sums[n] : 0.0);
      }
    }
  }
}

/// Back from the last fields of a state.
std::vector<double> read_sums(const Grid& grid, std::size_t size, const CompactFields& fields) {
  const auto rows = static_cast<std::size_t>(grid.rows()), count = static_cast<std::size_t>(grid.y_count());
  const std::size_t nodes = static_cast<std::size_t>(grid.nx()) * rows, used = (size + nodes - 1) / nodes;
  std::vector<double> sums(used * nodes, 0.0);
  for (std::size_t k = 0; k < used; ++k) {
    const std::vector<double>& field = fields.at(fields.size() - used + k);
    for (std::size_t n = 0; n < field.size(); ++n) {
      sums[k * nodes + n / count * rows + static_cast<std::size_t>(grid.y_begin()) + n % count] = field[n];
    }
  }
  // Zeros but on one process.
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM, grid.comm());
  sums.resize(size);
  return sums;
}

}  // namespace

Checkpoint::Checkpoint(const Grid& grid, std::filesystem::path folder, Begin begin)
    : grid_(grid), folder_(std::move(folder)), begin_(begin), log_(grid.comm(), folder_ / "steps") {
  if (begin == Begin::anew) require_removable(grid_.comm(), folder_);
  write_together(grid_.comm(), folder_, [&] {
    if (grid_.rank() != 0) return;
    if (begin == Begin::anew) remove_all_written_here(folder_);
    std::filesystem::create_directories(folder_);
  });
  if (begin == Begin::where_it_stopped) find_states();
}

std::filesystem::path Checkpoint::file(const KeptState& state) const {
  char name[48];
  std::snprintf(name, sizeof name, "run%03d_%05d.state", state.run, state.number);
  return folder_ / name;
}

std::filesystem::path Checkpoint::own_file(const KeptState& state) const {
  return file(state).replace_extension("guesses" + std::to_string(grid_.rank()));
}

// States are numbered through all runs. One that was damaged since, or whose steps were: the one before it serves.
void Checkpoint::find_states() {
  std::string names;
  if (grid_.rank() == 0) {
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      names += entry.path().filename().string() + "\n";
  }
  broadcast(grid_.comm(), names);
  std::istringstream lines(names);
  for (std::string name; std::getline(lines, name);) {
    KeptState state;
    const int numbers = std::sscanf(name.c_str(), "run%d_%d.state", &state.run, &state.number);
    if (numbers == 2 && name == file(state).filename()) kept_.push_back(state);
  }
  std::ranges::sort(kept_, {}, &KeptState::number);
  for (std::size_t n = 0; n < kept_.size(); ++n) {
    if (!complete(kept_[n], n > 0 ? kept_[n - 1].steps : StepLogMark())) return forget_from(n);
  }
}

/// Completes what the name of a state does not tell. Whether the state and its steps are what was written.
bool Checkpoint::complete(KeptState& state, const StepLogMark& steps_before) {
  const std::optional<StateFile> found = read_state(grid_.comm(), file(state));
  if (!found) return false;
  if (!same_lattice(grid_.shape(), found->shape)) {
    throw InputError("'" + file(state).string() + "' is of a grid of other steps; start again without -restart");
  }
  const Summary& description = found->description;
  if (description["quantities"] != quantity_names()) {
    throw InputError("'" + folder_.string() +
                     "' was kept by a program with other quantities; start again without -restart");
  }
  state.T = description["T"].get<double>();
  state.with_snapshots = !description["snapshots"].empty();
  const auto steps_end = description["steps_end"].get<std::uint64_t>();
  if (steps_end < steps_before.end) return false;
  state.steps = log_.mark_at(steps_end, steps_before);
  if (state.steps.checksum != description["steps_checksum"].get<std::uint64_t>()) return false;
  const Summary& guesses = description["guesses"];
  std::optional<std::vector<double>> own = read_rank_file(
      grid_.comm(), own_file(state), {guesses["processes"].get<int>(), guesses["checksum"].get<std::uint64_t>()});
  if (own) memory_ = std::move(*own);
  return own.has_value();
}

void Checkpoint::remove_file(const KeptState& state) const {
  remove_if_written_here(own_file(state));
  if (grid_.rank() == 0) remove_if_written_here(file(state));
}

void Checkpoint::remove() {
  if (grid_.rank() == 0) remove_all_written_here(folder_);
}

void Checkpoint::forget_from(std::size_t first) {
  for (std::size_t n = first; n < kept_.size(); ++n) remove_file(kept_[n]);
  kept_.resize(first);
}

std::optional<StoredRun> Checkpoint::begin_run(double T, const Motion& motion) {
  ++run_;
  run_begin_ = {T, motion};
  waiting_.clear();
  attached_.clear();
  replayed_.clear();
  replayed_sections_.clear();
  const auto first = std::ranges::lower_bound(kept_, run_, {}, &KeptState::run);
  const auto end = std::ranges::upper_bound(kept_, run_, {}, &KeptState::run);
  if (first == end) return {};
  StoredRun kept;
  for (auto state = first; state != end; ++state) {
    const bool last = state + 1 == end;
    if (!last && !state->with_snapshots) continue;
    const std::optional<StateFile> found = read_state(grid_.comm(), file(*state));
    if (!found) throw InputError("'" + file(*state).string() + "' is gone; start again without -restart");
    const Summary& description = found->description;
    if (!same_run_begin(description["begin"], run_begin_)) {
      forget_from(static_cast<std::size_t>(first - kept_.begin()));  // the march has taken another way
      return {};
    }
    read_snapshots(Grid(grid_.comm(), found->shape), description, found->fields, replayed_, replayed_sections_);
    if (!last) continue;
    kept.T = description["T"].get<double>();
    kept.state.motion = description["motion"].get<Motion>();
    kept.state.films = films_from(found->fields, description["films"]);
    kept.state.shape = found->shape;
    if (end == kept_.end()) kept.memory = memory_;
    if (carried_) {
      const Grid grid(grid_.comm(), found->shape);
      carried_->take(read_sums(grid, description["sums"].get<std::size_t>(), found->fields), grid);
    }
  }
  const std::uint64_t steps_begin = first == kept_.begin() ? 0 : (first - 1)->steps.end;
  kept.records = log_.read(steps_begin, (end - 1)->steps.end);
  return kept;
}

void Checkpoint::record(const StepRecord& record) { waiting_.push_back(record); }

void Checkpoint::attach(const FilmSnapshot& snapshot) { attached_.push_back(snapshot); }

std::optional<FilmSnapshot> Checkpoint::recall_snapshot() {
  if (replayed_.empty()) return {};
  FilmSnapshot snapshot = std::move(replayed_.front());
  replayed_.pop_front();
  return snapshot;
}

std::optional<FilmSnapshot> Checkpoint::recall_sections(double T) {
  if (replayed_sections_.empty() || replayed_sections_.front().T != T) return {};
  FilmSnapshot snapshot = std::move(replayed_sections_.front());
  replayed_sections_.pop_front();
  return snapshot;
}

void Checkpoint::drop_snapshots() {
  for (KeptState& state : kept_) state.with_snapshots = state.with_snapshots && state.run != run_;
}

void Checkpoint::keep(double T, const PairState& state, std::vector<double> memory) {
  // A run that failed before fails again when it is done again; what came after it is known.
  if (!caught_up()) return;
  write_together(grid_.comm(), folder_, [&] { flush_.finish(); });
  const StepLogMark steps_before = kept_.empty() ? StepLogMark() : kept_.back().steps;
  KeptState next{run_, kept_.empty() ? 0 : kept_.back().number + 1, T, {}, !attached_.empty()};
  next.steps = log_.write(steps_before, waiting_);
  const RankFilesMark guesses_mark = write_rank_file(grid_.comm(), own_file(next), memory);
  memory = {};  // it is large
  Summary description = {{"T", T},
                         {"motion", state.motion},
                         {"begin", run_begin_},
                         {"steps_end", next.steps.end},
                         {"steps_checksum", next.steps.checksum},
                         {"guesses", {{"processes", guesses_mark.processes}, {"checksum", guesses_mark.checksum}}}};
  const Grid grid = state.shape.nx == 0 ? grid_ : Grid(grid_.comm(), state.shape);
  CompactFields fields = fields_of(state);
  description["films"] = field_names(state);
  description["quantities"] = quantity_names();
  description["snapshots"] = Summary::array();
  for (const FilmSnapshot& snapshot : attached_) {
    description["snapshots"].push_back(description_of(snapshot));
    append_fields(grid, snapshot, fields);
  }
  const std::vector<double> sums = carried_ ? carried_->sums() : std::vector<double>();
  description["sums"] = sums.size();
  append_sums(grid, sums, fields);
  write_state(grid, file(next), description, fields);
  std::vector<std::filesystem::path> written = {own_file(next), file(next)};
  if (grid_.rank() == 0) written.insert(written.end(), {log_.path(), folder_});
  flush_.begin(std::move(written));
  kept_.push_back(next);
  waiting_.clear();
  attached_.clear();
  remove_superfluous();
}

void Checkpoint::remove_superfluous() {
  for (std::size_t n = 0; n + states_kept < kept_.size();) {
    const bool ends_run = kept_[n + 1].run != kept_[n].run;
    if (ends_run || kept_[n].with_snapshots) {
      ++n;
    } else {
      remove_file(kept_[n]);
      kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(n));
    }
  }
}

}  // namespace gearfilm
