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
  /// m, half the side of a sole along x of its frame, about its origin; 0: a ball
  double half_x = 0.1;
  double half_y = 0.065;  ///< m, along y
  double radius = 0.02;   ///< m, of a foot that is a ball

  double friction = 0.7;  ///< Coulomb coefficient of the plant's ground
  /// N/m, of the plant's ground under each foot; none: 0.23 mm of way under the weight, of
  /// balls 0.245 mm
  std::optional<double> stiffness = std::nullopt;
  /// Ns/m, of the plant's ground under each foot; none: 0.05 s of the stiffness, of balls 0.02 s
  std::optional<double> damping = std::nullopt;

  double plan_friction = 0.5;  ///< coefficient that plans keep within
  /// of half a sole's sides, that plans keep the centre of pressure within; 0 to 1
  double plan_sole = 0.95;
  /// N that plans keep on each foot; none: 0.09 of the weight that a foot bears when all bear alike
  std::optional<double> least_load = std::nullopt;
  double balance = 1e3;    ///< 1/m^2: centre of mass to where it starts
  double base = 100.0;     ///< 1/rad^2: base to its orientation at the start
  double momentum = 1e-2;  ///< per (kg m/s)^2 and (kg m^2/s)^2: momentum about the centre of mass
  /// 1/N^2: what each foot bears along the ground, and about its normal as forces at a sole's ends;
  /// what feet do against each other costs grip and holds nothing
  double rubbing = 1e-4;
  double contact_kd = 20.0;  ///< 1/s, damping of the feet's constraint (Baumgarte)

  /// the base is told from an inertial unit, the joints and the feet (BaseEstimator); false: known
  bool estimate = true;
  std::string imu_frame = {};  ///< of that unit; empty: the base's body
  /// how it is held at first and after a fault, in the place of the task's: a light foot on ground
  /// that gives way bears no stiffer one
  Fallback fallback = {.stiffness = 100.0, .damping = 15.0, .give = 0.5};
  /// s at first, within settle, in which a hoist that holds its base gives the weight to its feet
  double hoist = 0.5;
  SlipOptions slip = {};  ///< what plans make of a foot that slips
  double settle = 1.0;    ///< s that it is held at first, while the estimate of the base settles
  bool force_sensors = true;  ///< in the feet, of forces and moments
  /// s that a run goes on after a fault, to see what becomes of the robot; what the task's figures
  /// are about ends with the fault
  double after_fault = 2.0;

  bool stands() const { return !feet.empty(); }
  bool has_soles() const { return half_x > 0.0 && half_y > 0.0; }
};

}  // namespace burnish
