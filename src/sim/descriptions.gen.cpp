// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "sim/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const ActuationStep* /*of*/) {
  using S = ActuationStep;
  static const Description all =
      Describe<S>("sim", "ActuationStep",
                  "One plant step of the actuation: the torque after each part, nv each, Nm or N.")
          .result()
          .field("command", &S::command,
                 "as it came")
          .field("delayed", &S::delayed)
          .field("tracked", &S::tracked,
                 "behind the first-order lag")
          .field("noise", &S::noise,
                 "added to what follows scale and bias")
          .field("applied", &S::applied,
                 "to the plant: scaled, biased, noisy, within the limits")
          .field("limited", &S::limited,
                 "joints at their effort limit")
          .field("held", &S::held,
                 "the command was not finite: the one before it was taken");
  return all;
}

const Description& description_of(const ClosedLoopOptions* /*of*/) {
  using S = ClosedLoopOptions;
  static const Description all =
      Describe<S>("sim", "ClosedLoopOptions",
                  "How a ClosedLoop runs, and what it records.")
          .field("control_period", &S::control_period,
                 "{s}, a multiple of the plant's step",
                 {.least = 0, .open = true})
          .field("max_duration", &S::max_duration,
                 "{s} that the trace has room for")
          .field("record_every", &S::record_every,
                 "plant steps per row of the trace",
                 {.least = 1})
          .field("imu_frame", &S::imu_frame,
                 "frame of an inertial measurement unit that the controller is given readings of;"
                 " empty: of the robot's first body; none: there is no unit")
          .field("support_sensors", &S::support_sensors,
                 "the controller is told the wrenches on the scene's supports: "
                 "Measurement::support_wrenches");
  return all;
}

const Description& description_of(const Push* /*of*/) {
  using S = Push;
  static const Description all =
      Describe<S>("sim", "Push",
                  "A force on the tool, or on another frame of the robot, for a while.")
          .field("start", &S::start,
                 "{s}")
          .field("duration", &S::duration,
                 "{s}",
                 {.least = 0})
          .field("force_world", &S::force_world,
                 "{N}, world axes, at the frame's origin")
          .key("force")
          .field("frame", &S::frame,
                 "that it acts at; tip: the tip's")
          .in_code("that it acts at; empty: the tip's")
          .word("tip");
  return all;
}

const Description& description_of(const MotorLoss* /*of*/) {
  using S = MotorLoss;
  static const Description all =
      Describe<S>("sim", "MotorLoss",
                  "A motor that gives a part of what it is told, or nothing, for a while. Its "
                  "torque sensor shows what it gives.")
          .field("start", &S::start,
                 "{s}")
          .field("duration", &S::duration,
                 "{s}",
                 {.least = 0, .infinite = true})
          .word("forever")
          .field("joint", &S::joint,
                 "by its name; all its entries")
          .field("share", &S::share,
                 "of its torque that it gives",
                 {.least = 0, .most = 1});
  return all;
}

const Description& description_of(const UnknownPayload* /*of*/) {
  using S = UnknownPayload;
  static const Description all =
      Describe<S>("sim", "UnknownPayload",
                  "What a plant carries at one of its frames and its controller does not know: a "
                  "ball.")
          .field("frame", &S::frame,
                 "that it is fixed to")
          .field("mass", &S::mass,
                 "{kg}",
                 {.least = 0})
          .field("com", &S::com,
                 "{m}, its centre, in the frame's axes")
          .field("radius", &S::radius,
                 "{m}",
                 {.least = 0})
          .field("mass_range", &S::mass_range,
                 "{kg}: it weighs mass + r, |r| <= this, and not less than nothing",
                 {.least = 0})
          .field("com_range", &S::com_range,
                 "{m}: each entry of its centre is com + r, |r| <= this",
                 {.least = 0});
  return all;
}

