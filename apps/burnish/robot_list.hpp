// List of the robots that can be loaded by name.
#pragma once

#include <string>

namespace burnish::app {

/// Returns one line for each robot and each of its variants: the name, and the description in the
/// robot's settings.
std::string robot_list();

}  // namespace burnish::app
