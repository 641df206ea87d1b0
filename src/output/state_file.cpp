#include "output/state_file.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>

#include "gearfilm/error.hpp"
#include "output/checksum.hpp"
#include "output/format_version.hpp"
#include "output/output_directory.hpp"
#include "output/restart_mark.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

void mpi_check(int code) {
  if (code == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(code, text, &length);
  throw std::runtime_error(std::string(text, static_cast<std::size_t>(length)));
}

/// This process's part of all fields of a file.
class FieldsView {
public:
  FieldsView(const Grid& grid, std::size_t fields) {
    const int lines = static_cast<int>(fields) * grid.nx();
    const int all[2] = {lines, grid.rows()}, own[2] = {lines, grid.y_count()}, begin[2] = {0, grid.y_begin()};
    MPI_Type_create_subarray(2, all, own, begin, MPI_ORDER_C, MPI_DOUBLE, &type_);
    MPI_Type_commit(&type_);
    MPI_Type_contiguous(grid.nx() * grid.y_count(), MPI_DOUBLE, &own_field_);
    MPI_Type_commit(&own_field_);
  }
  ~FieldsView() {
    MPI_Type_free(&own_field_);
    MPI_Type_free(&type_);
  }
  FieldsView(const FieldsView&) = delete;
  FieldsView& operator=(const FieldsView&) = delete;

  /// So many of these are all fields: their values together may be more than an int can count.
  MPI_Datatype own_field() const { return own_field_; }

  int show(MPI_File file, MPI_Offset offset) const {
    return MPI_File_set_view(file, offset, MPI_DOUBLE, type_, "native", MPI_INFO_NULL);
  }

private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
  MPI_Datatype own_field_ = MPI_DATATYPE_NULL;
};

struct Head {
  std::array<char, restart_mark.size()> mark = {};
  std::uint64_t length = 0;    ///< of the description
  std::uint64_t checksum = 0;  ///< of the description
};

MPI_Offset fields_begin(std::size_t description) {
  return static_cast<MPI_Offset>(sizeof(Head)) + static_cast<MPI_Offset>(description);
}

/// Of all fields, over all processes: the place of a value is that in the file.
std::uint64_t checksum_of(const Grid& grid, const CompactFields& fields) {
  const auto rows = static_cast<std::size_t>(grid.rows()), count = static_cast<std::size_t>(grid.y_count());
  auto before = static_cast<std::size_t>(grid.y_begin());
  std::uint64_t own = 0, sum = 0;
  for (const std::vector<double>& field : fields) {
    for (std::size_t first = 0; first < field.size(); first += count, before += rows) {
      own += checksum(std::span(field).subspan(first, count), before);
    }
  }
  MPI_Allreduce(&own, &sum, 1, MPI_UINT64_T, MPI_SUM, grid.comm());
  return sum;
}

/// Whether a file of this format has the size that its description says. What lies beyond the end of a file is read
/// as anything: the fields' checksum might match it.
bool has_all_fields(const Summary& description, std::uintmax_t description_size, std::uintmax_t size) {
  std::uintmax_t values = description["fields"].get<std::uintmax_t>();
  for (const Summary& nodes : description["nodes"]) values *= nodes.get<std::uintmax_t>();
  return size == sizeof(Head) + description_size + values * sizeof(double);
}

/// The description as it stands in the file; empty where it is damaged, or fields are missing.
std::string description_in(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  Head head;
  file.read(reinterpret_cast<char*>(&head), sizeof head);
  if (error || !file || !std::ranges::equal(head.mark, restart_mark) || head.length > size) return {};
  std::string text(head.length, ' ');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file || checksum(text) != head.checksum) return {};
  // A file of zeros has the checksum of no text.
  const Summary description = Summary::parse(text, nullptr, false);
  if (!description.is_object()) return {};
  const bool this_format = description.contains("format") && description["format"] == restart_format;
  return this_format && !has_all_fields(description, text.size(), size) ? std::string() : text;
}

/// Writes the fields behind the description.
void append_fields(const Grid& grid, const std::filesystem::path& path, MPI_Offset begin, const CompactFields& fields) {
  std::vector<double> values;
  values.reserve(fields.size() * static_cast<std::size_t>(grid.local_size()));
  for (const std::vector<double>& field : fields) values.insert(values.end(), field.begin(), field.end());
  write_together(grid.comm(), path, [&] {
    MPI_File file = MPI_FILE_NULL;
    mpi_check(MPI_File_open(grid.comm(), path.c_str(), MPI_MODE_WRONLY, MPI_INFO_NULL, &file));
    const FieldsView view(grid, fields.size());
    // All processes take part in every call, whatever came of the one before.
    const int codes[] = {
        view.show(file, begin),
        MPI_File_write_all(file, values.data(), static_cast<int>(fields.size()), view.own_field(), MPI_STATUS_IGNORE),
        MPI_File_close(&file)};
    for (int code : codes) mpi_check(code);
  });
}

