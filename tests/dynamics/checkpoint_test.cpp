// What is kept on disk of a march comes back to the bit, or not at all.
#include "output/checkpoint.hpp"

#include <filesystem>
#include <fstream>

#include "gearfilm/error.hpp"
#include "output/checksum.hpp"
#include "output/restart_mark.hpp"
#include "output/state_file.hpp"
#include "pair_case.hpp"

namespace gearfilm {
namespace {

/// A folder of the test's own, common to all processes.
class CheckpointTest : public testing::Test {
protected:
  CheckpointTest() : grid_(PETSC_COMM_WORLD, rectangle(33, 17, -2.0, 1.5, 1.2)) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("gearfilm_" + std::string(test->name()) + "_" + std::to_string(grid_.processes()));
    path_ = folder_ / "a.state";
    if (grid_.rank() == 0) {
      std::filesystem::remove_all(folder_);
      std::filesystem::create_directories(folder_);
    }
    MPI_Barrier(PETSC_COMM_WORLD);
  }
  ~CheckpointTest() override {
    MPI_Barrier(PETSC_COMM_WORLD);
    std::error_code ignored;
    if (grid_.rank() == 0) std::filesystem::remove_all(folder_, ignored);
  }

  /// Different at every node of the whole grid, and on no process a round number.
  std::vector<double> field(double seed) const {
    std::vector<double> values;
    for (int i = 0; i < grid_.nx(); ++i) {
      for (int j = 0; j < grid_.y_count(); ++j)
        values.push_back(std::sin(seed + 0.1 * i + 7.0 * (grid_.y_begin() + j)));
    }
    return values;
  }

  StepRecord step(double T) const {
    StepRecord record;
    record.T = T;
    record.dT = 0.1 / 3.0;
    record.motion = Motion(Eigen::Vector2d(-1.0 / 3.0, T), Eigen::Vector2d(T / 7.0, -T));
    record.newton = 3;
    record.krylov = 17;
    record.halvings = 2;
    ContactQuantities quantities;
    quantities["force"] = T / 3.0;
    quantities["h_min"] = T / 11.0;
    record.contacts = {{4, T / 13.0, quantities}};
    return record;
  }

  /// Changes the lowest bit of a byte; the second time back.
  void change_bit(const std::filesystem::path& path, std::uintmax_t place) const {
    MPI_Barrier(PETSC_COMM_WORLD);
    if (grid_.rank() == 0) {
      std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
      file.seekg(static_cast<std::streamoff>(place));
      const int byte = file.get();
      file.seekp(static_cast<std::streamoff>(place));
      file.put(static_cast<char>(byte ^ 1));
    }
    MPI_Barrier(PETSC_COMM_WORLD);
  }

  Grid grid_;
  std::filesystem::path folder_;
  std::filesystem::path path_;
};

TEST_F(CheckpointTest, state_comes_back_to_the_bit) {
  const CompactFields fields = {field(1.0), field(2.0), field(3.0)};
  write_state(grid_, path_, {{"T", 1.0 / 3.0}}, fields);
  const std::optional<StateFile> state = read_state(grid_.comm(), path_);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->description["T"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(state->fields, fields);
}

// Its fields begin where the description of the first process ends.
TEST_F(CheckpointTest, description_is_that_of_the_first_process) {
  const CompactFields fields = {field(1.0)};
  write_state(grid_, path_, {{"words", std::string(1 + 3 * grid_.rank(), 'a')}}, fields);
  const std::optional<StateFile> state = read_state(grid_.comm(), path_);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->description["words"], "a");
  EXPECT_EQ(state->fields, fields);
}

TEST_F(CheckpointTest, journal_has_the_times_of_the_first_process) {
  std::vector<StepRecord> records = {step(0.1), step(0.2)};
  for (StepRecord& record : records) record.wall_seconds = 0.5 * grid_.rank();
  const StepLog journal(PETSC_COMM_WORLD, path_);
  const StepLogMark end = journal.write({}, records);
  EXPECT_EQ(end.checksum, journal.mark_at(end.end, {}).checksum);
  for (const StepRecord& record : journal.read(0, end.end)) {
    EXPECT_EQ(record.wall_seconds, 0.0);
    EXPECT_EQ(record.halvings, 2);
  }
}

TEST_F(CheckpointTest, state_is_read_by_another_number_of_processes) {
  write_state(grid_, path_, {}, {field(1.0), field(2.0)});
  const Grid alone(PETSC_COMM_SELF, grid_.shape());
  const std::optional<StateFile> whole = read_state(alone.comm(), path_);
  ASSERT_TRUE(whole);
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.y_count(); ++j) {
      EXPECT_EQ(whole->fields[1][i * grid_.rows() + grid_.y_begin() + j], field(2.0)[i * grid_.y_count() + j]);
    }
  }
}

TEST_F(CheckpointTest, state_that_was_cut_off_is_none) {
  write_state(grid_, path_, {}, {field(1.0)});
  const auto size = std::filesystem::file_size(path_);
  for (const std::uintmax_t cut : {size - 1, size / 2, std::uintmax_t{20}, std::uintmax_t{3}, std::uintmax_t{0}}) {
    MPI_Barrier(PETSC_COMM_WORLD);
    if (grid_.rank() == 0) std::filesystem::resize_file(path_, cut);
    MPI_Barrier(PETSC_COMM_WORLD);
    EXPECT_FALSE(read_state(grid_.comm(), path_));
  }
}

