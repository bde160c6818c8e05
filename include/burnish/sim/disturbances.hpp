// All that makes a plant differ from what its controller believes, as one plain value. Nothing is
// switched on unless it is named; what is drawn at random comes from one seed.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "burnish/model/model.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish {

/// A force on the tool for a while.
struct Push {
  double start = 0.0;                                     ///< s
  double duration = 0.0;                                  ///< s
  Eigen::Vector3d force_world = Eigen::Vector3d::Zero();  ///< N, at the tip frame's origin
};

/// Zero, empty, false or "no value" is off. Joints are the entries of v; those of a floating base
/// have neither motors nor encoders and are spared.
struct Disturbances {
  std::uint64_t seed = 0;

  // From command to joint torque, in the order in which they act (class Actuation).
  double command_delay = 0.0;         ///< s, rounded to plant steps
  double torque_cutoff = 0.0;         ///< rad/s: dtau/dt = cutoff (command - tau); 0: at once
  double torque_scale_range = 0.0;    ///< every joint gives 1 + r times its torque, |r| <= range
  Eigen::VectorXd torque_scale = {};  ///< nv factors in place of drawn ones, or empty
  double torque_bias_range = 0.0;     ///< Nm (N): every joint adds b, |b| <= range
  Eigen::VectorXd torque_bias = {};   ///< nv biases in place of drawn ones, or empty
  double torque_noise = 0.0;          ///< Nm (N), deviation, new at every plant step
  bool torque_limits = true;          ///< joints give no more than the model's effort_limit
  /// A torque loop closed around a torque sensor, ideal in its bandwidth: it takes away scale, bias
  /// and joint friction, and follows the sensor's noise instead.
  bool torque_loop = false;
  double torque_sensor_noise = 0.0;  ///< Nm (N), deviation

  // In the joints of the plant.
  double joint_coulomb = 0.0;  ///< Nm (N)
  double joint_viscous = 0.0;  ///< Nms/rad (Ns/m)

  // From plant to measurement (class Sensing).
  int encoder_bits = 0;                     ///< per turn, of revolute and continuous joints
  double position_noise = 0.0;              ///< rad (m), deviation, before the encoder rounds
  double velocity_noise = 0.0;              ///< rad/s (m/s), deviation
  bool finite_difference_velocity = false;  ///< from measured positions, in place of the true ones
  double velocity_cutoff = 0.0;             ///< rad/s, low-pass on the differences; 0: none
  double force_noise = 0.0;                 ///< N, deviation per axis
  double force_cutoff = 0.0;                ///< rad/s, low-pass behind the noise; 0: none

  // In the plant's model and scene (plant_model() and plant_scene()).
  double mass_scale = 1.0;  ///< of all masses and inertias
  /// Degrees by which the surface is turned about its own two tangents, first and second, through
  /// its point: about the first tangent after the second.
  Eigen::Vector2d surface_tilt_deg = Eigen::Vector2d::Zero();
  double surface_height = 0.0;                  ///< m, along the normal before the tilt
  std::optional<double> surface_friction = {};  ///< in place of the scene's
  std::vector<Push> pushes = {};
};

/// Throws Error with a sentence that names the entry that is not finite, negative where it may not
/// be, or of the wrong size.
void check_disturbances(const Model& model, const Disturbances& disturbances);

/// The robot as it is, from the robot as the controller knows it: masses scaled, and joint friction
/// as the disturbances say. Without them the joints have none, whatever the model's description
/// states. Throws Error as check_disturbances() does.
Model plant_model(const Model& nominal, const Disturbances& disturbances);

/// The scene as it is, from the scene as the controller knows it. Throws Error for a bad normal or
/// friction.
SceneSpec plant_scene(const SceneSpec& nominal, const Disturbances& disturbances);

/// Sum of the pushes at a time, N, world axes.
Eigen::Vector3d push_at(const std::vector<Push>& pushes, double time) noexcept;

}  // namespace burnish
