// Upper bound of the distance that a frame can reach from the first joint.
#pragma once

#include <limits>

#include "burnish/model/model.hpp"

namespace burnish::ocp {

/// A sphere that contains the frame in every posture.
struct Reach {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< Centre of the sphere in the world [m]
  double distance = std::numeric_limits<double>::infinity();  ///< Radius of the sphere [m]
  std::string joint;  ///< Name of the first joint; empty: the frame cannot move
};

/// Returns the reach of a frame. The centre is the origin of the first joint. The radius is the sum
/// of the distances between consecutive joint origins and of the ranges of prismatic joints. The
/// radius is infinite after a free-flyer, a planar joint or a prismatic joint without limits. For a
/// frame without a joint, the centre is the frame's position and the radius is 0.
Reach reach_of(const Model& model, const std::string& frame);

}  // namespace burnish::ocp
