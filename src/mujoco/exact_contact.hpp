// The contact of the tip with an exact surface, on MuJoCo's bodies.
#pragma once

#include "burnish/sim/scene.hpp"
#include "mujoco/mujoco_description.hpp"
#include "sim/penalty_contact.hpp"

namespace burnish::mujoco {

class ExactContact {
 public:
  /// surface_site: of the frame that carries the surface; -1: none does.
  ExactContact(const SceneSpec& scene, const mjModel& m, int tip_site, int tip_body,
               int surface_site);

  /// Between mj_fwdAcceleration() and mj_fwdConstraint(): puts the force of the surface into
  /// qfrc_applied and qacc_smooth, with its opposite on what carries the surface, at the same
  /// point. `time`: of the step's begin, s. `touched`: whether it pushed in the step before. The
  /// force on the tip, N, world axes.
  Eigen::Vector3d push(const mjModel& m, mjData& d, double time, bool touched) noexcept;

 private:
  SceneSpec scene_;
  Surface surface_;
  PenaltyContact contact_;
  int site_, body_, surface_site_;
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> J_, J_surface_, J_by_M_;
};

}  // namespace burnish::mujoco
