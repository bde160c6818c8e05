// Units in which the values of a robot of any size and mass are of order one. Steps of differences,
// random states and comparisons of blocks use these units.
#pragma once

#include <Eigen/Core>

#include "burnish/contact/contact_set.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Units per entry of v and per row of the contacts. The unit of angles is 1 rad, the unit of
/// lengths is the robot's length, and the unit of forces is the robot's weight.
struct CheckUnits {
  explicit CheckUnits(const Model& model, const ContactSet& set = {});

  double length;              ///< Power of ten nearest to robot_size() [m]
  double force;               ///< Weight of the robot, on Earth if the model has no gravity [N]
  Eigen::VectorXd motion;     ///< Units of q, v and a (nv) [rad, m]
  Eigen::VectorXd torque;     ///< Units of tau (nv) [N m, N]
  Eigen::VectorXd row;        ///< Units of alpha (rows) [rad, m]
  Eigen::VectorXd row_force;  ///< Units of lambda (rows) [N m, N]
};

}  // namespace burnish
