// The robots that the kernels are tested on, and random states of them.
#pragma once

#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "burnish/base/error.hpp"
#include "burnish/model/state.hpp"
#include "support/built_robots.hpp"
#ifndef BURNISH_HAS_ROBOTS
#error "link burnish_test_robots: without, this would quietly test fewer robots"
#endif
#if BURNISH_HAS_ROBOTS
#include "burnish/model/robot.hpp"
#endif

namespace burnish::test {

/// Whether this build reads robots from files.
constexpr bool has_robot_files = BURNISH_HAS_ROBOTS;

/// A robot that comes with the repository, on its own base or the given one.
inline Model robot_from_file([[maybe_unused]] const std::string& name,
                             [[maybe_unused]] std::optional<Base> base = {}) {
#if BURNISH_HAS_ROBOTS
  RobotOverrides overrides;
  overrides.base = base;
  return load_robot(std::string(BURNISH_ROBOTS_DIR) + "/" + name, overrides).model;
#else
  throw Error("robot '" + name + "' is in files, which this build does not read");
#endif
}

/// The one of built_robots() of that name, or nullptr.
inline const BuiltRobot* built_robot(const std::string& name) {
  for (const BuiltRobot& robot : built_robots())
    if (robot.name == name) return &robot;
  return nullptr;
}

/// A robot that comes with the repository or one of built_robots(), bolted down or floating. `tool`
/// is a frame at its end.
struct TestRobot {
  std::string name;
  Base base;
  std::string tool;

  Model model() const {
    const BuiltRobot* const built = built_robot(name);
    if (built == nullptr) return robot_from_file(name, base);
    ModelOptions options;
    options.base = base;
    return build_model(built->tree(), options);
  }
  /// A name that a test case may have.
  std::string label() const {
    std::string text = name + (base == Base::Fixed ? "_fixed" : "_floating");
    for (char& c : text)
      if (c == ':') c = '_';
    return text;
  }
};

/// How a test names it.
inline void PrintTo(const TestRobot& robot, std::ostream* out) { *out << robot.label(); }

/// Those that this build can make. `name` gives the name of an element.
template <class Item, class Name>
std::vector<Item> available(const std::vector<Item>& items, const Name& name) {
  std::vector<Item> result;
  for (const Item& item : items)
    if (has_robot_files || built_robot(name(item)) != nullptr) result.push_back(item);
  return result;
}
inline std::vector<TestRobot> available(const std::vector<TestRobot>& robots) {
  return available(robots, [](const TestRobot& robot) { return robot.name; });
}

inline std::vector<TestRobot> robots_on(Base base) {
  std::vector<TestRobot> robots = available({{"talos", base, "right_sole_link"},
                                             {"talos:right_arm", base, "tool"},
                                             {"arm7", base, "tool"},
                                             {"crane", base, "left_tip"}});
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

/// n entries, uniform in [-bound, bound].
inline Eigen::VectorXd random_vector(int n, double bound, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> draw(-bound, bound);
  Eigen::VectorXd x(n);
  for (double& entry : x) entry = draw(generator);
  return x;
}

}  // namespace burnish::test
