// How far from where it begins a frame can get, from above.
#pragma once

#include <limits>

#include "burnish/model/model.hpp"

namespace burnish::ocp {

struct Reach {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of the first joint, in the world, m
  double distance = std::numeric_limits<double>::infinity();  ///< m
  std::string joint;                                          ///< the first one; empty: none
};

/// Sum of the distances between origins of consecutive joints from the frame back to the first
/// joint, and of the ranges of prismatic joints: no posture brings the frame further from there.
/// Infinite where a joint flies, drives in the plane or slides without limit. A frame that nothing
/// moves is where it is.
Reach reach_of(const Model& model, const std::string& frame);

}  // namespace burnish::ocp
