// Replacement of this process by a command of the Python package burnish.
#pragma once

#include <string>
#include <vector>

namespace burnish::app {

/// Replaces this process by the equivalent of `python3 -m burnish.campaign WORDS...`, and does not
/// return. Programs and modules are searched only in the absolute entries of PATH and PYTHONPATH,
/// never in the working folder. Throws Error if no Python has both the package burnish and
/// `module`. The message names the package to install (in Debian, python3-MODULE).
[[noreturn]] void hand_over_to_python(const std::vector<std::string>& words,
                                      const std::string& module);

}  // namespace burnish::app
