// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "sim/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const ActuationStep* /*of*/) {
  using S = ActuationStep;
  static const Description all =
      Describe<S>("sim", "ActuationStep",
                  "Torques after each stage of the simulated motors, in one plant step. Every "
                  "vector has nv entries, in Nm or N.")
          .result()
          .field("command", &S::command,
                 "Last valid torque command")
          .field("delayed", &S::delayed,
                 "Torque after the delay")
          .field("tracked", &S::tracked,
                 "Torque after the first-order lag")
          .field("noise", &S::noise,
                 "Noise added to the torque after scale and bias")
          .field("applied", &S::applied,
                 "Torque that acts on the plant, after scale, bias, noise, limits and motor "
                 "failures")
          .field("limited", &S::limited,
                 "Number of joints whose torque was clipped to the effort limit")
          .field("held", &S::held,
                 "Whether the previous command was used in place of an invalid command")
          .more("A command is invalid if it is not finite or has the wrong size");
  return all;
}

const Description& description_of(const ClosedLoopOptions* /*of*/) {
  using S = ClosedLoopOptions;
  static const Description all =
      Describe<S>("sim", "ClosedLoopOptions",
                  "Timing, recording and sensors of a simulation in closed loop.")
          .field("control_period", &S::control_period,
                 "Control period, a whole number of plant steps [{s}]",
                 {.least = 0, .open = true})
          .field("max_duration", &S::max_duration,
                 "Maximum duration of the recorded trace [{s}]")
          .field("record_every", &S::record_every,
                 "Plant steps per row of the trace",
                 {.least = 1})
          .field("imu_frame", &S::imu_frame,
                 "Frame of the inertial measurement unit (empty: the robot's first body; none: no"
                 " unit)")
          .more("The controller receives the readings of the inertial measurement unit");
  return all;
}

const Description& description_of(const Push* /*of*/) {
  using S = Push;
  static const Description all =
      Describe<S>("sim", "Push",
                  "A force on the tool, or on another frame of the robot, for a limited time.")
          .field("start", &S::start,
                 "Time at which the force starts [{s}]")
          .field("duration", &S::duration,
                 "Duration of the force [{s}]",
                 {.least = 0})
          .field("force_world", &S::force_world,
                 "Force in world axes, at the frame's origin [{N}]")
          .key("force")
          .field("frame", &S::frame,
                 "Frame that the force acts on (`tip` or empty: the frame of the first tool)")
          .more("If the robot has no tool, ClosedLoop refuses an empty frame, and tasks use the "
                "floating base instead.")
          .word("tip");
  return all;
}

const Description& description_of(const MotorLoss* /*of*/) {
  using S = MotorLoss;
  static const Description all =
      Describe<S>("sim", "MotorLoss",
                  "A motor failure for a limited time: the motor produces only a fraction of its "
                  "torque, or no torque. The torque sensor measures the reduced torque.")
          .field("start", &S::start,
                 "Time at which the failure starts [{s}]")
          .field("duration", &S::duration,
                 "Duration of the motor failure [{s}]",
                 {.least = 0, .infinite = true})
          .word("forever")
          .field("joint", &S::joint,
                 "Name of the joint")
          .more("All of the joint's entries of v are affected")
          .field("share", &S::share,
                 "Fraction of the torque that is left",
                 {.least = 0, .most = 1});
  return all;
}

const Description& description_of(const UnknownPayload* /*of*/) {
  using S = UnknownPayload;
  static const Description all =
      Describe<S>("sim", "UnknownPayload",
                  "A payload that the plant carries and the controller's model lacks: a solid "
                  "ball, fixed to a frame of the robot.")
          .field("frame", &S::frame,
                 "Frame that the ball is fixed to")
          .field("mass", &S::mass,
                 "Mass of the ball [{kg}]",
                 {.least = 0})
          .field("com", &S::com,
                 "Centre of the ball, in the axes of `frame` [{m}]")
          .field("radius", &S::radius,
                 "Radius of the ball [{m}]",
                 {.least = 0})
          .field("mass_range", &S::mass_range,
                 "Largest random change of the mass [{kg}]",
                 {.least = 0})
          .more("A random r with |r| <= mass_range is added to the mass. A negative sum counts as"
                " zero")
          .field("com_range", &S::com_range,
                 "Largest random change of each coordinate of the centre [{m}]",
                 {.least = 0})
          .more("A random r with |r| <= com_range is added to each coordinate");
  return all;
}

