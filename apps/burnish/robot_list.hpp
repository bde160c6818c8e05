// The robots that are known by name, for those who look for one.
#pragma once

#include <string>

namespace burnish::app {

/// A line for each robot and each variant of it: its name, and what the settings say about it.
std::string robot_list();

}  // namespace burnish::app