const Description& description_of(const ImuFault* /*of*/) {
  using S = ImuFault;
  static const Description all =
      Describe<S>("sim", "ImuFault",
                  "An inertial measurement unit that goes wrong for a while.")
          .field("start", &S::start,
                 "{s}")
          .field("duration", &S::duration,
                 "{s}; infinite: for good",
                 {.least = 0, .infinite = true})
          .word("forever")
          .field("gyro_offset", &S::gyro_offset,
                 "{rad/s}, added to what the gyroscope reads, the unit's axes")
          .word("none")
          .field("accelerometer_offset", &S::accelerometer_offset,
                 "{m/s^2}, added to what the accelerometer reads, the unit's axes")
          .word("none")
          .field("frozen", &S::frozen,
                 "it repeats the last reading before")
          .word("no")
          .field("silent", &S::silent,
                 "there are no readings")
          .word("no");
  return all;
}

const Description& description_of(const Disturbances* /*of*/) {
  using S = Disturbances;
  static const Description all =
      Describe<S>("sim", "Disturbances",
                  "All that makes a plant differ from what its controller believes. Nothing is "
                  "switched on unless it is named: zero, empty, false or \"no value\" is off. "
                  "What is drawn at random comes from the seed. Joints are the entries of v; "
                  "those of a floating base have neither motors nor encoders and are spared. "
                  "Units are those of revolute joints; prismatic ones have m and N in place of "
                  "rad and Nm.")
          .field("seed", &S::seed,
                 "of everything that is drawn at random")
          .group("From command to joint torque, in the order in which they act.")
          .field("command_delay", &S::command_delay,
                 "{s} from the controller to the motors",
                 {.least = 0})
          .more("rounded to plant steps")
          .field("torque_cutoff", &S::torque_cutoff,
                 "{rad/s}, first-order lag of the motors; 0: none",
                 {.least = 0})
          .more("dtau/dt = cutoff (command - tau)")
          .field("torque_scale_range", &S::torque_scale_range,
                 "each joint gives 1 + r times its torque, |r| <= this",
                 {.least = 0})
          .field("torque_scale", &S::torque_scale,
                 "factors per joint in place of drawn ones, or none")
          .in_code("nv factors in place of drawn ones, or empty")
          .word("none")
          .field("torque_bias_range", &S::torque_bias_range,
                 "{Nm}: each joint adds b, |b| <= this",
                 {.least = 0})
          .field("torque_bias", &S::torque_bias,
                 "{Nm} per joint in place of drawn ones, or none")
          .in_code("nv, Nm (N), in place of drawn ones, or empty")
          .word("none")
          .field("torque_noise", &S::torque_noise,
                 "{Nm}, deviation",
                 {.least = 0})
          .more("new at every plant step")
          .field("torque_noise_share", &S::torque_noise_share,
                 "of a joint's effort limit that this noise is at most; 0: any",
                 {.least = 0})
          .field("torque_limits", &S::torque_limits,
                 "joints give no more than the robot's effort limits")
          .field("torque_loop", &S::torque_loop,
                 "a loop around a torque sensor takes away scale, bias and joint friction")
          .more("ideal in its bandwidth; it follows the sensor's noise instead")
          .field("torque_sensor_noise", &S::torque_sensor_noise,
                 "{Nm}, deviation",
                 {.least = 0})
          .field("motor_losses", &S::motor_losses,
                 "motors that fail, behind all that: [{start: s, duration: s, joint: name, share:"
                 " 0 to 1 of its torque}, ...]")
          .in_code("motors that fail, behind all that")
          .group("In the joints of the plant.")
          .field("joint_coulomb", &S::joint_coulomb,
                 "{Nm}, joint friction",
                 {.least = 0})
          .field("joint_viscous", &S::joint_viscous,
                 "{Nms/rad}, joint friction",
                 {.least = 0})
          .field("joint_friction_share", &S::joint_friction_share,
                 "of a joint's effort limit that joint_coulomb is at most, joint_viscous in "
                 "proportion; 0: any",
                 {.least = 0})
          .group("From plant to measurement.")
          .field("measurement_delay", &S::measurement_delay,
                 "{s} from the plant to the controller, of all that is measured but its time",
                 {.least = 0})
          .more("rounded to ticks")
          .field("encoder_bits", &S::encoder_bits,
                 "per turn; 0: exact",
                 {.least = 0, .most = 40})
          .more("of revolute and continuous joints")
          .field("position_noise", &S::position_noise,
                 "{rad}, deviation, before the encoder rounds",
                 {.least = 0})
          .field("velocity_noise", &S::velocity_noise,
                 "{rad/s}, deviation",
                 {.least = 0})
          .field("finite_difference_velocity", &S::finite_difference_velocity,
                 "velocities from measured positions")
          .more("in place of the true ones")
          .field("velocity_cutoff", &S::velocity_cutoff,
                 "{rad/s}, low-pass on those; 0: none",
                 {.least = 0})
          .field("force_noise", &S::force_noise,
                 "{N}, deviation per axis of the force sensor",
                 {.least = 0})
          .field("force_cutoff", &S::force_cutoff,
                 "{rad/s}, low-pass behind the noise; 0: none",
                 {.least = 0})
          .field("support_force_noise", &S::support_force_noise,
                 "{N}, deviation per axis of the sensors in supports",
                 {.least = 0})
          .field("support_moment_noise", &S::support_moment_noise,
                 "{Nm}, likewise; both behind force_cutoff",
                 {.least = 0})
          .group("Of an inertial measurement unit, where there is one. Densities are those of data "
             "sheets: a reading every dt s has a deviation of the density / sqrt(dt).")
          .field("gyro_noise", &S::gyro_noise,
                 "{rad/s/sqrt(Hz)}, white, per axis",
                 {.least = 0})
          .field("gyro_bias_range", &S::gyro_bias_range,
                 "{rad/s}: each axis adds b, |b| <= this",
                 {.least = 0})
          .field("gyro_bias_walk", &S::gyro_bias_walk,
                 "{rad/s^2/sqrt(Hz)} that b walks with",
                 {.least = 0})
          .field("gyro_step", &S::gyro_step,
                 "{rad/s}, of its converter; 0: exact",
                 {.least = 0})
          .field("accelerometer_noise", &S::accelerometer_noise,
                 "{m/s^2/sqrt(Hz)}, white, per axis",
                 {.least = 0})
          .field("accelerometer_bias_range", &S::accelerometer_bias_range,
                 "{m/s^2}: each axis adds b, |b| <= this",
                 {.least = 0})
          .field("accelerometer_bias_walk", &S::accelerometer_bias_walk,
                 "{m/s^3/sqrt(Hz)} that b walks with",
                 {.least = 0})
          .field("accelerometer_step", &S::accelerometer_step,
                 "{m/s^2}, of its converter; 0: exact",
                 {.least = 0})
          .field("imu_faults", &S::imu_faults,
                 "[{start: s, duration: s, gyro_offset: [x, y, z] in rad/s, accelerometer_offset:"
                 " [x, y, z] in m/s^2, frozen: true, silent: true}, ...], in the unit's axes; "
                 "what is left out is not so, and lasts")
          .in_code("of the unit")
          .group("In the plant's model and scene: plant_model() and plant_scene().")
          .field("mass_scale", &S::mass_scale,
                 "of all masses and inertias of the plant",
                 {.least = 0, .open = true})
          .field("payload", &S::payload,
                 "what the plant carries besides")
          .field("surface_tilt_deg", &S::surface_tilt_deg,
                 "{degrees} about the surface's two tangents, unknown to the controller",
                 {.least = -90, .most = 90, .open = true})
          .more("through its point, about the first tangent after the second")
          .field("surface_height", &S::surface_height,
                 "{m} along the normal")
          .more("before the tilt")
          .field("surface_curvature", &S::surface_curvature,
                 "Factor of the surface's curvature in the plant: lengths of its shape are "
                 "divided by it",
                 {.least = 0, .open = true})
          .field("surface_shape", &S::surface_shape,
                 "what the surface is about its point in place of what it is thought to be, or "
                 "none")
          .in_code("what the surface is about its point in place of the scene's shape")
          .word("none")
          .field("surface_motion", &S::surface_motion,
                 "of the surface along its normal")
          .field("surface_friction", &S::surface_friction,
                 "Coulomb coefficient in place of the surface's, or none",
                 {.least = 0})
          .in_code("Coulomb coefficient in place of the scene's")
          .word("none")
          .field("slippery_ground", &S::slippery_ground,
                 "under what the robot stands on: [{start: s, duration: s, frame: foot, friction:"
                 " coefficient}, ...]")
          .in_code("under what the robot stands on")
          .field("pushes", &S::pushes,
                 "on the tool, or on a frame: [{start: s, duration: s, force: [x, y, z] in N, "
                 "world, frame: name}, ...]")
          .in_code("on the robot");
  return all;
}

