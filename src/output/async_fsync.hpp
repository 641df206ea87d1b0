// Files that reach the disk itself, to outlive a failure of the machine, while the run goes on.
#pragma once

#include <filesystem>
#include <future>
#include <vector>

namespace gearfilm {

/// One flush at a time, beside what this process computes. Its end waits for the flush that is under way.
class AsyncFsync {
public:
  /// Files, or folders for the names in them, that are written and closed. One that goes meanwhile needs no flush.
  void begin(std::vector<std::filesystem::path> paths);
  /// Waits until they are on the disk. Throws std::system_error where one cannot be.
  void finish();

private:
  std::future<void> under_way_;
};

}  // namespace gearfilm
