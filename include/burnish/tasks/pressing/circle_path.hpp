// What a polishing tool is asked to do, over time.
#pragma once

#include <Eigen/Core>

namespace burnish {

/// Where the tip frame's origin shall be and how hard the surface shall push back.
struct TaskPoint {
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector3d v_world = Eigen::Vector3d::Zero();  ///< m/s
  Eigen::Vector3d a_world = Eigen::Vector3d::Zero();  ///< m/s^2
  double force = 0.0;                                 ///< N, along the surface's normal
};

/// A circle in a plane. It starts at the centre, at rest, and its radius grows smoothly.
struct CirclePath {
  Eigen::Vector3d center_world = Eigen::Vector3d::Zero();   ///< m
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();  ///< of the plane, any length but zero
  double radius = 0.07;                                     ///< m
  double rate = 1.0;                                        ///< rad/s, about the normal
  double start_up = 2.0;  ///< s until the radius is reached; positive
  double force = 30.0;    ///< N

  /// At t s from the start; before it, the start.
  TaskPoint at(double t) const noexcept;
};

}  // namespace burnish
