// How long work tells what it is at, in words, to whoever shows it.
#pragma once

#include <functional>
#include <string>

namespace gearfilm {

/// Called now and then, on every process that works; does nothing collective. May be empty.
using Watcher = std::function<void(const std::string&)>;

}  // namespace gearfilm
