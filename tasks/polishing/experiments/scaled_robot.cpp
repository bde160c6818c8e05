#include "polishing/experiments/scaled_robot.hpp"

#include <cmath>

#include "base/sentence.hpp"

namespace burnish::polishing {

Robot scaled_robot(Robot robot, double mass) {
  Model& model = robot.model;
  if (!(mass > 0.0) || !std::isfinite(mass))
    throw Error("a robot of " + number(mass) + " kg; wanted a positive mass");
  for (const Joint& joint : model.joints)
    if (joint.kind != JointKind::Revolute && joint.kind != JointKind::Continuous)
      throw Error("robot " + in_quotes(model.name) + ": joint " + in_quotes(joint.name) +
                  " does not turn; only robots whose joints all turn are scaled");
  const double share = mass / model.total_mass(), length = std::cbrt(share);
  for (Joint& joint : model.joints) {
    joint.placement.translation() *= length;
    joint.com *= length;
    joint.mass *= share;
    joint.inertia_at_com *= share * length * length;
  }
  for (Frame& frame : model.frames) frame.placement.translation() *= length;
  // What is drawn would have to be scaled in its shapes too.
  model.visuals.clear();
  model.armature *= share * length * length;
  for (Eigen::VectorXd* torque :
       {&model.effort_limit, &model.friction, &model.damping, &model.stiffness})
    *torque *= share * length;
  model.name += " of " + number(mass) + " kg";
  return robot;
}

}  // namespace burnish::polishing