const Description& description_of(const IdealPlantOptions* /*of*/) {
  using S = IdealPlantOptions;
  static const Description all =
      Describe<S>("sim", "IdealPlantOptions",
                  "How make_ideal_plant()'s plant steps.")
          .field("dt", &S::dt,
                 "{s}",
                 {.least = 0, .open = true})
          .field("tip_viscous", &S::tip_viscous,
                 "{Ns/m}, against the contact point's sliding, besides Coulomb",
                 {.least = 0})
          .field("stabilize_kp", &S::stabilize_kp,
                 "{1/s^2}, on the gap while in contact, and on loops",
                 {.least = 0})
          .field("stabilize_kd", &S::stabilize_kd,
                 "{1/s}, on its rate",
                 {.least = 0});
  return all;
}

const Description& description_of(const PlantSnapshot* /*of*/) {
  using S = PlantSnapshot;
  static const Description all =
      Describe<S>("sim", "PlantSnapshot",
                  "A moment of a plant, to go back to. What it holds belongs to the kind of plant"
                  " that saved it.")
          .field("numbers", &S::numbers);
  return all;
}

const Description& description_of(const SurfaceMotion* /*of*/) {
  using S = SurfaceMotion;
  static const Description all =
      Describe<S>("sim", "SurfaceMotion",
                  "How a surface moves along its normal, as a plant has it: by amplitude sin(2 pi"
                  " frequency s) + drift s, s being the time since its start; before, it rests.")
          .field("amplitude", &S::amplitude,
                 "{m}",
                 {.least = 0})
          .field("frequency", &S::frequency,
                 "{Hz}",
                 {.least = 0, .open = true})
          .field("drift", &S::drift,
                 "{m/s}, out of the material")
          .field("start", &S::start,
                 "{s}, of the plant's time",
                 {.least = 0});
  return all;
}

