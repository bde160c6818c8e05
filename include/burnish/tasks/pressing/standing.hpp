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
/// @described pressing
struct Standing {
  /// frames of the feet; auto: found in the description, with their sizes; none: the base is fixed
  /// @word auto
  std::vector<std::string> feet = {};
  /// [m], half the length of a sole along x of its frame, about its origin; 0: point feet, >= 0
  double half_x = 0.1;
  double half_y = 0.065;  ///< [m], half its width along y, >= 0
  double radius = 0.02;   ///< [m], of a point foot, > 0

  double friction = 0.7;  ///< Coulomb coefficient of the plant's ground, >= 0
  /// [N/m], of the plant's ground under each foot; auto: it yields by 0.23 mm under the weight,
  /// under point feet by 0.245 mm, > 0 @code N/m, of the plant's ground under each foot; none: it
  /// yields by 0.23 mm under the weight, under point feet by 0.245 mm @word auto
  std::optional<double> stiffness = std::nullopt;
  /// {Ns/m}, of the plant's ground under each foot; auto: 0.05 s times the stiffness, for point
  /// feet 0.02 s, > 0 @code Ns/m, of the plant's ground under each foot; none: 0.05 s times the
  /// stiffness, for point feet 0.02 s @word auto
  std::optional<double> damping = std::nullopt;

  double plan_friction = 0.5;  ///< friction coefficient that plans assume, > 0
  /// fraction of a sole's half sides within which plans keep the centre of pressure, 0 to 1
  double plan_sole = 0.95;
  /// [N], smallest load of each foot in plans; auto: 0.09 of the weight per foot, >= 0 @code N,
  /// smallest load of each foot in plans; none: 0.09 of the weight per foot @word auto
  std::optional<double> least_load = std::nullopt;
  double balance = 1e3;  ///< [1/m^2]: centre of mass to where it starts, >= 0
  double base = 100.0;   ///< [1/rad^2]: base to its orientation at the start, >= 0
  /// {per (kg m/s)^2 and (kg m^2/s)^2}: momentum about the centre of mass, >= 0
  double momentum = 1e-2;
  /// [1/N^2], on tangential forces and yaw moments of each foot, >= 0 @more It discourages internal
  /// forces between the feet.
  double rubbing = 1e-4;
  double contact_kd = 20.0;  ///< [1/s], damping of the feet's constraint (Baumgarte), >= 0

  /// the base is estimated from an inertial unit, the joints and the feet; false: its state is
  /// known @code the base is estimated from an inertial unit, the joints and the feet
  /// (BaseEstimator); false: its state is known
  bool estimate = true;
  std::string imu_frame = {};  ///< of that unit; empty: the base's body
  /// hold at first and after a fault, in place of the task's; light feet on compliant ground need a
  /// soft one
  Fallback fallback = {.stiffness = 100.0, .damping = 15.0, .give = 0.5};
  /// [s] at first, within settle, in which a hoist hands the weight over to the feet, >= 0
  double hoist = 0.5;
  SlipOptions slip = {};  ///< how plans treat a foot that slips
  /// time for which the posture is held at first, while the estimate of the base settles [s], >= 0
  double settle = 1.0;
  bool force_sensors = true;  ///< in the feet, of forces and moments
  /// time for which a run continues after a fault, to show whether the robot falls [s], >= 0 @more
  /// The task's figures end at the fault.
  double after_fault = 2.0;

  bool stands() const { return !feet.empty(); }
  bool has_soles() const { return half_x > 0.0 && half_y > 0.0; }
};

}  // namespace burnish
