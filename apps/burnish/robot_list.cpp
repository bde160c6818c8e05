#include "robot_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "burnish/base/error.hpp"
#include "robots/known_robots.hpp"
#include "robots/robot_settings.hpp"

namespace burnish::app {

std::string robot_list() {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const auto& [name, file] : known_robots()) {
    try {
      const RobotSettingsFile settings = read_robot_settings(file);
      lines.emplace_back(name, settings.common.description.value_or(""));
      for (const auto& [variant, changes] : settings.variants)
        lines.emplace_back(name + ":" + variant, changes.description.value_or(""));
    } catch (const Error& error) {
      lines.emplace_back(name, std::string("cannot be read: ") + error.what());
    }
  }
  std::size_t width = 0;
  for (const auto& [name, description] : lines) width = std::max(width, name.size());
  std::string text;
  for (const auto& [name, description] : lines)
    text +=
        description.empty() ? name + "\n" : fmt::format("{:<{}}  {}\n", name, width, description);
  return text;
}

}  // namespace burnish::app
