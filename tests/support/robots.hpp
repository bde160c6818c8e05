// The robots that the kernels are tested on, and random states of them.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "burnish/model/robot.hpp"
#include "burnish/model/state.hpp"

namespace burnish::test {

/// A robot that comes with the repository, bolted down or floating, and a frame at its end.
struct TestRobot {
  std::string name;
  Base base;
  std::string tool;

  Model model() const {
    RobotOverrides overrides;
    overrides.base = base;
    return load_robot(std::string(BURNISH_ROBOTS_DIR) + "/" + name, overrides).model;
  }
  /// A name that a test case may have.
  std::string label() const {
    std::string text = name + (base == Base::Fixed ? "_fixed" : "_floating");
    for (char& c : text)
      if (c == ':') c = '_';
    return text;
  }
};

inline std::vector<TestRobot> robots_on(Base base) {
  return {{"talos", base, "right_sole_link"},
          {"talos:right_arm", base, "tool"},
          {"arm7", base, "tool"},
          {"crane", base, "left_tip"}};
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