const Description& description_of(const ImuFault* /*of*/) {
  using S = ImuFault;
  static const Description all =
      Describe<S>("sim", "ImuFault",
                  "A fault of an inertial measurement unit, for a limited time.")
          .field("start", &S::start,
                 "Time at which the fault starts [{s}]")
          .field("duration", &S::duration,
                 "Duration of the fault [{s}]",
                 {.least = 0, .infinite = true})
          .word("forever")
          .field("gyro_offset", &S::gyro_offset,
                 "Offset added to the gyroscope's reading, in the unit's axes [{rad/s}]")
          .word("none")
          .field("accelerometer_offset", &S::accelerometer_offset,
                 "Offset added to the accelerometer's reading, in the unit's axes [{m/s^2}]")
          .word("none")
          .field("frozen", &S::frozen,
                 "Whether the unit keeps repeating its last reading from before the fault")
          .word("no")
          .field("silent", &S::silent,
                 "Whether the unit gives no readings")
          .word("no");
  return all;
}

const Description& description_of(const Disturbances* /*of*/) {
  using S = Disturbances;
  static const Description all =
      Describe<S>("sim", "Disturbances",
                  "All differences between a plant and its controller's model, and all errors of "
                  "sensors and motors. A disturbance without a value is off. The values zero, "
                  "empty and false also mean off. Random values are drawn from the seed. In the "
                  "descriptions of the members, \"joint\" means one entry of v. A floating base "
                  "has no motors and no encoders. The base's entries of v therefore have no motor"
                  " errors, no joint friction and no encoder rounding. Units are given for "
                  "revolute joints; for prismatic joints, replace rad by m and Nm by N.")
          .field("seed", &S::seed,
                 "Seed of all random values")
          .group("Disturbances between the command and the joint torque, in the order in which they "
             "act.")
          .field("command_delay", &S::command_delay,
                 "Delay from the controller to the motors [{s}]",
                 {.least = 0})
          .more("The delay is rounded to whole plant steps")
          .field("torque_cutoff", &S::torque_cutoff,
                 "Cut-off of the motors' first-order lag (0: no lag) [{rad/s}]",
                 {.least = 0})
          .more("The torque follows dtau/dt = cutoff (command - tau)")
          .field("torque_scale_range", &S::torque_scale_range,
                 "Largest random error of a joint's torque scale",
                 {.least = 0})
          .more("Each joint's torque is multiplied by 1 + r, where r is random and |r| <= "
                "torque_scale_range")
          .field("torque_scale", &S::torque_scale,
                 "Torque scale of each joint, nv entries (`none` or empty: random scales)")
          .word("none")
          .field("torque_bias_range", &S::torque_bias_range,
                 "Largest random torque bias of a joint [{Nm}]",
                 {.least = 0})
          .more("A random constant b with |b| <= torque_bias_range is added to each joint's "
                "torque")
          .field("torque_bias", &S::torque_bias,
                 "Torque bias of each joint, nv entries (`none` or empty: random biases) [{Nm}]")
          .word("none")
          .field("torque_noise", &S::torque_noise,
                 "Standard deviation of the torque noise [{Nm}]",
                 {.least = 0})
          .more("The noise is drawn anew in every plant step")
          .field("torque_noise_share", &S::torque_noise_share,
                 "Upper bound of torque_noise, as a fraction of the joint's effort limit (0: no "
                 "bound)",
                 {.least = 0})
          .field("torque_limits", &S::torque_limits,
                 "Whether joint torques are clipped to the robot's effort limits")
          .field("torque_loop", &S::torque_loop,
                 "Whether a torque control loop cancels the effects of torque scale, torque bias "
                 "and joint friction")
          .more("The control loop uses a torque sensor in each joint. Within its bandwidth the "
                "loop is ideal, but the noise of the sensor disturbs the torque")
          .field("torque_sensor_noise", &S::torque_sensor_noise,
                 "Standard deviation of the torque sensors' noise [{Nm}]",
                 {.least = 0})
          .field("motor_losses", &S::motor_losses,
                 "Motor failures, applied after the torque limits; in files: [{start: s, "
                 "duration: s, joint: name, share: fraction of the torque that is left}, ...]")
          .group("Friction in the joints of the plant.")
          .field("joint_coulomb", &S::joint_coulomb,
                 "Coulomb friction of each joint [{Nm}]",
                 {.least = 0})
          .field("joint_viscous", &S::joint_viscous,
                 "Viscous friction of each joint, in {Nms/rad}",
                 {.least = 0})
          .field("joint_friction_share", &S::joint_friction_share,
                 "Upper bound of joint_coulomb, as a fraction of the joint's effort limit (0: no "
                 "bound)",
                 {.least = 0})
          .more("If the bound reduces joint_coulomb, it reduces joint_viscous in the same ratio")
          .group("Disturbances between the plant and the measurement.")
          .field("measurement_delay", &S::measurement_delay,
                 "Delay of all measured values except the time [{s}]",
                 {.least = 0})
          .more("The delay is rounded to whole control periods")
          .field("encoder_bits", &S::encoder_bits,
                 "Resolution of a joint's encoder, in bits per turn (0: exact)",
                 {.least = 0, .most = 40})
          .more("Only revolute and continuous joints have an encoder resolution")
          .field("position_noise", &S::position_noise,
                 "Standard deviation of the position noise [{rad}]",
                 {.least = 0})
          .more("The noise is added before the encoder rounds the position")
          .field("velocity_noise", &S::velocity_noise,
                 "Standard deviation of the velocity noise [{rad/s}]",
                 {.least = 0})
          .field("finite_difference_velocity", &S::finite_difference_velocity,
                 "Whether measured velocities are finite differences of measured positions")
          .more("If false, the true velocities are measured")
          .field("velocity_cutoff", &S::velocity_cutoff,
                 "Cut-off of the low-pass filter on finite-difference velocities (0: no filter) "
                 "[{rad/s}]",
                 {.least = 0})
          .field("force_noise", &S::force_noise,
                 "Standard deviation of force noise in sensors that measure only the force, per "
                 "axis [{N}]",
                 {.least = 0})
          .more("Tools have such sensors, unless the scene states other sensors. The axes are "
                "those of the frame at the sensor")
          .field("force_cutoff", &S::force_cutoff,
                 "Cut-off of the low-pass filter on measured forces and moments (0: no filter) "
                 "[{rad/s}]",
                 {.least = 0})
          .more("Noise is added before the filter")
          .field("support_force_noise", &S::support_force_noise,
                 "Standard deviation of force noise in sensors of force and moment, per axis "
                 "[{N}]",
                 {.least = 0})
          .more("The noise passes the low-pass filter with the cut-off force_cutoff")
          .field("support_moment_noise", &S::support_moment_noise,
                 "Standard deviation of moment noise in sensors of force and moment, per axis "
                 "[{Nm}]",
                 {.least = 0})
          .more("The noise passes the low-pass filter with the cut-off force_cutoff")
          .group("Errors of the inertial measurement unit, if there is one. Noise densities are "
             "defined as in data sheets: if a reading is a mean over dt seconds, its noise has "
             "the standard deviation density / sqrt(dt).")
          .field("gyro_noise", &S::gyro_noise,
                 "Density of the gyroscope's white noise, per axis [{rad/s/sqrt(Hz)}]",
                 {.least = 0})
          .field("gyro_bias_range", &S::gyro_bias_range,
                 "Largest random initial bias of the gyroscope, per axis [{rad/s}]",
                 {.least = 0})
          .more("A random b with |b| <= gyro_bias_range is added to each axis")
          .field("gyro_bias_walk", &S::gyro_bias_walk,
                 "Density of the random walk of the gyroscope's bias [{rad/s^2/sqrt(Hz)}]",
                 {.least = 0})
          .field("gyro_step", &S::gyro_step,
                 "Quantization step of the gyroscope (0: exact) [{rad/s}]",
                 {.least = 0})
          .field("accelerometer_noise", &S::accelerometer_noise,
                 "Density of the accelerometer's white noise, per axis [{m/s^2/sqrt(Hz)}]",
                 {.least = 0})
          .field("accelerometer_bias_range", &S::accelerometer_bias_range,
                 "Largest random initial bias of the accelerometer, per axis [{m/s^2}]",
                 {.least = 0})
          .more("A random b with |b| <= accelerometer_bias_range is added to each axis")
          .field("accelerometer_bias_walk", &S::accelerometer_bias_walk,
                 "Density of the random walk of the accelerometer's bias [{m/s^3/sqrt(Hz)}]",
                 {.least = 0})
          .field("accelerometer_step", &S::accelerometer_step,
                 "Quantization step of the accelerometer (0: exact) [{m/s^2}]",
                 {.least = 0})
          .field("imu_faults", &S::imu_faults,
                 "Faults of the inertial measurement unit; in files: [{start: s, duration: s, "
                 "gyro_offset: [x, y, z] in rad/s, accelerometer_offset: [x, y, z] in m/s^2, "
                 "frozen: true, silent: true}, ...]. Offsets are in the unit's axes. A key that "
                 "is left out has no effect. A fault without a duration lasts forever")
          .group("Differences in the plant's model and scene, applied by plant_model() and "
             "plant_scene().")
          .field("mass_scale", &S::mass_scale,
                 "Factor on all masses and inertias of the plant",
                 {.least = 0, .open = true})
          .field("payload", &S::payload,
                 "Payload that the plant carries and the controller's model lacks")
          .field("surface_tilt_deg", &S::surface_tilt_deg,
                 "Tilt of the plant's surface about its two tangents [{degrees}]",
                 {.least = -90, .most = 90, .open = true})
          .more("The controller does not know the tilt. Both axes of rotation pass through the "
                "reference point of the surface. The rotation about the second tangent is applied"
                " first")
          .field("surface_height", &S::surface_height,
                 "Offset of the plant's surface along its normal [{m}]")
          .more("The offset is applied before the tilt")
          .field("surface_curvature", &S::surface_curvature,
                 "Factor on the curvature of the plant's surface",
                 {.least = 0, .open = true})
          .more("Lengths of the surface's shape are divided by this factor")
          .field("surface_shape", &S::surface_shape,
                 "Shape of the plant's surface (`none`: as the controller assumes)")
          .word("none")
          .field("surface_motion", &S::surface_motion,
                 "Motion of the plant's surface along its normal")
          .field("surface_friction", &S::surface_friction,
                 "Coulomb friction coefficient of the plant's surface (`none`: as the controller "
                 "assumes)",
                 {.least = 0})
          .word("none")
          .field("slippery_ground", &S::slippery_ground,
                 "Slippery ground under the robot's supports; in files: [{start: s, duration: s, "
                 "frame: foot, friction: coefficient}, ...]")
          .field("pushes", &S::pushes,
                 "Forces on a frame (without a frame: on the tool, or on the base of a robot "
                 "without a tool); in files: [{start: s, duration: s, force: [x, y, z] in N and "
                 "world axes, frame: name}, ...]");
  return all;
}

