#include "output/async_fsync.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace gearfilm {
namespace {

void flush(const std::filesystem::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0 && errno == ENOENT) return;
  if (descriptor < 0) throw std::system_error(errno, std::generic_category());
  const int error = fsync(descriptor) == 0 ? 0 : errno;
  close(descriptor);
  // Some file systems have nothing to flush for a folder.
  if (error != 0 && error != EINVAL) throw std::system_error(error, std::generic_category());
}

}  // namespace

void AsyncFsync::begin(std::vector<std::filesystem::path> paths) {
  under_way_ = std::async(std::launch::async, [paths = std::move(paths)] {
    for (const std::filesystem::path& path : paths) flush(path);
  });
}

void AsyncFsync::finish() {
  if (under_way_.valid()) under_way_.get();
}

}  // namespace gearfilm
