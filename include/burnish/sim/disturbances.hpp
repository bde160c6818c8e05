// All differences between a simulated plant and the controller's model of the plant, in one struct.
// Random values are drawn from one seed.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "burnish/model/inertia.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish {

/// A force on the tool, or on another frame of the robot, for a limited time.
/// @described sim
struct Push {
  /// Time at which the force starts [s]
  double start = 0.0;
  /// Duration of the force [s], >= 0
  double duration = 0.0;
  /// Force in world axes, at the frame's origin [N] @key force
  Eigen::Vector3d force_world = Eigen::Vector3d::Zero();
  /// Frame that the force acts on (`tip` or empty: the frame of the first tool)
  /// @more If the robot has no tool, ClosedLoop refuses an empty frame, and tasks use the floating
  /// base instead.
  /// @word tip
  std::string frame = {};
};

/// A motor failure for a limited time: the motor produces only a fraction of its torque, or no
/// torque. The torque sensor measures the reduced torque.
/// @described sim
struct MotorLoss {
  /// Time at which the failure starts [s]
  double start = 0.0;
  /// Duration of the motor failure [s], >= 0 or infinite @word forever
  double duration = std::numeric_limits<double>::infinity();
  std::string joint = {};  ///< Name of the joint @more All of the joint's entries of v are affected
  double share = 0.0;      ///< Fraction of the torque that is left, 0 to 1
};

/// A payload that the plant carries and the controller's model lacks: a solid ball, fixed to a
/// frame of the robot.
/// @described sim
struct UnknownPayload {
  /// Frame that the ball is fixed to
  std::string frame = "tool";
  /// Mass of the ball [kg], >= 0
  double mass = 0.0;
  /// Centre of the ball, in the axes of `frame` [m]
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  /// Radius of the ball [m], >= 0
  double radius = 0.05;
  /// Largest random change of the mass [kg], >= 0
  /// @more A random r with |r| <= mass_range is added to the mass. A negative sum counts as zero
  double mass_range = 0.0;
  /// Largest random change of each coordinate of the centre [m], >= 0
  /// @more A random r with |r| <= com_range is added to each coordinate
  double com_range = 0.0;
};

/// A fault of an inertial measurement unit, for a limited time.
/// @described sim
struct ImuFault {
  /// Time at which the fault starts [s]
  double start = 0.0;
  /// Duration of the fault [s], >= 0 or infinite @word forever
  double duration = std::numeric_limits<double>::infinity();
  /// Offset added to the gyroscope's reading, in the unit's axes [rad/s] @word none
  Eigen::Vector3d gyro_offset = Eigen::Vector3d::Zero();
  /// Offset added to the accelerometer's reading, in the unit's axes [m/s^2] @word none
  Eigen::Vector3d accelerometer_offset = Eigen::Vector3d::Zero();
  /// Whether the unit keeps repeating its last reading from before the fault @word no
  bool frozen = false;
  bool silent = false;  ///< Whether the unit gives no readings @word no
};

/// All differences between a plant and its controller's model, and all errors of sensors and
/// motors. A disturbance without a value is off. The values zero, empty and false also mean off.
/// Random values are drawn from the seed.
///
/// In the descriptions of the members, "joint" means one entry of v. A floating base has no motors
/// and no encoders. The base's entries of v therefore have no motor errors, no joint friction and
/// no encoder rounding. Units are given for revolute joints; for prismatic joints, replace rad by m
/// and Nm by N.
/// @described sim
struct Disturbances {
  std::uint64_t seed = 0;  ///< Seed of all random values

  // @group Disturbances between the command and the joint torque, in the order in which they act.

  /// Delay from the controller to the motors [s], >= 0
  /// @more The delay is rounded to whole plant steps
  double command_delay = 0.0;
  /// Cut-off of the motors' first-order lag (0: no lag) [rad/s], >= 0
  /// @more The torque follows dtau/dt = cutoff (command - tau)
  double torque_cutoff = 0.0;
  /// Largest random error of a joint's torque scale, >= 0
  /// @more Each joint's torque is multiplied by 1 + r, where r is random and |r| <=
  /// torque_scale_range
  double torque_scale_range = 0.0;
  /// Torque scale of each joint, nv entries (`none` or empty: random scales)
  /// @word none
  Eigen::VectorXd torque_scale = {};
  /// Largest random torque bias of a joint [Nm], >= 0
  /// @more A random constant b with |b| <= torque_bias_range is added to each joint's torque
  double torque_bias_range = 0.0;
  /// Torque bias of each joint, nv entries (`none` or empty: random biases) [Nm]
  /// @word none
  Eigen::VectorXd torque_bias = {};
  /// Standard deviation of the torque noise [Nm], >= 0
  /// @more The noise is drawn anew in every plant step
  double torque_noise = 0.0;
  /// Upper bound of torque_noise, as a fraction of the joint's effort limit (0: no bound), >= 0
  double torque_noise_share = 0.0;
  /// Whether joint torques are clipped to the robot's effort limits
  bool torque_limits = true;
  /// Whether a torque control loop cancels the effects of torque scale, torque bias and joint
  /// friction
  /// @more The control loop uses a torque sensor in each joint. Within its bandwidth the loop is
  /// ideal, but the noise of the sensor disturbs the torque
  bool torque_loop = false;
  /// Standard deviation of the torque sensors' noise [Nm], >= 0
  double torque_sensor_noise = 0.0;
  /// Motor failures, applied after the torque limits; in files: [{start: s, duration: s, joint:
  /// name, share: fraction of the torque that is left}, ...]
  std::vector<MotorLoss> motor_losses = {};