const Description& description_of(const IdealPlantOptions* /*of*/) {
  using S = IdealPlantOptions;
  static const Description all =
      Describe<S>("sim", "IdealPlantOptions",
                  "Time step, friction and drift correction of the ideal plant.")
          .field("dt", &S::dt,
                 "Time step [{s}]",
                 {.least = 0, .open = true})
          .field("tip_viscous", &S::tip_viscous,
                 "Viscous friction of the sliding tip [{Ns/m}]",
                 {.least = 0})
          .more("Viscous friction acts in addition to Coulomb friction")
          .field("stabilize_kp", &S::stabilize_kp,
                 "Gain of the drift correction on position errors [{1/s^2}]",
                 {.least = 0})
          .more("Position errors are the gap to the surface during contact, and the errors of "
                "kinematic loops")
          .field("stabilize_kd", &S::stabilize_kd,
                 "Gain of the drift correction on velocity errors [{1/s}]",
                 {.least = 0})
          .more("Velocity errors are the velocity of the gap during contact, and the velocity "
                "errors of kinematic loops");
  return all;
}

const Description& description_of(const PlantSnapshot* /*of*/) {
  using S = PlantSnapshot;
  static const Description all =
      Describe<S>("sim", "PlantSnapshot",
                  "Saved state of a plant, from which the plant can continue later. The meaning "
                  "of the numbers depends on the kind of plant.")
          .field("numbers", &S::numbers);
  return all;
}

