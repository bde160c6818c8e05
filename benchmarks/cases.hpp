// Cases of the benchmarks: robots, contacts, references, and states.
#pragma once

#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"

namespace burnish::bench {

/// Robot with one kind of contact.
struct Case {
  std::string robot;    ///< Name of the robot for load_robot().
  std::string label;    ///< Name of the robot in names of benchmarks.
  std::string contact;  ///< Kind of contact: "1D", "3D", "6D" or "2x6D".
  std::vector<std::string> tools;
  Directions directions;

  std::vector<ContactSpec> specs(const std::string& reference) const;
};

const std::vector<Case>& cases();
/// Returns "local", "centered", "surface" and "world". The surface is tilted, so that no axis is
/// special.
const std::vector<std::string>& references();

/// Returns the model of a robot, loaded once. Throws Error as load_robot().
const Model& model_of(const std::string& robot);

/// Different states, one per column, so that no evaluation repeats the previous one.
struct States {
  Eigen::MatrixXd q, v, tau;  ///< Matrices with nq, nv and nv rows.
};

/// Returns random states within 0.3 rad (m) of the reference posture, with |v| <= 1 rad/s (m/s) and
/// |tau| <= 10 Nm (N). Every run draws the same random numbers.
States states_near_reference(const std::string& robot, int count);

}  // namespace burnish::bench