  // @group Friction in the joints of the plant.

  /// Coulomb friction of each joint [Nm], >= 0
  double joint_coulomb = 0.0;
  /// Viscous friction of each joint, in {Nms/rad}, >= 0
  double joint_viscous = 0.0;
  /// Upper bound of joint_coulomb, as a fraction of the joint's effort limit (0: no bound), >= 0
  /// @more If the bound reduces joint_coulomb, it reduces joint_viscous in the same ratio
  double joint_friction_share = 0.0;

  // @group Disturbances between the plant and the measurement.

  /// Delay of all measured values except the time [s], >= 0
  /// @more The delay is rounded to whole control periods
  double measurement_delay = 0.0;
  /// Resolution of a joint's encoder, in bits per turn (0: exact), 0 to 40
  /// @more Only revolute and continuous joints have an encoder resolution
  int encoder_bits = 0;
  /// Standard deviation of the position noise [rad], >= 0
  /// @more The noise is added before the encoder rounds the position
  double position_noise = 0.0;
  /// Standard deviation of the velocity noise [rad/s], >= 0
  double velocity_noise = 0.0;
  /// Whether measured velocities are finite differences of measured positions
  /// @more If false, the true velocities are measured
  bool finite_difference_velocity = false;
  /// Cut-off of the low-pass filter on finite-difference velocities (0: no filter) [rad/s], >= 0
  double velocity_cutoff = 0.0;
  /// Standard deviation of force noise in sensors that measure only the force, per axis [N], >= 0
  /// @more Tools have such sensors, unless the scene states other sensors. The axes are those of
  /// the frame at the sensor
  double force_noise = 0.0;
  /// Cut-off of the low-pass filter on measured forces and moments (0: no filter) [rad/s], >= 0
  /// @more Noise is added before the filter
  double force_cutoff = 0.0;
  /// Standard deviation of force noise in sensors of force and moment, per axis [N], >= 0
  /// @more The noise passes the low-pass filter with the cut-off force_cutoff
  double support_force_noise = 0.0;
  /// Standard deviation of moment noise in sensors of force and moment, per axis [Nm], >= 0
  /// @more The noise passes the low-pass filter with the cut-off force_cutoff
  double support_moment_noise = 0.0;

  // @group Errors of the inertial measurement unit, if there is one. Noise densities are defined as
  // in data sheets: if a reading is a mean over dt seconds, its noise has the standard deviation
  // density / sqrt(dt).

  /// Density of the gyroscope's white noise, per axis [rad/s/sqrt(Hz)], >= 0
  double gyro_noise = 0.0;
  /// Largest random initial bias of the gyroscope, per axis [rad/s], >= 0
  /// @more A random b with |b| <= gyro_bias_range is added to each axis
  double gyro_bias_range = 0.0;
  /// Density of the random walk of the gyroscope's bias [rad/s^2/sqrt(Hz)], >= 0
  double gyro_bias_walk = 0.0;
  /// Quantization step of the gyroscope (0: exact) [rad/s], >= 0
  double gyro_step = 0.0;
  /// Density of the accelerometer's white noise, per axis [m/s^2/sqrt(Hz)], >= 0
  double accelerometer_noise = 0.0;
  /// Largest random initial bias of the accelerometer, per axis [m/s^2], >= 0
  /// @more A random b with |b| <= accelerometer_bias_range is added to each axis
  double accelerometer_bias_range = 0.0;
  /// Density of the random walk of the accelerometer's bias [m/s^3/sqrt(Hz)], >= 0
  double accelerometer_bias_walk = 0.0;
  /// Quantization step of the accelerometer (0: exact) [m/s^2], >= 0
  double accelerometer_step = 0.0;
  /// Faults of the inertial measurement unit; in files: [{start: s, duration: s, gyro_offset: [x,
  /// y, z] in rad/s, accelerometer_offset: [x, y, z] in m/s^2, frozen: true, silent: true}, ...].
  /// Offsets are in the unit's axes. A key that is left out has no effect. A fault without a
  /// duration lasts forever
  std::vector<ImuFault> imu_faults = {};

