// Contact of the tip with an exact surface, for bodies that MuJoCo simulates.
#pragma once

#include "burnish/sim/scene.hpp"
#include "mujoco/mujoco_description.hpp"
#include "sim/penalty_contact.hpp"

namespace burnish::mujoco {

/// Computes the contact force of a PenaltyContact and applies it to MuJoCo's bodies.
class ExactContact {
 public:
  /// `surface_site` is the site of the frame that carries the surface; -1: the surface is in the
  /// world.
  ExactContact(const SceneSpec& scene, const mjModel& m, int tip_site, int tip_body,
               int surface_site);

  /// Adds the force of the surface to qfrc_applied, qfrc_smooth and qacc_smooth. The opposite force
  /// acts at the same point on the body that carries the surface. Must be called between
  /// mj_fwdAcceleration() and mj_fwdConstraint(). `time` is the start of the step [s]. `touched`
  /// tells whether there was a force in the previous step. Returns the force on the tip, in world
  /// axes [N].
  Eigen::Vector3d apply_force(const mjModel& m, mjData& d, double time, bool touched) noexcept;

 private:
  SceneSpec scene_;
  Surface surface_;
  PenaltyContact contact_;
  int site_, body_, surface_site_;
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> J_, J_surface_, J_by_M_;
};

}  // namespace burnish::mujoco