/// The same back; nothing where it cannot be read.
std::optional<CompactFields> extract_fields(const Grid& grid, const std::filesystem::path& path, MPI_Offset begin,
                                            std::size_t count) {
  const auto size = static_cast<std::size_t>(grid.local_size());
  std::vector<double> values(count * size);
  MPI_File file = MPI_FILE_NULL;
  int code = MPI_File_open(grid.comm(), path.c_str(), MPI_MODE_RDONLY, MPI_INFO_NULL, &file);
  if (code == MPI_SUCCESS) {
    const FieldsView view(grid, count);
    code = view.show(file, begin);
    const int read =
        MPI_File_read_all(file, values.data(), static_cast<int>(count), view.own_field(), MPI_STATUS_IGNORE);
    MPI_File_close(&file);
    code = code == MPI_SUCCESS ? read : code;
  }
  if (!first_of_all_reasons(grid.comm(), code == MPI_SUCCESS ? "" : "unread").empty()) return {};
  CompactFields fields;
  for (std::size_t n = 0; n < count; ++n) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(n * size);
    fields.emplace_back(first, first + static_cast<std::ptrdiff_t>(size));
  }
  return fields;
}

}  // namespace

CompactFields fields_of(const PairState& state) {
  CompactFields fields;
  for (const ContactFields& film : state.films) {
    for (const auto& [name, values] : film) fields.push_back(values);
  }
  return fields;
}

Summary field_names(const PairState& state) {
  Summary names = Summary::array();
  for (const ContactFields& film : state.films) {
    names.push_back(Summary::array());
    for (const auto& [name, values] : film) names.back().push_back(name);
  }
  return names;
}

std::vector<ContactFields> films_from(const CompactFields& fields, const Summary& names) {
  std::vector<ContactFields> films;
  std::size_t next = 0;
  for (const Summary& contact : names) {
    films.emplace_back();
    for (const Summary& name : contact) films.back()[name.get<std::string>()] = fields.at(next++);
  }
  return films;
}

void write_state(const Grid& grid, const std::filesystem::path& path, Summary description,
                 const CompactFields& fields) {
  description["format"] = restart_format;
  description["fields"] = fields.size();
  description["nodes"] = {grid.nx(), grid.rows()};
  description["lines"] = {grid.shape().x_min, grid.shape().x_max};
  description["rows"] = grid.row_axis().y();
  description["mirrored"] = grid.row_axis().mirrored();
  description["checksum"] = checksum_of(grid, fields);
  std::string text = description.dump();
  broadcast(grid.comm(), text);  // all count from its end
  const std::filesystem::path part = part_of(path);
  write_together(grid.comm(), path, [&] {
    if (grid.rank() != 0) return;
    Head head{{}, text.size(), checksum(text)};
    std::ranges::copy(restart_mark, head.mark.begin());
    write_bytes(part, {reinterpret_cast<const char*>(&head), sizeof head});
    write_bytes(part, text, std::ios::app);
  });
  if (!fields.empty()) append_fields(grid, part, fields_begin(text.size()), fields);
  finish_part(grid.comm(), path);
}

std::optional<StateFile> read_state(MPI_Comm comm, const std::filesystem::path& path) {
  std::string text = rank_in(comm) == 0 ? description_in(path) : std::string();
  broadcast(comm, text);
  if (text.empty()) return {};
  StateFile state{Summary::parse(text), {}, {}};
  require_restart_format(state.description, path);
  const Summary &nodes = state.description["nodes"], &lines = state.description["lines"];
  const Edge lower = state.description["mirrored"].get<bool>() ? Edge::symmetry : Edge::ambient;
  state.shape = {nodes[0].get<int>(), lines[0].get<double>(), lines[1].get<double>(),
                 RowAxis(state.description["rows"].get<std::vector<double>>(), lower, Edge::ambient)};
  const Grid grid(comm, state.shape);
  if (const auto count = state.description["fields"].get<std::size_t>(); count > 0) {
    std::optional<CompactFields> fields = extract_fields(grid, path, fields_begin(text.size()), count);
    if (!fields) return {};
    state.fields = std::move(*fields);
  }
  if (checksum_of(grid, state.fields) != state.description["checksum"].get<std::uint64_t>()) return {};
  return state;
}

}  // namespace gearfilm