// All bytes of the head and the description, every 97th of the fields.
TEST_F(CheckpointTest, state_with_any_bit_changed_is_none) {
  write_state(grid_, path_, {{"T", 1.0 / 3.0}}, {field(1.0), field(2.0)});
  const auto size = std::filesystem::file_size(path_);
  const auto fields = size - 2 * sizeof(double) * grid_.nx() * grid_.rows();
  for (std::uintmax_t n = 0; n < size; n += n < fields ? 1 : 97) {
    change_bit(path_, n);
    EXPECT_FALSE(read_state(grid_.comm(), path_)) << n;
    change_bit(path_, n);
  }
  EXPECT_TRUE(read_state(grid_.comm(), path_));
}

TEST_F(CheckpointTest, state_of_zeros_is_none) {
  if (grid_.rank() == 0) std::ofstream(path_) << std::string(1000, '\0');
  MPI_Barrier(PETSC_COMM_WORLD);
  EXPECT_FALSE(read_state(grid_.comm(), path_));
}

// A grid of the same steps may have been widened; one of other steps is another.
TEST_F(CheckpointTest, state_of_a_grid_of_other_steps_is_refused) {
  const std::filesystem::path folder = folder_ / "checkpoint";
  {
    Checkpoint checkpoint(grid_, folder, Checkpoint::Begin::anew);
    checkpoint.begin_run(0.0, {});
    checkpoint.record(step(0.1));
    checkpoint.keep(0.1, {{}, {{{"pressure", field(1.0)}}}, grid_.shape()}, {});
  }
  GridShape other = grid_.shape();
  other.x_max += grid_.h_x();
  EXPECT_THROW(Checkpoint(Grid(PETSC_COMM_WORLD, other), folder, Checkpoint::Begin::where_it_stopped), InputError);
  ++other.nx;
  EXPECT_EQ(Checkpoint(Grid(PETSC_COMM_WORLD, other), folder, Checkpoint::Begin::where_it_stopped).kept_until(), 0.1);
}

TEST(ChecksumTest, tells_values_and_their_places_and_is_a_sum_of_parts) {
  const std::vector<double> values = {0.0, 1.0, -1.0, 0.0};
  const std::uint64_t whole = checksum(values);
  EXPECT_EQ(whole, checksum(std::span(values).first(1)) + checksum(std::span(values).subspan(1), 1));
  for (const std::vector<double>& other : {std::vector<double>{1.0, 0.0, -1.0, 0.0},
                                           {-0.0, 1.0, -1.0, 0.0},
                                           {0.0, 1.0, -1.0},
                                           {0.0, 1.0, -1.0, 0.0, 0.0}}) {
    EXPECT_NE(checksum(other), whole);
  }
}

TEST_F(CheckpointTest, runs_come_back_in_their_order_with_all_their_steps) {
  const auto state_at = [&](double T) {
    return PairState{{T / 3.0, T / 9.0}, {{{"pressure", field(T)}, {"rate", field(T + 0.5)}}}, grid_.shape()};
  };
  {
    Checkpoint checkpoint(grid_, folder_ / "checkpoint", Checkpoint::Begin::anew);
    for (int run = 0; run < 3; ++run) {
      EXPECT_FALSE(checkpoint.begin_run(run, {0.1 * run, 0.0}));
      for (int segment = 0; segment < 4; ++segment) {
        const double T = run + 0.2 * (segment + 1);
        checkpoint.record(step(T - 0.1));
        checkpoint.record(step(T));
        checkpoint.keep(T, state_at(T), {T, 2.0 * T});
      }
      checkpoint.record(step(run + 0.95));  // never kept
    }
  }
  Checkpoint checkpoint(grid_, folder_ / "checkpoint", Checkpoint::Begin::where_it_stopped);
  for (int run = 0; run < 3; ++run) {
    EXPECT_EQ(checkpoint.caught_up(), false);
    const std::optional<StoredRun> kept = checkpoint.begin_run(run, {0.1 * run, 0.0});
    ASSERT_TRUE(kept);
    const double T = run + 0.2 * 4;
    EXPECT_EQ(kept->T, T);
    EXPECT_EQ(kept->state.motion.H0(), T / 3.0);
    EXPECT_EQ(kept->state.films.front().at("pressure"), field(T));
    EXPECT_EQ(kept->state.films.front().at("rate"), field(T + 0.5));
    // Those of a run that another one followed nobody goes on from.
    EXPECT_EQ(kept->memory, run == 2 ? std::vector<double>({T, 2.0 * T}) : std::vector<double>());
    ASSERT_EQ(kept->records.size(), 8U);
    EXPECT_EQ(kept->records.back().motion.V0(), T / 7.0);
    EXPECT_EQ(kept->records.back().motion.freedoms(), 2);
    EXPECT_EQ(kept->records.back().motion.v[1], -T);
    EXPECT_EQ(kept->records.back().contacts.front().quantities["h_min"], T / 11.0);
  }
  EXPECT_TRUE(checkpoint.caught_up());
  EXPECT_FALSE(checkpoint.begin_run(3.0, {0.3, 0.0}));
}

