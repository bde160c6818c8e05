#include "polishing/experiments/scaled_robot.hpp"

#include <cmath>

#include "base/sentence.hpp"

namespace burnish::polishing {

Robot scaled_robot(Robot robot, double mass) {
  Model& model = robot.model;
  if (!(mass > 0.0) || !std::isfinite(mass))
    throw Error("mass is " + number(mass) + " kg; wanted a positive mass");
  for (const Joint& joint : model.joints)
    if (joint.kind != JointKind::Revolute && joint.kind != JointKind::Continuous)
      throw Error("robot " + in_quotes(model.name) + ": joint " + in_quotes(joint.name) +
                  " is not revolute; wanted a robot with revolute joints only, to scale it");
  const double ratio = mass / model.total_mass(), length = std::cbrt(ratio);
  for (Joint& joint : model.joints) {
    joint.placement.translation() *= length;
    joint.com *= length;
    joint.mass *= ratio;
    joint.inertia_at_com *= ratio * length * length;
  }
  for (Frame& frame : model.frames) frame.placement.translation() *= length;
  // Removes the visuals, because their shapes cannot be scaled.
  model.visuals.clear();
  model.armature *= ratio * length * length;
  for (Eigen::VectorXd* torque :
       {&model.effort_limit, &model.friction, &model.damping, &model.stiffness})
    *torque *= ratio * length;
  model.name += " of " + number(mass) + " kg";
  return robot;
}

}  // namespace burnish::polishing
