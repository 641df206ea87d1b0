#include "output/format_version.hpp"

#include "gearfilm/error.hpp"
#include "input/plain_text.hpp"

namespace gearfilm {

void require_restart_format(const Summary& content, const std::filesystem::path& file) {
  const auto found = content.find("format");
  if (found != content.end() && *found == restart_format) return;
  const std::string theirs = found == content.end() ? "no format version" : "format version " + one_line(found->dump());
  throw InputError("'", file.string(), "' has ", theirs, ", and this gearfilm goes on from version ", restart_format,
                   " alone; go on with the gearfilm that wrote it, or begin again in another folder (-output_dir)");
}

}  // namespace gearfilm
