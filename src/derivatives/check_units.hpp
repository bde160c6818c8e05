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
  Eigen::VectorXd motion;     ///< Size of one unit of q, v and a, per entry of v [rad or m]
  Eigen::VectorXd torque;     ///< Size of one unit of tau, per entry of v [N m or N]
  Eigen::VectorXd row;        ///< Size of one unit of alpha, per row of the contacts [rad or m]
  Eigen::VectorXd row_force;  ///< Size of one unit of lambda, per row [N m or N]
};

}  // namespace burnish
