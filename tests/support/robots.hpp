// Robots for the tests of the kernels, and random states of them.
#pragma once

#include <optional>
#include <ostream>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "burnish/base/error.hpp"
#include "burnish/model/state.hpp"
#include "support/built_robots.hpp"
#if BURNISH_HAS_ROBOTS
#include "burnish/robots/robot.hpp"
#endif

namespace burnish::test {

/// Returns the robot of built_robots() with that name, or nullptr. Its only variant is
/// "name:floating".
inline const BuiltRobot* built_robot(const std::string& name) {
  for (const BuiltRobot& robot : built_robots())
    if (name == robot.name || name == robot.name + ":floating") return &robot;
  return nullptr;
}

/// Whether this build can make the robot.
inline bool is_available(const std::string& name) {
  return has_robot_files || built_robot(name) != nullptr;
}

/// Returns a robot of built_robots() or of the repository, on its own or the given base.
inline Model named_robot(const std::string& name, std::optional<Base> base = {}) {
  if (const BuiltRobot* const built = built_robot(name))
    return built->model(base.value_or(name == built->name ? built->usual : Base::FreeFlyer));
#if BURNISH_HAS_ROBOTS
  RobotOverrides overrides;
  overrides.base = base;
  return load_robot(std::string(BURNISH_ROBOTS_DIR) + "/" + name, overrides).model;
#else
  throw Error("robot '" + name + "' needs robot files, which this build does not read");
#endif
}

/// Robot by its name, with a fixed or floating base. `tool` is a frame at its end.
struct TestRobot {
  std::string name;
  Base base;
  std::string tool;

  Model model() const { return named_robot(name, base); }
  /// Label that is valid as part of a test name.
  std::string label() const {
    std::string text = name + (base == Base::Fixed ? "_fixed" : "_floating");
    for (char& c : text)
      if (c == ':') c = '_';
    return text;
  }
};

/// Prints the label for test output.
inline void PrintTo(const TestRobot& robot, std::ostream* out) { *out << robot.label(); }

/// Returns the items whose robots this build can make; `name` returns the robot of an item.
template <class Item, class Name>
std::vector<Item> available(std::vector<Item> items, const Name& name) {
  std::erase_if(items, [&](const Item& item) { return !is_available(name(item)); });
  return items;
}
inline std::vector<TestRobot> available(const std::vector<TestRobot>& robots) {
  return available(robots, [](const TestRobot& robot) { return robot.name; });
}

/// Talos, or the biped in builds that read no files.
inline TestRobot humanoid(const std::string& tool = "right_sole_link") {
  return {has_robot_files ? "talos" : "biped", Base::FreeFlyer, tool};
}

inline std::vector<TestRobot> robots_on(Base base) {
  std::vector<TestRobot> robots;
  if (has_robot_files)
    robots = {{"talos", base, "right_sole_link"},
              {"talos:right_arm", base, "tool"},
              {"arm7", base, "tool"},
              {"crane", base, "left_tip"}};
  for (const BuiltRobot& built : built_robots()) robots.push_back({built.name, base, built.tool});
  return robots;
}
inline std::vector<TestRobot> floating_robots() { return robots_on(Base::FreeFlyer); }
/// Every robot on both bases.
inline std::vector<TestRobot> test_robots() {
  std::vector<TestRobot> robots = robots_on(Base::Fixed);
  for (const TestRobot& robot : floating_robots()) robots.push_back(robot);
  return robots;
}

/// Robots without follower joints.
inline std::vector<TestRobot> robots_without_followers() {
  std::vector<TestRobot> robots = test_robots();
  std::erase_if(robots, [](const TestRobot& robot) { return robot.name == "followers"; });
  return robots;
}

/// Returns the frame whose body depends on most joints that move none of these frames (the last of
/// several). On a single chain it is a frame in the middle.
inline std::string far_frame(const Model& model, const std::vector<std::string>& frames) {
  std::set<int> near, bodies;
  for (const std::string& name : frames) {
    if (name == "world" && !model.has_frame(name)) continue;
    const int body = model.frames[static_cast<std::size_t>(model.frame_index(name))].body;
    bodies.insert(body);
    for (int j = body; j >= 0; j = model.joints[static_cast<std::size_t>(j)].parent) near.insert(j);
  }
  std::string result;
  int best = -1;
  for (const Frame& frame : model.frames) {
    // If a link and a joint share a name, the frame is the link's.
    if (frame.body < 0 || bodies.contains(frame.body) || frame.kind != FrameKind::Link) continue;
    int others = 0, above = 0;
    for (int j = frame.body; j >= 0; j = model.joints[static_cast<std::size_t>(j)].parent) {
      others += near.contains(j) ? 0 : 100;
      ++above;
    }
    if (others + std::min(above, 3) >= best) {
      best = others + std::min(above, 3);
      result = frame.name;
    }
  }
  return result;
}

/// n entries, uniform in [-bound, bound].
inline Eigen::VectorXd random_vector(int n, double bound, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> draw(-bound, bound);
  Eigen::VectorXd x(n);
  for (double& entry : x) entry = draw(generator);
  return x;
}

}  // namespace burnish::test
