// What is measured: robots, contacts, references, and a ring of states for each.
#pragma once

#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"

namespace burnish::bench {

/// A robot with one kind of contact.
struct Case {
  std::string robot;    ///< as load_robot takes it
  std::string label;    ///< the robot in the benchmark's name
  std::string contact;  ///< "1D", "3D", "6D" or "2x6D"
  std::vector<std::string> tools;
  Directions directions;

  std::vector<ContactSpec> specs(const std::string& reference) const;
};

const std::vector<Case>& cases();
/// "local", "centered", "surface", "world"; the surface is tilted, so that no axis is special.
const std::vector<std::string>& references();

/// The robot's model, loaded once. Throws Error as load_robot does.
const Model& model_of(const std::string& robot);

/// One state per column, so that no evaluation repeats the one before it.
struct States {
  Eigen::MatrixXd q, v, tau;  ///< nq, nv, nv rows
};

/// Within 0.3 rad (m) of the reference posture, |v| <= 1 rad/s (m/s), |tau| <= 10 Nm (N); the same
/// numbers in every run.
States states_near_reference(const std::string& robot, int count);

}  // namespace burnish::bench
