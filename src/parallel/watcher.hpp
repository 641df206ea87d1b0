// A function that long work calls with words for what it is doing, to be shown.
#pragma once

#include <functional>
#include <string>

namespace gearfilm {

/// A watcher is called now and then, on every process that works. It does nothing collective, and may be empty.
using Watcher = std::function<void(const std::string&)>;

}  // namespace gearfilm
