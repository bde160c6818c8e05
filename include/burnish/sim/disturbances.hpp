// All that makes a plant differ from what its controller believes, as one plain value. Nothing is
// switched on unless it is named; what is drawn at random comes from one seed.
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

/// A force on the tool, or on another frame of the robot, for a while.
/// @described sim
struct Push {
  double start = 0.0;     ///< [s]
  double duration = 0.0;  ///< [s], >= 0
  /// [N], world axes, at the frame's origin @key force
  Eigen::Vector3d force_world = Eigen::Vector3d::Zero();
  /// that it acts at; tip: the tip's @code that it acts at; empty: the tip's @word tip
  std::string frame = {};
};

/// A motor that gives a part of what it is told, or nothing, for a while. Its torque sensor shows
/// what it gives.
/// @described sim
struct MotorLoss {
  double start = 0.0;  ///< [s]
  /// [s], >= 0 or infinite @word forever
  double duration = std::numeric_limits<double>::infinity();
  std::string joint = {};  ///< by its name; all its entries
  double share = 0.0;      ///< of its torque that it gives, 0 to 1
};

/// What a plant carries at one of its frames and its controller does not know: a ball.
/// @described sim
struct UnknownPayload {
  std::string frame = "tool";                     ///< that it is fixed to
  double mass = 0.0;                              ///< [kg], >= 0
  Eigen::Vector3d com = Eigen::Vector3d::Zero();  ///< [m], its centre, in the frame's axes
  double radius = 0.05;                           ///< [m], >= 0
  /// [kg]: it weighs mass + r, |r| <= this, and not less than nothing, >= 0
  double mass_range = 0.0;
  double com_range = 0.0;  ///< [m]: each entry of its centre is com + r, |r| <= this, >= 0
};

/// An inertial measurement unit that goes wrong for a while.
/// @described sim
struct ImuFault {
  double start = 0.0;  ///< [s]
  /// [s]; infinite: for good, >= 0 or infinite @word forever
  double duration = std::numeric_limits<double>::infinity();
  /// [rad/s], added to what the gyroscope reads, the unit's axes @word none
  Eigen::Vector3d gyro_offset = Eigen::Vector3d::Zero();
  /// [m/s^2], added to what the accelerometer reads, the unit's axes @word none
  Eigen::Vector3d accelerometer_offset = Eigen::Vector3d::Zero();
  bool frozen = false;  ///< it repeats the last reading before @word no
  bool silent = false;  ///< there are no readings @word no
};

/// All that makes a plant differ from what its controller believes. Nothing is switched on unless
/// it is named: zero, empty, false or "no value" is off. What is drawn at random comes from the
/// seed. Joints are the entries of v; those of a floating base have neither motors nor encoders and
/// are spared. Units are those of revolute joints; prismatic ones have m and N in place of rad and
/// Nm.
/// @described sim
struct Disturbances {
  std::uint64_t seed = 0;  ///< of everything that is drawn at random

  // @group From command to joint torque, in the order in which they act.
  /// [s] from the controller to the motors, >= 0 @more rounded to plant steps
  double command_delay = 0.0;
  /// [rad/s], first-order lag of the motors; 0: none, >= 0 @more dtau/dt = cutoff (command - tau)
  double torque_cutoff = 0.0;
  double torque_scale_range = 0.0;  ///< each joint gives 1 + r times its torque, |r| <= this, >= 0
  /// factors per joint in place of drawn ones, or none @code nv factors in place of drawn ones, or
  /// empty @word none
  Eigen::VectorXd torque_scale = {};
  double torque_bias_range = 0.0;  ///< [Nm]: each joint adds b, |b| <= this, >= 0
  /// [Nm] per joint in place of drawn ones, or none @code nv, Nm (N), in place of drawn ones, or
  /// empty @word none
  Eigen::VectorXd torque_bias = {};
  double torque_noise = 0.0;  ///< [Nm], deviation, >= 0 @more new at every plant step
  /// of a joint's effort limit that this noise is at most; 0: any, >= 0
  double torque_noise_share = 0.0;
  bool torque_limits = true;  ///< joints give no more than the robot's effort limits
  /// a loop around a torque sensor takes away scale, bias and joint friction @more ideal in its
  /// bandwidth; it follows the sensor's noise instead
  bool torque_loop = false;
  double torque_sensor_noise = 0.0;  ///< [Nm], deviation, >= 0
  /// motors that fail, behind all that: [{start: s, duration: s, joint: name, share: 0 to 1 of its
  /// torque}, ...] @code motors that fail, behind all that
  std::vector<MotorLoss> motor_losses = {};

  // @group In the joints of the plant.
  double joint_coulomb = 0.0;  ///< [Nm], joint friction, >= 0
  double joint_viscous = 0.0;  ///< {Nms/rad}, joint friction, >= 0
  /// of a joint's effort limit that joint_coulomb is at most, joint_viscous in proportion; 0: any,
  /// >= 0
  double joint_friction_share = 0.0;

