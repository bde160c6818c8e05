// The contact of the tip with an exact surface, on MuJoCo's bodies.
#pragma once

#include "burnish/sim/scene.hpp"
#include "mujoco/mujoco_description.hpp"
#include "sim/penalty_contact.hpp"

namespace burnish::mujoco {

class ExactContact {
 public:
  ExactContact(const SceneSpec& scene, const mjModel& m, int tip_site, int tip_body);

  /// Between mj_fwdAcceleration() and mj_fwdConstraint(): puts the force of the surface into
  /// qfrc_applied and qacc_smooth. `time`: of the step's begin, s. `touched`: whether it pushed in
  /// the step before. The force on the tip, N, world axes.
  Eigen::Vector3d push(const mjModel& m, mjData& d, double time, bool touched) noexcept;

 private:
  SceneSpec scene_;
  Surface surface_;
  PenaltyContact contact_;
  int site_, body_;
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> J_, J_by_M_;
};

}  // namespace burnish::mujoco
