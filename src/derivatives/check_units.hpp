// Units in which a robot of any size and mass has numbers of about one: what differences step by,
// what states are drawn in, and what entries of a block are compared in.
#pragma once

#include <Eigen/Core>

#include "burnish/contact/contact_set.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Per entry of v, and per row of the contacts: 1 where an angle is meant, the robot's length where
/// a length is; forces and torques in parts of its weight.
struct CheckUnits {
  explicit CheckUnits(const Model& model, const ContactSet& set = {});

  double length;              ///< m, power of ten nearest to the way to the furthest centre of mass
  double force;               ///< N: the weight, or that on Earth where the model has no gravity
  Eigen::VectorXd motion;     ///< nv, of q, v and a: rad or m
  Eigen::VectorXd torque;     ///< nv: Nm or N
  Eigen::VectorXd row;        ///< rows, of alpha: rad or m
  Eigen::VectorXd row_force;  ///< rows, of lambda: Nm or N
};

}  // namespace burnish