  // @group From plant to measurement.
  /// [s] from the plant to the controller, of all that is measured but its time, >= 0 @more rounded
  /// to ticks
  double measurement_delay = 0.0;
  int encoder_bits = 0;  ///< per turn; 0: exact, 0 to 40 @more of revolute and continuous joints
  double position_noise = 0.0;  ///< [rad], deviation, before the encoder rounds, >= 0
  double velocity_noise = 0.0;  ///< [rad/s], deviation, >= 0
  /// velocities from measured positions @more in place of the true ones
  bool finite_difference_velocity = false;
  double velocity_cutoff = 0.0;       ///< [rad/s], low-pass on those; 0: none, >= 0
  double force_noise = 0.0;           ///< [N], deviation per axis of the force sensor, >= 0
  double force_cutoff = 0.0;          ///< [rad/s], low-pass behind the noise; 0: none, >= 0
  double support_force_noise = 0.0;   ///< [N], deviation per axis of the sensors in supports, >= 0
  double support_moment_noise = 0.0;  ///< [Nm], likewise; both behind force_cutoff, >= 0

  // @group Of an inertial measurement unit, where there is one. Densities are those of data sheets:
  // a reading every dt s has a deviation of the density / sqrt(dt).
  double gyro_noise = 0.0;                ///< [rad/s/sqrt(Hz)], white, per axis, >= 0
  double gyro_bias_range = 0.0;           ///< [rad/s]: each axis adds b, |b| <= this, >= 0
  double gyro_bias_walk = 0.0;            ///< [rad/s^2/sqrt(Hz)] that b walks with, >= 0
  double gyro_step = 0.0;                 ///< [rad/s], of its converter; 0: exact, >= 0
  double accelerometer_noise = 0.0;       ///< [m/s^2/sqrt(Hz)], white, per axis, >= 0
  double accelerometer_bias_range = 0.0;  ///< [m/s^2]: each axis adds b, |b| <= this, >= 0
  double accelerometer_bias_walk = 0.0;   ///< [m/s^3/sqrt(Hz)] that b walks with, >= 0
  double accelerometer_step = 0.0;        ///< [m/s^2], of its converter; 0: exact, >= 0
  /// [{start: s, duration: s, gyro_offset: [x, y, z] in rad/s, accelerometer_offset: [x, y, z] in
  /// m/s^2, frozen: true, silent: true}, ...], in the unit's axes; what is left out is not so, and
  /// lasts @code of the unit
  std::vector<ImuFault> imu_faults = {};

  // @group In the plant's model and scene: plant_model() and plant_scene().
  double mass_scale = 1.0;      ///< of all masses and inertias of the plant, > 0
  UnknownPayload payload = {};  ///< what the plant carries besides
  /// [degrees] about the surface's two tangents, unknown to the controller, between -90 and 90
  /// @more through its point, about the first tangent after the second
  Eigen::Vector2d surface_tilt_deg = Eigen::Vector2d::Zero();
  double surface_height = 0.0;  ///< [m] along the normal @more before the tilt
  /// Factor of the surface's curvature in the plant: lengths of its shape are divided by it, > 0
  double surface_curvature = 1.0;
  /// what the surface is about its point in place of what it is thought to be, or none @code what
  /// the surface is about its point in place of the scene's shape @word none
  std::optional<SurfaceShape> surface_shape = {};
  SurfaceMotion surface_motion = {};  ///< of the surface along its normal
  /// Coulomb coefficient in place of the surface's, or none, >= 0 @code Coulomb coefficient in
  /// place of the scene's @word none
  std::optional<double> surface_friction = {};
  /// under what the robot stands on: [{start: s, duration: s, frame: foot, friction: coefficient},
  /// ...] @code under what the robot stands on
  std::vector<SlipperyGround> slippery_ground = {};
  /// on the tool, or on a frame: [{start: s, duration: s, force: [x, y, z] in N, world, frame:
  /// name}, ...] @code on the robot
  std::vector<Push> pushes = {};
};

/// none; sensors (17 bit encoders, differences and forces filtered at 50 Hz, 0.3 N of noise and
/// 0.05 Nm, at most 1/80 of a joint's effort limit, 1 ms of delay); mismatch (the same, masses 5 %
/// above the controller's, surface friction 0.3); joint_friction (the same, 1 Nm of Coulomb and 1
/// Nms/rad of viscous joint friction; in a joint of less than 20 Nm 1/20 of its effort limit).
const std::vector<std::string>& disturbance_presets();
/// Throws Error with the nearest known name. Its seed is 0.
Disturbances disturbance_preset(const std::string& name);

/// Throws Error with a sentence that names the entry that is not finite, negative where it may not
/// be, or of the wrong size.
void check_disturbances(const Model& model, const Disturbances& disturbances);

/// What is carried: its mass and centre as the seed draws them. Without a mass: nothing.
Payload carried_payload(const Disturbances& disturbances);

/// The robot as it is, from the robot as the controller knows it: masses scaled, a payload added,
/// and joint friction as the disturbances say. Without them the joints have none, whatever the
/// model's description states. Throws Error as check_disturbances() does, and for a payload's frame
/// that the robot does not know.
Model plant_model(const Model& nominal, const Disturbances& disturbances);

/// The scene as it is, from the scene as the controller knows it. Throws Error for a bad normal or
/// friction.
SceneSpec plant_scene(const SceneSpec& nominal, const Disturbances& disturbances);

/// Sum of the pushes on the tip at a time, N, world axes.
Eigen::Vector3d push_at(const std::vector<Push>& pushes, double time) noexcept;

}  // namespace burnish