const Description& description_of(const SurfaceMotion* /*of*/) {
  using S = SurfaceMotion;
  static const Description all =
      Describe<S>("sim", "SurfaceMotion",
                  "Motion of the plant's surface along its normal. The displacement is amplitude "
                  "sin(2 pi frequency s) + drift s, where s is the time since `start`. Before "
                  "`start` the surface rests.")
          .field("amplitude", &S::amplitude,
                 "Amplitude of the oscillation [{m}]",
                 {.least = 0})
          .field("frequency", &S::frequency,
                 "Frequency of the oscillation [{Hz}]",
                 {.least = 0, .open = true})
          .field("drift", &S::drift,
                 "Constant velocity of the surface along its normal, positive out of the material"
                 " [{m/s}]")
          .field("start", &S::start,
                 "Plant time at which the motion starts [{s}]",
                 {.least = 0});
  return all;
}

const Description& description_of(const SurfaceSpec* /*of*/) {
  using S = SurfaceSpec;
  static const Description all =
      Describe<S>("sim", "SurfaceSpec",
                  "Surface that a part of the robot touches: a plane, a curved surface, or a "
                  "square part of a plane or curved surface. Points are relative to the origin of"
                  " `frame`; points and vectors are in the axes of `frame`. Without a frame, "
                  "world coordinates are used.")
          .field("frame", &S::frame,
                 "Frame of the robot that carries the surface (empty: the surface is fixed in the"
                 " world)")
          .more("Example: the frame of a plate in a hand")
          .field("point", &S::point,
                 "A point of the surface [{m}]")
          .more("If `extent` is finite, the point is the centre of the square")
          .field("normal", &S::normal,
                 "Normal of the surface at `point` (out of the material, towards the robot)",
                 {.direction = true})
          .field("shape", &S::shape,
                 "Shape of the surface around `point`")
          .field("friction", &S::friction,
                 "Coulomb friction coefficient mu",
                 {.least = 0})
          .field("stiffness", &S::stiffness,
                 "Contact stiffness (not used by rigid plants) [{N/m}]",
                 {.least = 0, .open = true})
          .field("damping", &S::damping,
                 "Contact damping (not used by rigid plants) [{Ns/m}]",
                 {.least = 0})
          .more("MuJoCo's own contact (MujocoContact.ENGINE) lifts a sliding tip with a force of "
                "mu * damping * speed.")
          .field("motion", &S::motion,
                 "Motion of the surface along its normal")
          .field("extent", &S::extent,
                 "Half side length of the square that can be touched [{m}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("If the value is infinite, the whole surface can be touched. The square is "
                "centred at `point`, and its sides are along the columns of "
                "Reference::surface_with_normal()")
          .field("half_size", &S::half_size,
                 "Half side length of the square that is drawn if `extent` is infinite [{m}]",
                 {.least = 0, .open = true});
  return all;
}

