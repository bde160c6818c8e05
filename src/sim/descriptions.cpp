#include "sim/descriptions.hpp"

namespace burnish {

const Description& description_of(const Push* /*of*/) {
  static const Description all =
      Describe<Push>("sim", "Push",
                     "A force on the tool, or on another frame of the robot, for a while.")
          .field("start", &Push::start, "{s}")
          .field("duration", &Push::duration, "{s}", range::not_negative)
          .field("force_world", &Push::force_world, "{N}, world axes, at the frame's origin")
          .key("force")
          .field("frame", &Push::frame, "that it acts at; tip: the tip's")
          .in_code("that it acts at; empty: the tip's")
          .word("tip");
  return all;
}

const Description& description_of(const SlipperyGround* /*of*/) {
  using S = SlipperyGround;
  static const Description all =
      Describe<S>("sim", "SlipperyGround",
                  "Ground that is slippery for a while, under one of the things that the robot "
                  "stands on.")
          .field("start", &S::start, "{s}")
          .field("duration", &S::duration, "{s}", range::not_negative_or_infinite)
          .word("forever")
          .field("frame", &S::frame, "of the support that stands on it; all: of all")
          .in_code("of the support that stands on it; empty: of all")
          .word("all")
          .field("friction", &S::friction, "Coulomb coefficient in place of the support's",
                 range::not_negative);
  return all;
}

const Description& description_of(const MotorLoss* /*of*/) {
  using M = MotorLoss;
  static const Description all =
      Describe<M>("sim", "MotorLoss",
                  "A motor that gives a part of what it is told, or nothing, for a while. Its "
                  "torque sensor shows what it gives.")
          .field("start", &M::start, "{s}")
          .field("duration", &M::duration, "{s}", range::not_negative_or_infinite)
          .word("forever")
          .field("joint", &M::joint, "by its name; all its entries")
          .field("share", &M::share, "of its torque that it gives", range::share);
  return all;
}

const Description& description_of(const SurfaceMotion* /*of*/) {
  using M = SurfaceMotion;
  static const Description all =
      Describe<M>("sim", "SurfaceMotion",
                  "How a surface moves along its normal, as a plant has it: by amplitude sin(2 pi "
                  "frequency s) + drift s, s being the time since its start; before, it rests.")
          .field("amplitude", &M::amplitude, "{m}", range::not_negative)
          .field("frequency", &M::frequency, "{Hz}", range::positive)
          .field("drift", &M::drift, "{m/s}, out of the material")
          .field("start", &M::start, "{s}, of the plant's time", range::not_negative);
  return all;
}

const Description& description_of(const UnknownPayload* /*of*/) {
  using P = UnknownPayload;
  static const Description all =
      Describe<P>(
          "sim", "UnknownPayload",
          "What a plant carries at one of its frames and its controller does not know: a ball.")
          .field("frame", &P::frame, "that it is fixed to")
          .field("mass", &P::mass, "{kg}", range::not_negative)
          .field("com", &P::com, "{m}, its centre, in the frame's axes")
          .field("radius", &P::radius, "{m}", range::not_negative)
          .field("mass_range", &P::mass_range,
                 "{kg}: it weighs mass + r, |r| <= this, and not less than nothing",
                 range::not_negative)
          .field("com_range", &P::com_range,
                 "{m}: each entry of its centre is com + r, |r| <= this", range::not_negative);
  return all;
}

const Description& description_of(const ImuFault* /*of*/) {
  using I = ImuFault;
  static const Description all =
      Describe<I>("sim", "ImuFault", "An inertial measurement unit that goes wrong for a while.")
          .field("start", &I::start, "{s}")
          .field("duration", &I::duration, "{s}; infinite: for good",
                 range::not_negative_or_infinite)
          .word("forever")
          .field("gyro_offset", &I::gyro_offset,
                 "{rad/s}, added to what the gyroscope reads, the unit's axes")
          .word("none")
          .field("accelerometer_offset", &I::accelerometer_offset,
                 "{m/s^2}, added to what the accelerometer reads, the unit's axes")
          .word("none")
          .field("frozen", &I::frozen, "it repeats the last reading before")
          .word("no")
          .field("silent", &I::silent, "there are no readings")
          .word("no");
  return all;
}

// NOLINTNEXTLINE(readability-function-size): a table
const Description& description_of(const Disturbances* /*of*/) {
  using D = Disturbances;
  constexpr Range size = range::not_negative;
  static const Description all =
      Describe<D>(
          "sim", "Disturbances",
          "All that makes a plant differ from what its controller believes. Nothing is "
          "switched on unless it is named: zero, empty, false or \"no value\" is off. What is "
          "drawn at random comes from the seed. Joints are the entries of v; those of a "
          "floating base have neither motors nor encoders and are spared. Units are those of "
          "revolute joints; prismatic ones have m and N in place of rad and Nm.")
          .field("seed", &D::seed, "of everything that is drawn at random")
          .group("From command to joint torque, in the order in which they act.")
          .field("command_delay", &D::command_delay, "{s} from the controller to the motors", size)
          .more("rounded to plant steps")
          .field("torque_cutoff", &D::torque_cutoff,
                 "{rad/s}, first-order lag of the motors; 0: none", size)
          .more("dtau/dt = cutoff (command - tau)")
          .field("torque_scale_range", &D::torque_scale_range,
                 "each joint gives 1 + r times its torque, |r| <= this", size)
          .field("torque_scale", &D::torque_scale,
                 "factors per joint in place of drawn ones, or none")
          .in_code("nv factors in place of drawn ones, or empty")
          .word("none")
          .field("torque_bias_range", &D::torque_bias_range, "{Nm}: each joint adds b, |b| <= this",
                 size)
          .field("torque_bias", &D::torque_bias, "{Nm} per joint in place of drawn ones, or none")
          .in_code("nv, Nm (N), in place of drawn ones, or empty")
          .word("none")
          .field("torque_noise", &D::torque_noise, "{Nm}, deviation", size)
          .more("new at every plant step")
          .field("torque_noise_share", &D::torque_noise_share,
                 "of a joint's effort limit that this noise is at most; 0: any", size)
          .field("torque_limits", &D::torque_limits,
                 "joints give no more than the robot's effort limits")
          .field("torque_loop", &D::torque_loop,
                 "a loop around a torque sensor takes away scale, bias and joint friction")
          .more("ideal in its bandwidth; it follows the sensor's noise instead")
          .field("torque_sensor_noise", &D::torque_sensor_noise, "{Nm}, deviation", size)
          .field("motor_losses", &D::motor_losses,
                 "motors that fail, behind all that: [{start: s, duration: s, joint: name, share: "
                 "0 to 1 of its torque}, ...]")
          .in_code("motors that fail, behind all that")
          .group("In the joints of the plant.")
          .field("joint_coulomb", &D::joint_coulomb, "{Nm}, joint friction", size)
          .field("joint_viscous", &D::joint_viscous, "{Nms/rad}, joint friction", size)
          .field("joint_friction_share", &D::joint_friction_share,
                 "of a joint's effort limit that joint_coulomb is at most, joint_viscous in "
                 "proportion; 0: any",
                 size)
          .group("From plant to measurement.")
          .field("measurement_delay", &D::measurement_delay,
                 "{s} from the plant to the controller, of all that is measured but its time", size)
          .more("rounded to ticks")
          .field("encoder_bits", &D::encoder_bits, "per turn; 0: exact", range::from(0, 40))
          .more("of revolute and continuous joints")
          .field("position_noise", &D::position_noise,
                 "{rad}, deviation, before the encoder rounds", size)
          .field("velocity_noise", &D::velocity_noise, "{rad/s}, deviation", size)
          .field("finite_difference_velocity", &D::finite_difference_velocity,
                 "velocities from measured positions")
          .more("in place of the true ones")
          .field("velocity_cutoff", &D::velocity_cutoff, "{rad/s}, low-pass on those; 0: none",
                 size)
          .field("force_noise", &D::force_noise, "{N}, deviation per axis of the force sensor",
                 size)
          .field("force_cutoff", &D::force_cutoff, "{rad/s}, low-pass behind the noise; 0: none",
                 size)
          .field("support_force_noise", &D::support_force_noise,
                 "{N}, deviation per axis of the sensors in supports", size)
          .field("support_moment_noise", &D::support_moment_noise,
                 "{Nm}, likewise; both behind force_cutoff", size)
          .group(
              "Of an inertial measurement unit, where there is one. Densities are those of data "
              "sheets: a reading every dt s has a deviation of the density / sqrt(dt).")
          .field("gyro_noise", &D::gyro_noise, "{rad/s/sqrt(Hz)}, white, per axis", size)
          .field("gyro_bias_range", &D::gyro_bias_range, "{rad/s}: each axis adds b, |b| <= this",
                 size)
          .field("gyro_bias_walk", &D::gyro_bias_walk, "{rad/s^2/sqrt(Hz)} that b walks with", size)
          .field("gyro_step", &D::gyro_step, "{rad/s}, of its converter; 0: exact", size)
          .field("accelerometer_noise", &D::accelerometer_noise,
                 "{m/s^2/sqrt(Hz)}, white, per axis", size)
          .field("accelerometer_bias_range", &D::accelerometer_bias_range,
                 "{m/s^2}: each axis adds b, |b| <= this", size)
          .field("accelerometer_bias_walk", &D::accelerometer_bias_walk,
                 "{m/s^3/sqrt(Hz)} that b walks with", size)
          .field("accelerometer_step", &D::accelerometer_step,
                 "{m/s^2}, of its converter; 0: exact", size)
          .field("imu_faults", &D::imu_faults,
                 "[{start: s, duration: s, gyro_offset: [x, y, z] in rad/s, accelerometer_offset: "
                 "[x, y, z] in m/s^2, frozen: true, silent: true}, ...], in the unit's axes; what "
                 "is left out is not so, and lasts")
          .in_code("of the unit")
          .group("In the plant's model and scene: plant_model() and plant_scene().")
          .field("mass_scale", &D::mass_scale, "of all masses and inertias of the plant",
                 range::positive)
          .field("payload", &D::payload, "what the plant carries besides")
          .field("surface_tilt_deg", &D::surface_tilt_deg,
                 "{degrees} about the surface's two tangents, unknown to the controller",
                 range::between(-90, 90))
          .more("through its point, about the first tangent after the second")
          .field("surface_height", &D::surface_height, "{m} along the normal")
          .more("before the tilt")
          .field("surface_curvature", &D::surface_curvature,
                 "how much more the surface bends than the scene's: its lengths are divided by it",
                 range::positive)
          .field(
              "surface_shape", &D::surface_shape,
              "what the surface is about its point in place of what it is thought to be, or none")
          .in_code("what the surface is about its point in place of the scene's shape")
          .word("none")
          .field("surface_motion", &D::surface_motion, "of the surface along its normal")
          .field("surface_friction", &D::surface_friction,
                 "Coulomb coefficient in place of the surface's, or none", size)
          .in_code("Coulomb coefficient in place of the scene's")
          .word("none")
          .field("slippery_ground", &D::slippery_ground,
                 "under what the robot stands on: [{start: s, duration: s, frame: foot, friction: "
                 "coefficient}, ...]")
          .in_code("under what the robot stands on")
          .field(
              "pushes", &D::pushes,
              "on the tool, or on a frame: [{start: s, duration: s, force: [x, y, z] in N, world, "
              "frame: name}, ...]")
          .in_code("on the robot");
  return all;
}

const Description& description_of(const SurfaceSpec* /*of*/) {
  using S = SurfaceSpec;
  static const Description all =
      Describe<S>("sim", "SurfaceSpec",
                  "A plane or a curved surface, or what of it stands over a square. All vectors in "
                  "the axes of `frame`, points from its origin: in the world where there is none.")
          .field("frame", &S::frame,
                 "of the robot, that the surface moves with, such as a plate in a hand; empty: it "
                 "stands still")
          .field("point", &S::point, "any point on it, {m}; of a square, its middle")
          .field("normal", &S::normal,
                 "out of the material, towards the robot; of a curved surface at its point",
                 range::direction)
          .field("shape", &S::shape, "plane, or what it is about that point")
          .field("friction", &S::friction, "Coulomb coefficient mu", range::not_negative)
          .field("stiffness", &S::stiffness, "{N/m}; rigid plants pass it over", range::positive)
          .field("damping", &S::damping, "{Ns/m}; rigid plants pass it over", range::not_negative)
          .more(
              "MuJoCo's own contact (MujocoContact.ENGINE) lifts a sliding tip by mu * damping * "
              "speed.")
          .field("motion", &S::motion, "along the normal at its point")
          .field("extent", &S::extent,
                 "{m}, half the side of the square about `point` that is there to be touched, its "
                 "sides along the columns of Reference::surface_with_normal(); infinite: the plane "
                 "has no end",
                 range::positive_or_infinite)
          .field("half_size", &S::half_size,
                 "{m}, of the square that is drawn where the plane has no end", range::positive);
  return all;
}

const Description& description_of(const ToolTipSpec* /*of*/) {
  static const Description all =
      Describe<ToolTipSpec>(
          "sim", "ToolTipSpec",
          "A sphere about the origin of a frame. It touches a plane at one point, "
          "and the normal force passes through the frame's origin.")
          .field("frame", &ToolTipSpec::frame, "")
          .field("radius", &ToolTipSpec::radius, "{m}", range::positive);
  return all;
}

const Description& description_of(const SupportSpec* /*of*/) {
  using S = SupportSpec;
  static const Description all =
      Describe<S>(
          "sim", "SupportSpec",
          "A part of the robot that stands on a plane of its own, or leans against it, with "
          "nothing to hold it there but what it presses with: a sole, which is a rectangle "
          "about the origin of a frame in that frame's x and y, with z away from the "
          "plane, or without sides a ball about the origin.")
          .field("frame", &S::frame, "")
          .field("half_x", &S::half_x, "{m}, half the side of a sole along x; 0: a ball",
                 range::not_negative)
          .field("half_y", &S::half_y, "{m}, along y", range::not_negative)
          .field("radius", &S::radius, "{m}, of a ball", range::positive)
          .field("point", &S::point, "of the plane, {m}, world")
          .field("normal", &S::normal,
                 "of the plane, out of the material, towards the robot; any length, world",
                 range::direction)
          .field("friction", &S::friction, "Coulomb coefficient", range::not_negative)
          .field("stiffness", &S::stiffness, "{N/m}, of the whole part", range::positive)
          .field("damping", &S::damping, "{Ns/m}, of the whole part", range::positive);
  return all;
}

const Description& description_of(const HoistSpec* /*of*/) {
  using H = HoistSpec;
  static const Description all =
      Describe<H>("sim", "HoistSpec",
                  "What holds the robot by a frame at first, as a crane does, and lets it go: its "
                  "weight, upwards at that frame, and a stiff spring and damper about where that "
                  "was, in place and rotation. It has all of it for the first half of `duration` "
                  "and gives it to what the robot stands on in the second.")
          .field("frame", &H::frame, "empty: nothing holds it")
          .field("duration", &H::duration, "{s}, until it has let go", range::not_negative);
  return all;
}

const Description& description_of(const SceneSpec* /*of*/) {
  static const Description all =
      Describe<SceneSpec>("sim", "SceneSpec",
                          "What the tool meets, a surface and a round tip, and what the robot "
                          "stands on.")
          .field("surface", &SceneSpec::surface, "")
          .field("tip", &SceneSpec::tip, "")
          .field("supports", &SceneSpec::supports, "such as the feet, on the ground")
          .field("slippery_ground", &SceneSpec::slippery_ground, "under those")
          .field("hoist", &SceneSpec::hoist, "of a ClosedLoop, not the plant's");
  return all;
}

const Description& description_of(const PlantSnapshot* /*of*/) {
  static const Description all =
      Describe<PlantSnapshot>(
          "sim", "PlantSnapshot",
          "A moment of a plant, to go back to. What it holds belongs to the kind "
          "of plant that saved it.")
          .field("numbers", &PlantSnapshot::numbers, "");
  return all;
}

const Description& description_of(const ActuationStep* /*of*/) {
  using A = ActuationStep;
  static const Description all =
      Describe<A>("sim", "ActuationStep",
                  "One plant step of the actuation: the torque after each part, nv each, Nm or N.")
          .result()
          .field("command", &A::command, "as it came")
          .field("delayed", &A::delayed, "")
          .field("tracked", &A::tracked, "behind the first-order lag")
          .field("noise", &A::noise, "added to what follows scale and bias")
          .field("applied", &A::applied, "to the plant: scaled, biased, noisy, within the limits")
          .field("limited", &A::limited, "joints at their effort limit")
          .field("held", &A::held, "the command was not finite: the one before it was taken");
  return all;
}

const Description& description_of(const IdealPlantOptions* /*of*/) {
  using I = IdealPlantOptions;
  static const Description all =
      Describe<I>("sim", "IdealPlantOptions", "How make_ideal_plant()'s plant steps.")
          .field("dt", &I::dt, "{s}", range::positive)
          .field("tip_viscous", &I::tip_viscous,
                 "{Ns/m}, against the contact point's sliding, besides Coulomb",
                 range::not_negative)
          .field("stabilize_kp", &I::stabilize_kp,
                 "{1/s^2}, on the gap while in contact, and on loops", range::not_negative)
          .field("stabilize_kd", &I::stabilize_kd, "{1/s}, on its rate", range::not_negative);
  return all;
}

const Description& description_of(const ClosedLoopOptions* /*of*/) {
  using C = ClosedLoopOptions;
  static const Description all =
      Describe<C>("sim", "ClosedLoopOptions", "How a ClosedLoop runs, and what it records.")
          .field("control_period", &C::control_period, "{s}, a multiple of the plant's step",
                 range::positive)
          .field("max_duration", &C::max_duration, "{s} that the trace has room for")
          .field("record_every", &C::record_every, "plant steps per row of the trace",
                 range::from(1))
          .field("imu_frame", &C::imu_frame,
                 "frame of an inertial measurement unit that the controller is given readings of; "
                 "empty: of the robot's first body; none: there is no unit")
          .field("support_sensors", &C::support_sensors,
                 "the controller is told the wrenches on the scene's supports: "
                 "Measurement::support_wrenches");
  return all;
}

}  // namespace burnish
