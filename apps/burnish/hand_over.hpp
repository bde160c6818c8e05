// What Python does for the command line.
#pragma once

#include <string>
#include <vector>

namespace burnish::app {

/// Becomes `python3 -m burnish.campaign WORDS...`, and does not return. Programs and modules are
/// found through the absolute entries of PATH and PYTHONPATH alone, never through the working
/// folder. Throws Error where there is no Python that has the package burnish and `module`, of
/// Debian's package python3-MODULE, naming what to install.
[[noreturn]] void hand_over_to_python(const std::vector<std::string>& words,
                                      const std::string& module);

}  // namespace burnish::app