const Description& description_of(const TouchSpec* /*of*/) {
  using S = TouchSpec;
  static const Description all =
      Describe<S>("sim", "TouchSpec",
                  "A touch: a part of the robot that can touch a surface, such as the tip of a "
                  "tool, a hand or a foot. The frame names the touch. The part is either a sphere"
                  " or a rectangle, and touches nothing but its own surface. The surface can push"
                  " on the part, but not pull. A sphere is centred at the origin of `frame`. It "
                  "touches the surface at one point. The normal force passes through the origin, "
                  "and friction has a moment about the origin. A rectangle (sole) is centred at "
                  "the origin of `frame`, with sides along the x and y axes of `frame`. Its z "
                  "axis points away from the surface. The rectangle stands on its four corners.")
          .field("frame", &S::frame,
                 "Frame at the centre of the sphere or rectangle; names the touch")
          .field("half_x", &S::half_x,
                 "Half length of a rectangle along x (0: a sphere) [{m}]",
                 {.least = 0})
          .field("half_y", &S::half_y,
                 "Half length of a rectangle along y (0: a sphere) [{m}]",
                 {.least = 0})
          .field("radius", &S::radius,
                 "Radius of a sphere; not used for a rectangle [{m}]",
                 {.least = 0, .open = true})
          .field("surface", &S::surface,
                 "Surface that the part touches; by default without friction")
          .field("is_support", &S::is_support,
                 "Whether the part is a support, on which the robot stands or leans; if false, it"
                 " is a tool")
          .more("A rectangle must be a support. The surface of a support must be a plane that is "
                "fixed in the world and has an infinite `extent`")
          .field("sensor", &S::sensor,
                 "Components that the robot measures (automatic: force of a tool, force and "
                 "moment of a support)");
  return all;
}