const Description& description_of(const SurfaceSpec* /*of*/) {
  using S = SurfaceSpec;
  static const Description all =
      Describe<S>("sim", "SurfaceSpec",
                  "A plane or a curved surface, or what of it stands over a square. All vectors "
                  "in the axes of `frame`, points from its origin: in the world where there is "
                  "none.")
          .field("frame", &S::frame,
                 "of the robot, that the surface moves with, such as a plate in a hand; empty: it"
                 " stands still")
          .field("point", &S::point,
                 "any point on it, {m}; of a square, its middle")
          .field("normal", &S::normal,
                 "out of the material, towards the robot; of a curved surface at its point",
                 {.direction = true})
          .field("shape", &S::shape,
                 "plane, or what it is about that point")
          .field("friction", &S::friction,
                 "Coulomb coefficient mu",
                 {.least = 0})
          .field("stiffness", &S::stiffness,
                 "{N/m}; rigid plants pass it over",
                 {.least = 0, .open = true})
          .field("damping", &S::damping,
                 "{Ns/m}; rigid plants pass it over",
                 {.least = 0})
          .more("MuJoCo's own contact (MujocoContact.ENGINE) lifts a sliding tip by mu * damping "
                "* speed.")
          .field("motion", &S::motion,
                 "along the normal at its point")
          .field("extent", &S::extent,
                 "{m}, half the side of the square about `point` that is there to be touched, its"
                 " sides along the columns of Reference::surface_with_normal(); infinite: the "
                 "plane has no end",
                 {.least = 0, .open = true, .infinite = true})
          .field("half_size", &S::half_size,
                 "{m}, of the square that is drawn where the plane has no end",
                 {.least = 0, .open = true});
  return all;
}

