// Light joints: joints so light that torque noise alone accelerates them beyond their speed limits.
// Usually their description lacks the inertia of the motors' rotors.
#pragma once

#include <string>
#include <vector>

#include "burnish/base/views.hpp"
#include "burnish/model/model.hpp"
#include "burnish/sim/disturbances.hpp"

namespace burnish {

/// Light joint. The units below apply to a revolute joint.
struct LightJoint {
  std::string joint;
  int v = 0;  ///< Index of the joint's velocity in the velocity vector
  /// Inertia about the joint axis, with the other joints free to move [kg m^2].
  double inertia = 0.0;
  double noise = 0.0;  ///< Standard deviation of the torque noise [Nm]
  double speed = 0.0;  ///< Speed that the noise causes before control can react [rad/s]
  double limit = 0.0;  ///< Largest allowed speed [rad/s]
  /// Armature of a typical rotor; infinite if the effort is unlimited [kg m^2]
  double armature = 0.0;
};

/// Properties of a run that determine which joints are light.
struct LightJointOptions {
  double plant_step = 5e-4;        ///< Time between two draws of the noise [s]
  double control_period = 5e-4;    ///< Time between two commands [s]
  double joint_speed_ratio = 1.2;  ///< Ratio of the largest allowed speed to the velocity limit
};

/// Returns the light joints of a model at the configuration q, in the order of v.
///
/// A command reacts to noise after the time T, which is the sum of the command delay, the lag of
/// the velocity filter and a control period. Until then, torque noise changes the speed of a joint
/// with the standard deviation s sqrt(h T) / I. Here s is the standard deviation of the noise, h
/// the plant step at which it is drawn, and I the inertia of the joint. A joint is light if 6.4 of
/// these deviations exceed its allowed speed. Joints without a motor or without a speed limit are
/// never light.
std::vector<LightJoint> light_joints(const Model& model, const ConstVectorRef& q,
                                     const Disturbances& disturbances,
                                     const LightJointOptions& options);

/// Returns a message about light joints with their inertias and speeds, the likely cause, and lines
/// for robot.yaml that would help.
std::string light_joints_text(const std::vector<LightJoint>& joints);

}  // namespace burnish