TEST_F(CheckpointTest, state_before_the_damage_serves) {
  const std::filesystem::path folder = folder_ / "checkpoint";
  {
    Checkpoint checkpoint(grid_, folder, Checkpoint::Begin::anew);
    checkpoint.begin_run(0.0, {});
    for (const double T : {0.1, 0.2}) {
      checkpoint.record(step(T));
      checkpoint.keep(T, {{T, 0.0}, {{{"pressure", field(T)}, {"rate", field(T)}}}, grid_.shape()}, {T});
    }
  }
  const auto kept_until = [&] { return Checkpoint(grid_, folder, Checkpoint::Begin::where_it_stopped).kept_until(); };
  EXPECT_EQ(kept_until(), 0.2);
  const auto steps = std::filesystem::file_size(folder / "steps") - restart_mark.size();
  change_bit(folder / "steps", restart_mark.size() + steps / 2 + 1);  // of the second step
  EXPECT_EQ(kept_until(), 0.1);
  change_bit(folder / "run000_00000.state", 1000);
  EXPECT_EQ(kept_until(), 0.0);
}

TEST_F(CheckpointTest, state_before_damaged_guesses_serves) {
  const std::filesystem::path folder = folder_ / "checkpoint";
  {
    Checkpoint checkpoint(grid_, folder, Checkpoint::Begin::anew);
    checkpoint.begin_run(0.0, {});
    for (const double T : {0.1, 0.2}) checkpoint.keep(T, {{T, 0.0}, {{{"pressure", field(T)}}}, grid_.shape()}, {T, T});
  }
  change_bit(folder / "run000_00001.guesses0", restart_mark.size() + 9);
  Checkpoint checkpoint(grid_, folder, Checkpoint::Begin::where_it_stopped);
  const std::optional<StoredRun> kept = checkpoint.begin_run(0.0, {});
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->T, 0.1);
  EXPECT_EQ(kept->memory, std::vector<double>({0.1, 0.1}));
  EXPECT_FALSE(std::filesystem::exists(folder / "run000_00001.guesses0"));
}

// Names that nothing else knows, different ones on two contacts, with a snapshot behind them.
TEST_F(CheckpointTest, every_named_field_of_a_contact_comes_back) {
  const std::vector<ContactFields> films = {
      {{"pressure", field(1.0)}, {"rate", field(2.0)}, {"temperature", field(3.0)}},
      {{"flash_temperature", field(4.0)}, {"pressure", field(5.0)}, {"rate", field(6.0)}}};
  Field<double> shown(grid_);
  shown.load(field(7.0));
  {
    Checkpoint checkpoint(grid_, folder_ / "checkpoint", Checkpoint::Begin::anew);
    EXPECT_FALSE(checkpoint.begin_run(0.0, {}));
    checkpoint.record(step(0.1));
    checkpoint.attach({0.1, {{4, 1e-3, {{"pressure", shown}, {"temperature", shown}}}}, grid_.shape()});
    checkpoint.keep(0.1, {{}, films, grid_.shape()}, {});
  }
  Checkpoint checkpoint(grid_, folder_ / "checkpoint", Checkpoint::Begin::where_it_stopped);
  const std::optional<StoredRun> kept = checkpoint.begin_run(0.0, {});
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->state.films, films);
  const std::optional<FilmSnapshot> snapshot = checkpoint.recall_snapshot();
  ASSERT_TRUE(snapshot);
  const std::vector<NamedField>& fields = snapshot->contacts.front().fields;
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_EQ(fields[0].name, "pressure");
  EXPECT_EQ(fields[1].name, "temperature");
  for (const NamedField& again : fields) {
    std::vector<double> values(static_cast<std::size_t>(grid_.local_size()));
    again.values.store(values);
    EXPECT_EQ(values, field(7.0));
  }
}

TEST_F(CheckpointTest, run_that_begins_otherwise_is_not_taken_over) {
  const auto keep_one_run = [&](Checkpoint& checkpoint, double H0) {
    const bool known = checkpoint.begin_run(0.0, {H0, 0.0}).has_value();
    checkpoint.record(step(0.1));
    checkpoint.keep(0.1, {{H0, 0.0}, {}}, {});
    return known;
  };
  Checkpoint first(grid_, folder_ / "checkpoint", Checkpoint::Begin::anew);
  EXPECT_FALSE(keep_one_run(first, 0.1));
  Checkpoint within_tolerance(grid_, folder_ / "checkpoint", Checkpoint::Begin::where_it_stopped);
  EXPECT_TRUE(within_tolerance.begin_run(0.0, {0.1 + 1e-9, 0.0}));
  Checkpoint other(grid_, folder_ / "checkpoint", Checkpoint::Begin::where_it_stopped);
  EXPECT_FALSE(keep_one_run(other, 0.2));
}

}  // namespace
}  // namespace gearfilm
