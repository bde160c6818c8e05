// Access to the rows of a trace: states of the robot, and forces on its feet.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "burnish/base/trace.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish {

/// States of the robot in the rows of a trace of ClosedLoop.
class StateRows {
 public:
  /// Throws Error for a missing column.
  StateRows(const Trace& trace, const Model& model);
  /// Sets body() to the state of a row. Returns the status of RigidBody::update().
  [[nodiscard]] Status look(int row);
  const RigidBody& body() const { return body_; }

 private:
  const Trace* trace_;
  std::vector<int> q_columns_, v_columns_;
  Eigen::VectorXd q_, v_;
  RigidBody body_;
};

/// Minimum normal force for a friction ratio and a centre of pressure [N]. With a smaller force,
/// the ratio and the centre are ill-defined. Chosen by hand.
constexpr double min_pressure_load = 20.0;

/// Load of a foot, from the wrench in a trace.
struct FootLoad {
  double normal = 0.0;      ///< Force along the ground's normal [N]
  double tangential = 0.0;  ///< Force perpendicular to the ground's normal [N]
  /// Centre of pressure in the plane of the sole: x and y in the foot's frame [m]. Zero for point
  /// feet, and without a force.
  Eigen::Vector2d pressure = Eigen::Vector2d::Zero();
};

/// Loads of one support in the rows of a trace.
class FootRows {
 public:
  /// Throws Error for a missing column, an unknown frame or a normal of length zero.
  FootRows(const Trace& trace, const RigidBody& body, const TouchSpec& support);
  const TouchSpec& support() const { return support_; }
  const Eigen::Vector3d& normal() const {
    return support_.surface.normal;
  }  ///< Unit normal of the ground, in world axes
  /// Returns the load in a row, for the placement `foot` of the foot's frame in the world.
  FootLoad load(int row, const Eigen::Isometry3d& foot) const;
  Eigen::Isometry3d placement(const RigidBody& body) const { return body.placement(frame_); }
  /// Returns the corners of a sole, or the centre of a point foot, in the world [m].
  std::vector<Eigen::Vector3d> points(const Eigen::Isometry3d& foot) const;
  /// Returns the friction ratio |f_t| / (mu f_n) of a foot with a normal force.
  double friction_used(const FootLoad& load) const;
  /// Returns the distance of the centre of pressure from the edge of the sole [m]; negative:
  /// outside the sole.
  double margin(const FootLoad& load) const;

 private:
  const Trace* trace_;
  TouchSpec support_;
  int frame_;
  std::array<int, 6> columns_;
};

}  // namespace burnish