  // @group Differences in the plant's model and scene, applied by plant_model() and plant_scene().

  /// Factor on all masses and inertias of the plant, > 0
  double mass_scale = 1.0;
  /// Payload that the plant carries and the controller's model lacks
  UnknownPayload payload = {};
  /// Tilt of the plant's surface about its two tangents [degrees], between -90 and 90
  /// @more The controller does not know the tilt. Both axes of rotation pass through the reference
  /// point of the surface. The rotation about the second tangent is applied first
  Eigen::Vector2d surface_tilt_deg = Eigen::Vector2d::Zero();
  /// Offset of the plant's surface along its normal [m]
  /// @more The offset is applied before the tilt
  double surface_height = 0.0;
  /// Factor on the curvature of the plant's surface, > 0
  /// @more Lengths of the surface's shape are divided by this factor
  double surface_curvature = 1.0;
  /// Shape of the plant's surface (`none`: as the controller assumes) @word none
  std::optional<SurfaceShape> surface_shape = {};
  /// Motion of the plant's surface along its normal
  SurfaceMotion surface_motion = {};
  /// Coulomb friction coefficient of the plant's surface (`none`: as the controller assumes), >= 0
  /// @word none
  std::optional<double> surface_friction = {};
  /// Slippery ground under the robot's supports; in files: [{start: s, duration: s, frame: foot,
  /// friction: coefficient}, ...]
  std::vector<SlipperyGround> slippery_ground = {};
  /// Forces on a frame (without a frame: on the tool, or on the base of a robot without a tool); in
  /// files: [{start: s, duration: s, force: [x, y, z] in N and world axes, frame: name}, ...]
  std::vector<Push> pushes = {};
};

/// Returns the names of the presets of disturbances:
/// - none: no disturbance.
/// - sensors: 17 bit encoders, velocities by finite differences, low-pass filters of 50 Hz on
///   velocities and forces, a command delay of 1 ms, and noise. Standard deviations of the noise:
///   0.3 N for the tool's force sensor, 1 N and 0.1 Nm for the supports' sensors, 0.05 Nm for the
///   motors. The motors' noise is at most 1/80 of a joint's effort limit. An inertial measurement
///   unit has noise and biases.
/// - mismatch: everything in `sensors`; also masses and inertias 5 % above the controller's model,
///   and a friction coefficient of the surface of 0.3.
/// - joint_friction: everything in `mismatch`; also 1 Nm of Coulomb and 1 Nms/rad of viscous joint
///   friction. Coulomb friction is at most 1/20 of a joint's effort limit. If this bound applies,
///   viscous friction is reduced in the same ratio.
const std::vector<std::string>& disturbance_presets();
/// Returns the preset called `name`, with seed 0. If there is no such preset, throws Error with the
/// nearest known name.
Disturbances disturbance_preset(const std::string& name);

/// Checks the disturbances. Throws Error if a disturbance
/// - is not finite, out of its range or of the wrong size,
/// - names a joint that the robot does not have.
///
/// The message names the member of Disturbances.
void check_disturbances(const Model& model, const Disturbances& disturbances);

/// Returns the payload that the plant carries, with mass and centre as drawn from the seed. If
/// nothing is carried, the payload's mass is zero.
Payload carried_payload(const Disturbances& disturbances);

/// Returns the plant's model. It is `nominal` (the controller's model) with three changes from
/// `disturbances`: scaled masses, a payload, and joint friction. This joint friction, even if zero,
/// replaces the friction of `nominal`. Throws Error for invalid disturbances (see
/// check_disturbances()), and if the robot does not have the payload's frame.
Model plant_model(const Model& nominal, const Disturbances& disturbances);

/// Returns the surface that a tool touches in the plant: `nominal`, changed by the disturbances
/// whose names begin with surface_. Throws Error for a normal that is zero or not finite.
SurfaceSpec plant_surface(const SurfaceSpec& nominal, const Disturbances& disturbances);

/// Returns the plant's scene: `nominal` (the scene that the controller assumes) with slippery
/// ground, and with the surfaces of plant_surface() for all tools. Surfaces of supports do not
/// change. Throws Error for a surface normal that is zero or not finite.
SceneSpec plant_scene(const SceneSpec& nominal, const Disturbances& disturbances);

}  // namespace burnish
