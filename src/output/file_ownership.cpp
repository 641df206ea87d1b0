#include "output/file_ownership.hpp"

#include <hdf5.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

#include "gearfilm/error.hpp"
#include "output/restart_mark.hpp"
#include "output/summary.hpp"
#include "output/xdmf.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_json = 64 << 20;  // [bytes]

std::string text_of(const fs::path& file, std::size_t most) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) return {};
  std::string text(std::min<std::uintmax_t>(size, most), ' ');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  return stream ? text : std::string();
}

bool begins_with(const fs::path& file, std::string_view mark) { return text_of(file, mark.size()) == mark; }

/// A failure of the machine may leave less of a file than its mark.
bool begins_at_most_with(const fs::path& file, std::string_view mark) {
  return mark.starts_with(text_of(file, mark.size()));
}

bool own_restart_file(const fs::path& file) {
  const std::string extension = file.extension();
  const bool named =
      file.filename() == "steps" || extension == ".state" || extension == ".films" || extension.starts_with(".guesses");
  return begins_with(file, restart_mark) || (named && begins_at_most_with(file, restart_mark));
}

bool own_json(const fs::path& file) {
  const Summary content = Summary::parse(text_of(file, largest_json), nullptr, false);
  if (!content.is_object()) return false;
  const auto has = [&](const char* first, const char* second) {
    return content.contains(first) && content.contains(second);
  };
  return content.contains("provenance") || has("command", "case.kind") || has("direction", "value");
}

bool has_format_version(const fs::path& file) {
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (opened < 0) return false;
  const bool found = H5Aexists(opened, "format_version") > 0;
  H5Fclose(opened);
  return found;
}

bool own_results(const fs::path& file) {
  constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
  if (has_format_version(file)) return true;
  return begins_with(file, signature) && own_json(file.parent_path() / "checkpoint" / "run.json");
}

/// A file under its temporary name is what was written of it before an interruption; JSON begins with a brace.
bool own_part(const fs::path& file) {
  const std::string extension = file.stem().extension();
  if (file.filename() == "results.h5.part") return true;  // HDF5 gives a file its content when it is closed
  const std::string_view mark = extension == ".json"  ? "{"
                                : extension == ".xmf" ? xdmf_head
                                : extension == ".txt" ? shares_head
                                                      : restart_mark;
  return begins_at_most_with(file, mark);
}

bool regular(const fs::path& file) {
  std::error_code error;
  return fs::symlink_status(file, error).type() == fs::file_type::regular;
}

std::optional<fs::path> first_foreign(const fs::path& folder) {
  std::error_code missing;
  for (const auto& entry : fs::recursive_directory_iterator(folder, missing)) {
    const fs::file_status status = entry.symlink_status();
    if (status.type() == fs::file_type::directory || written_here(entry.path())) continue;
    return entry.path();
  }
  return {};
}

void refuse(MPI_Comm comm, const std::string& foreign, const std::string& remedy) {
  std::string name = foreign;
  broadcast(comm, name);
  if (name.empty()) return;
  throw InputError("'" + name + "' was not written by this program, which would replace or remove it; " + remedy);
}

}  // namespace

bool written_here(const fs::path& file) {
  if (!regular(file)) return false;
  const std::string extension = file.extension();
  if (extension == ".part") return own_part(file);
  if (extension == ".json") return own_json(file);
  if (extension == ".h5") return own_results(file);
  if (extension == ".xmf") return begins_with(file, xdmf_head);
  if (file.filename() == shares_name) return begins_with(file, shares_head);
  return own_restart_file(file);
}

void require_replaceable(MPI_Comm comm, const std::vector<fs::path>& files) {
  std::string foreign;
  std::error_code error;
  for (const fs::path& file : files) {
    if (rank_in(comm) != 0 || !foreign.empty()) break;
    const bool there = fs::exists(fs::symlink_status(file, error));
    if (there && !written_here(file)) foreign = file.string();
  }
  refuse(comm, foreign, "move it, or choose another folder with -output_dir");
}

void require_removable(MPI_Comm comm, const fs::path& folder) {
  std::string foreign;
  if (rank_in(comm) == 0) foreign = first_foreign(folder).value_or(fs::path()).string();
  refuse(comm, foreign, "move it out of that folder, or choose another one with -output_dir");
}

void remove_if_written_here(const fs::path& file) {
  std::error_code ignored;
  if (written_here(file)) fs::remove(file, ignored);
}

void remove_all_written_here(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) entries.push_back(entry.path());
  for (const fs::path& entry : entries) {
    if (fs::symlink_status(entry, ignored).type() == fs::file_type::directory) {
      remove_all_written_here(entry);
    } else {
      remove_if_written_here(entry);
    }
  }
  const bool link = fs::is_symlink(folder, ignored);
  if (!link && fs::is_directory(folder, ignored)) fs::remove(folder, ignored);  // fails where something is left
}

}  // namespace gearfilm
