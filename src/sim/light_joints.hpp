// Joints so light that noise in their torque alone drives them past their speed limits: the rotors
// of their motors are missing in the description.
#pragma once

#include <string>
#include <vector>

#include "burnish/base/views.hpp"
#include "burnish/model/model.hpp"
#include "burnish/sim/disturbances.hpp"

namespace burnish {

/// One of them. Units are those of a revolute joint.
struct LightJoint {
  std::string joint;
  int v = 0;             ///< its entry of v
  double inertia = 0.0;  ///< that its motor moves, the other joints free [kg m^2]
  double noise = 0.0;    ///< deviation of its torque noise [Nm]
  double speed = 0.0;    ///< that the noise drives it to before any control acts [rad/s]
  double limit = 0.0;    ///< largest speed allowed [rad/s]
  double armature =
      0.0;  ///< of a usual rotor; infinite where effort or speed is unlimited [kg m^2]
};

/// How a run is watched.
struct LightJointOptions {
  double plant_step = 5e-4;        ///< s between two draws of the noise
  double control_period = 5e-4;    ///< s between two commands
  double joint_speed_ratio = 1.2;  ///< of the velocity limits, that a run tolerates
};

/// The light joints of a model at q, in the order of v. Torque noise of deviation s, drawn every
/// plant step h, changes the speed of a joint of inertia I by s sqrt(h T) / I until a command can
/// answer, T later: the command's delay, the lag of the filter of velocities and a control period.
/// A joint is light where 6.4 times that deviation exceed what is allowed. Joints without a motor
/// and those without a speed limit are left out.
std::vector<LightJoint> light_joints(const Model& model, const ConstVectorRef& q,
                                     const Disturbances& disturbances,
                                     const LightJointOptions& options);

/// "joint 'wrist' moves 3e-05 kg m^2: ... ", what it is, why it matters and lines for robot.yaml.
std::string light_joints_text(const std::vector<LightJoint>& joints);

}  // namespace burnish
