// Robots of other sizes and masses, such as a toy or a crane.
#pragma once

#include "burnish/model/model.hpp"
#include "model/joint_entries.hpp"

namespace burnish::test {

/// Scales all lengths by `length` and all masses by `mass`; angles and gravity stay.
inline Model scaled(Model model, double length, double mass) {
  const double torque = mass * length;  // scale of torques of weights
  for (Joint& joint : model.joints) {
    joint.placement.translation() *= length;
    joint.mass *= mass;
    joint.com *= length;
    joint.inertia_at_com *= mass * length * length;
    const int sliding = sliding_entries(joint.kind);
    for (int k = 0; k < joint.nv; ++k) {
      const int v = joint.v_index + k;
      const bool slides = k < sliding;
      for (Eigen::VectorXd* of : {&model.armature, &model.damping, &model.friction})
        (*of)[v] *= slides ? mass : mass * length * length;
      model.effort_limit[v] *= slides ? mass : torque;
      if (slides) model.velocity_limit[v] *= length;
    }
    for (int k = 0; k < sliding; ++k) {
      const int q = joint.q_index + k;
      model.q_lower[q] *= length;
      model.q_upper[q] *= length;
      model.q_neutral[q] *= length;
    }
  }
  for (Frame& frame : model.frames) frame.placement.translation() *= length;
  return model;
}

}  // namespace burnish::test
