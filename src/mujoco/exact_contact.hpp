// Contact of a sphere with an exact surface, for bodies that MuJoCo simulates.
#pragma once

#include "burnish/sim/scene.hpp"
#include "mujoco/mujoco_engine.hpp"
#include "sim/penalty_contact.hpp"

namespace burnish::mujoco {

/// Computes the contact force of a PenaltyContact and applies it to MuJoCo's bodies.
class ExactContact {
 public:
  ExactContact(const TouchSpec& touch, const TouchIds& ids, const mjModel& m);

  /// Adds the force of the surface to qfrc_applied, qfrc_smooth and qacc_smooth. The opposite force
  /// acts at the same point on the body that carries the surface. Must be called between
  /// mj_fwdAcceleration() and mj_fwdConstraint(). `time` is the start of the step [s]. `touched`
  /// tells whether there was a force in the previous step. Returns force [N] and moment [Nm] on the
  /// sphere about the origin of its frame, in world axes.
  Vector6 apply_force(const mjModel& m, mjData& d, double time, bool touched) noexcept;

 private:
  TouchSpec touch_;
  Surface surface_;
  PenaltyContact contact_;
  TouchIds ids_;
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> J_, J_surface_, J_by_M_;
};

}  // namespace burnish::mujoco
