// Settings for a robot with a floating base that stands on its feet: feet, ground, and limits and
// weights of plans.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "burnish/mpc/mpc_spec.hpp"

namespace burnish {

/// Feet on level ground, at their positions in the starting posture. Plans keep the feet still, and
/// limit the tangential force and the centre of pressure of each foot. The plant's ground can push
/// a foot but not pull it, and has friction.
/// @described pressing
struct Standing {
  /// Frames of the feet (`auto`: found in the robot's description; empty: the base is fixed)
  /// @more With `auto`, the sizes of the feet also come from the description.
  /// @word auto
  std::vector<std::string> feet = {};
  /// Half the length of a planar foot along x of its frame (0: point feet) [m], >= 0
  /// @more The origin of the frame is the middle of the foot's sole.
  double half_x = 0.1;
  /// Half the width of a planar foot along y of its frame (0: point feet) [m], >= 0
  double half_y = 0.065;
  double radius = 0.02;  ///< Radius of a point foot [m], > 0

  double friction = 0.7;  ///< Coulomb friction coefficient of the plant's ground, >= 0
  /// Stiffness of the ground under each foot in the plant (automatic: from the weight) [N/m], > 0
  /// @more With the automatic stiffness, the ground yields by 0.23 mm under the robot's weight
  /// (0.245 mm with point feet).
  /// @word auto
  std::optional<double> stiffness = std::nullopt;
  /// Damping of the ground under each foot in the plant (automatic: from the stiffness) [Ns/m], > 0
  /// @more The automatic damping is the stiffness times 0.05 s (0.02 s with point feet).
  /// @word auto
  std::optional<double> damping = std::nullopt;

  double plan_friction = 0.5;  ///< Friction coefficient of the ground that plans assume, > 0
  /// Largest offset of the centre of pressure in plans, divided by the sole's half sides, 0 to 1
  double plan_sole = 0.95;
  /// Smallest load of each foot in plans (automatic: 0.09 times the feet's mean load) [N], >= 0
  /// @word auto
  std::optional<double> min_load = std::nullopt;
  /// Weight on the distance of the centre of mass from its target [1/m^2], >= 0
  /// @more The target is the position at the start, unless the task moves the target.
  double balance = 1e3;
  /// Weight on the rotation of the base from its target [1/rad^2], >= 0
  /// @more The target is the orientation at the start, unless the task moves the target.
  double base = 100.0;
  /// Weight on linear and angular centroidal momentum {per (kg m/s)^2 and (kg m^2/s)^2}, >= 0
  double momentum = 1e-2;
  /// Weight on tangential forces and yaw moments of each foot [1/N^2], >= 0
  /// @more This weight discourages internal forces between the feet.
  double internal_forces = 1e-4;
  /// Damping of the contact constraint of the feet (Baumgarte) [1/s], >= 0
  double contact_kd = 20.0;

  /// Estimate the base's state from an inertial unit, joints and feet; false: measure it directly
  /// @note BaseEstimator estimates the base.
  bool estimate = true;
  std::string imu_frame = {};  ///< Frame of the inertial unit; empty: the body of the base
  /// Gains that hold the robot at the start and after a fault
  /// @more These gains replace the fallback gains of the task. Light feet on compliant ground need
  /// low gains.
  Fallback fallback = {.stiffness = 100.0, .damping = 15.0, .saturation_fraction = 0.5};
  /// Time at the start in which a hoist transfers the weight to the feet [s], >= 0
  /// @more A time longer than `settle` is shortened to `settle`.
  double hoist = 0.5;
  SlipOptions slip = {};  ///< Reaction of plans to a slipping foot
  /// Time for which the posture is held at the start [s], >= 0
  /// @more The estimate of the base settles in this time.
  double settle = 1.0;
  bool force_sensors = true;  ///< Whether the feet have sensors of force and moment
  /// Time for which a run continues after a fault [s], >= 0
  /// @more The continued run shows whether the robot falls. The statistics of the task end at the
  /// fault.
  double after_fault = 2.0;

  bool stands() const { return !feet.empty(); }
  bool has_soles() const { return half_x > 0.0 && half_y > 0.0; }
};

}  // namespace burnish