const Description& description_of(const ToolTipSpec* /*of*/) {
  using S = ToolTipSpec;
  static const Description all =
      Describe<S>("sim", "ToolTipSpec",
                  "A sphere about the origin of a frame. It touches a plane at one point, and the"
                  " normal force passes through the frame's origin.")
          .field("frame", &S::frame)
          .field("radius", &S::radius,
                 "{m}",
                 {.least = 0, .open = true});
  return all;
}

const Description& description_of(const SupportSpec* /*of*/) {
  using S = SupportSpec;
  static const Description all =
      Describe<S>("sim", "SupportSpec",
                  "A part of the robot that stands on a plane of its own, or leans against it, "
                  "with nothing to hold it there but what it presses with: a sole, which is a "
                  "rectangle about the origin of a frame in that frame's x and y, with z away "
                  "from the plane, or without sides a ball about the origin.")
          .field("frame", &S::frame)
          .field("half_x", &S::half_x,
                 "{m}, half the side of a sole along x; 0: a ball",
                 {.least = 0})
          .field("half_y", &S::half_y,
                 "{m}, along y",
                 {.least = 0})
          .field("radius", &S::radius,
                 "{m}, of a ball",
                 {.least = 0, .open = true})
          .field("point", &S::point,
                 "of the plane, {m}, world")
          .field("normal", &S::normal,
                 "of the plane, out of the material, towards the robot; any length, world",
                 {.direction = true})
          .field("friction", &S::friction,
                 "Coulomb coefficient",
                 {.least = 0})
          .field("stiffness", &S::stiffness,
                 "{N/m}, of the whole part",
                 {.least = 0, .open = true})
          .field("damping", &S::damping,
                 "{Ns/m}, of the whole part",
                 {.least = 0, .open = true});
  return all;
}

const Description& description_of(const SlipperyGround* /*of*/) {
  using S = SlipperyGround;
  static const Description all =
      Describe<S>("sim", "SlipperyGround",
                  "Ground that is slippery for a while, under one of the things that the robot "
                  "stands on.")
          .field("start", &S::start,
                 "{s}")
          .field("duration", &S::duration,
                 "{s}",
                 {.least = 0, .infinite = true})
          .word("forever")
          .field("frame", &S::frame,
                 "of the support that stands on it; all: of all")
          .in_code("of the support that stands on it; empty: of all")
          .word("all")
          .field("friction", &S::friction,
                 "Coulomb coefficient in place of the support's",
                 {.least = 0});
  return all;
}

const Description& description_of(const HoistSpec* /*of*/) {
  using S = HoistSpec;
  static const Description all =
      Describe<S>("sim", "HoistSpec",
                  "What holds the robot by a frame at first, as a crane does, and lets it go: its"
                  " weight, upwards at that frame, and a stiff spring and damper about where that"
                  " was, in place and rotation. It has all of it for the first half of `duration`"
                  " and gives it to what the robot stands on in the second.")
          .field("frame", &S::frame,
                 "empty: nothing holds it")
          .field("duration", &S::duration,
                 "{s}, until it has let go",
                 {.least = 0});
  return all;
}

const Description& description_of(const SceneSpec* /*of*/) {
  using S = SceneSpec;
  static const Description all =
      Describe<S>("sim", "SceneSpec",
                  "What the tool meets, a surface and a round tip, and what the robot stands on.")
          .field("surface", &S::surface)
          .field("tip", &S::tip)
          .field("supports", &S::supports,
                 "such as the feet, on the ground")
          .field("slippery_ground", &S::slippery_ground,
                 "under those")
          .field("hoist", &S::hoist,
                 "of a ClosedLoop, not the plant's");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