const Description& description_of(const SlipperyGround* /*of*/) {
  using S = SlipperyGround;
  static const Description all =
      Describe<S>("sim", "SlipperyGround",
                  "Ground that is slippery for a limited time, under one support of the robot or "
                  "under all supports.")
          .field("start", &S::start,
                 "Time at which the ground becomes slippery [{s}]")
          .field("duration", &S::duration,
                 "Duration of the slippery ground [{s}]",
                 {.least = 0, .infinite = true})
          .word("forever")
          .field("frame", &S::frame,
                 "Frame of the support that stands on slippery ground (all, or empty: every "
                 "support)")
          .word("all")
          .field("friction", &S::friction,
                 "Coulomb friction coefficient of the slippery ground",
                 {.least = 0})
          .more("This coefficient replaces the friction coefficient of the support");
  return all;
}

const Description& description_of(const HoistSpec* /*of*/) {
  using S = HoistSpec;
  static const Description all =
      Describe<S>("sim", "HoistSpec",
                  "A gantry that holds a frame of the robot at the start of a simulation and then"
                  " releases the robot. The gantry carries the robot's weight at this frame. In "
                  "addition, a stiff spring and damper hold the frame at its initial position and"
                  " rotation. During the first half of `duration` the full force acts. During the"
                  " second half the force falls to zero, and the supports take over the load.")
          .field("frame", &S::frame,
                 "Frame that the gantry holds (empty: no gantry)")
          .field("duration", &S::duration,
                 "Time at which the gantry has released the robot [{s}]",
                 {.least = 0});
  return all;
}

const Description& description_of(const SceneSpec* /*of*/) {
  using S = SceneSpec;
  static const Description all =
      Describe<S>("sim", "SceneSpec",
                  "Scene of a simulation: what the robot touches, and with which parts.")
          .field("touches", &S::touches,
                 "Parts of the robot that can touch a surface, each with its own frame")
          .field("slippery_ground", &S::slippery_ground,
                 "Slippery ground under supports")
          .field("hoist", &S::hoist,
                 "Gantry that holds the robot at the start")
          .more("The gantry is simulated by ClosedLoop, not by the plant");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
