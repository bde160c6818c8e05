// Standing of a robot with a floating base: feet, ground, and the limits and weights of its plans.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "burnish/mpc/mpc.hpp"

namespace burnish {

/// Feet on level ground, where they are in the starting posture. Plans hold them still within the
/// friction and the pressure that these bear; the plant's ground can only push and rub.
struct Standing {
  /// frames of the feet; auto: found in the description, with their sizes; none: the base is fixed
  std::vector<std::string> feet = {};
  /// m, half the length of a sole along x of its frame, about its origin; 0: point feet
  double half_x = 0.1;
  double half_y = 0.065;  ///< m, half its width along y
  double radius = 0.02;   ///< m, of a point foot

  double friction = 0.7;  ///< Coulomb coefficient of the plant's ground
  /// N/m, of the plant's ground under each foot; none: it yields by 0.23 mm under the weight, under
  /// point feet by 0.245 mm
  std::optional<double> stiffness = std::nullopt;
  /// Ns/m, of the plant's ground under each foot; none: 0.05 s times the stiffness, for point feet
  /// 0.02 s
  std::optional<double> damping = std::nullopt;

  double plan_friction = 0.5;  ///< friction coefficient that plans assume
  /// fraction of a sole's half sides within which plans keep the centre of pressure
  double plan_sole = 0.95;
  /// N, smallest load of each foot in plans; none: 0.09 of the weight per foot
  std::optional<double> least_load = std::nullopt;
  double balance = 1e3;    ///< 1/m^2: centre of mass to where it starts
  double base = 100.0;     ///< 1/rad^2: base to its orientation at the start
  double momentum = 1e-2;  ///< per (kg m/s)^2 and (kg m^2/s)^2: momentum about the centre of mass
  /// 1/N^2, on tangential forces and yaw moments of each foot. It discourages internal forces
  /// between the feet.
  double rubbing = 1e-4;
  double contact_kd = 20.0;  ///< 1/s, damping of the feet's constraint (Baumgarte)

  /// the base is estimated from an inertial unit, the joints and the feet (BaseEstimator); false:
  /// its state is known
  bool estimate = true;
  std::string imu_frame = {};  ///< of that unit; empty: the base's body
  /// how it is held at first and after a fault, in the place of the task's: a light foot on ground
  /// that gives way bears no stiffer one
  Fallback fallback = {.stiffness = 100.0, .damping = 15.0, .give = 0.5};
  /// s at first, within settle, in which a hoist hands the weight over to the feet
  double hoist = 0.5;
  SlipOptions slip = {};  ///< what plans make of a foot that slips
  /// time for which the posture is held at first, while the estimate of the base settles [s]
  double settle = 1.0;
  bool force_sensors = true;  ///< in the feet, of forces and moments
  /// time for which a run continues after a fault, to show whether the robot falls [s]. The task's
  /// figures end at the fault.
  double after_fault = 2.0;

  bool stands() const { return !feet.empty(); }
  bool has_soles() const { return half_x > 0.0 && half_y > 0.0; }
};

}  // namespace burnish
