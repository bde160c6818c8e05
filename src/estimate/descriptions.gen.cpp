// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "estimate/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Words& words_of(FootKind /*of*/) {
  static const Words all{
      "estimate",
      "FootKind",
      "Kind of a foot: motions of the foot that are zero while the foot stands.",
      {{"ball", "Point foot: the origin of its frame does not move"},
       {"sole", "Planar foot: its frame neither moves nor rotates"}}};
  return all;
}

const Description& description_of(const FootSpec* /*of*/) {
  using S = FootSpec;
  static const Description all =
      Describe<S>("estimate", "FootSpec",
                  "Foot of a robot. The estimator uses the foot while the foot stands on the "
                  "ground.")
          .field("frame", &S::frame,
                 "Name of the foot's frame")
          .more("For a ball, the frame is at the centre of the ball, and the ball should roll "
                "only a little.")
          .required()
          .field("kind", &S::kind,
                 "Kind of foot: ball (frame origin does not move) or sole (frame neither moves "
                 "nor rotates)");
  return all;
}

const Description& description_of(const UnitWatchOptions* /*of*/) {
  using S = UnitWatchOptions;
  static const Description all =
      Describe<S>("estimate", "UnitWatchOptions",
                  "Thresholds for detecting a faulty inertial measurement unit (IMU) while feet "
                  "stand.")
          .field("enabled", &S::enabled,
                 "Whether to compare the IMU with the feet")
          .more("If not, the only detected fault is an IMU without readings.")
          .field("window", &S::window,
                 "Time window in which IMU and feet are compared [{s}]",
                 {.least = 0, .open = true})
          .more("Older differences fade exponentially.")
          .field("turn", &S::turn,
                 "Largest accepted difference in rotation between IMU and feet in the window "
                 "[{rad}]",
                 {.least = 0, .open = true})
          .more("The threshold is increased by the expected effects of noise and biases.")
          .field("place", &S::place,
                 "Largest accepted difference in displacement between IMU and feet in the window "
                 "[{m}]",
                 {.least = 0, .open = true})
          .more("The threshold is increased by the expected effects of noise and biases.")
          .field("rate", &S::rate,
                 "Largest accepted difference in angular velocity between IMU and feet [{rad/s}]",
                 {.least = 0, .open = true})
          .more("Readings beyond this threshold are withheld from the filter until it is clear "
                "whether the IMU or the feet are wrong.")
          .field("feet_turn", &S::feet_turn,
                 "Largest accepted rotation of a standing sole relative to the other feet [{rad}]",
                 {.least = 0, .open = true})
          .field("feet_place", &S::feet_place,
                 "Largest accepted displacement of a standing foot relative to the other feet "
                 "[{m}]",
                 {.least = 0, .open = true})
          .field("silent_after", &S::silent_after,
                 "Time without readings after which the IMU counts as silent [{s}]",
                 {.least = 0})
          .field("back_after", &S::back_after,
                 "Time of agreement with the feet after which a faulty IMU is used again [{s}]",
                 {.least = 0, .open = true})
          .field("decay_time", &S::decay_time,
                 "Decay time of the offset that prevents a jump of the estimate when the IMU "
                 "fails [{s}]",
                 {.least = 0, .open = true})
          .more("The offset is the last estimate minus the estimate from the feet.");
  return all;
}

const Description& description_of(const BaseEstimatorOptions* /*of*/) {
  using S = BaseEstimatorOptions;
  static const Description all =
      Describe<S>("estimate", "BaseEstimatorOptions",
                  "Options for estimating the floating base. Noise densities describe white "
                  "noise: with one reading every dt s, the standard deviation of a reading is "
                  "density / sqrt(dt).")
          .field("imu_frame", &S::imu_frame,
                 "Frame of the inertial measurement unit (empty: the floating base's body)")
          .more("Readings are in the axes of this frame.")
          .field("feet", &S::feet,
                 "Feet of the robot, 1 to 32 of them")
          .group("Noise.")
          .field("gyro_noise", &S::gyro_noise,
                 "Noise density of the gyroscope [{rad/s/sqrt(Hz)}]",
                 {.least = 0})
          .field("accelerometer_noise", &S::accelerometer_noise,
                 "Noise density of the accelerometer [{m/s^2/sqrt(Hz)}]",
                 {.least = 0})
          .field("gyro_bias_walk", &S::gyro_bias_walk,
                 "Random-walk density of the gyroscope's bias [{rad/s^2/sqrt(Hz)}]",
                 {.least = 0})
          .field("accelerometer_bias_walk", &S::accelerometer_bias_walk,
                 "Random-walk density of the accelerometer's bias [{m/s^3/sqrt(Hz)}]",
                 {.least = 0})
          .field("encoder_noise", &S::encoder_noise,
                 "Standard deviation of an encoder reading [{rad (m)}]",
                 {.least = 0})
          .field("place_noise", &S::place_noise,
                 "Standard deviation of a foot's measured position, in addition to encoder noise "
                 "[{m}]",
                 {.least = 0, .open = true})
          .field("turn_noise", &S::turn_noise,
                 "Standard deviation of a sole's measured rotation, in addition to encoder noise "
                 "[{rad}]",
                 {.least = 0, .open = true})
          .field("slip_noise", &S::slip_noise,
                 "Random-walk density of a standing foot's position, for slow slip "
                 "[{m/s/sqrt(Hz)}]",
                 {.least = 0})
          .field("sole_turn_noise", &S::sole_turn_noise,
                 "Random-walk density of a standing sole's rotation, for slow slip "
                 "[{rad/s/sqrt(Hz)}]",
                 {.least = 0})
          .group("Feet that slip.")
          .field("gate", &S::gate,
                 "Fraction of a resting foot's readings that pass the outlier test",
                 {.least = 0, .most = 1, .open = true})
          .field("rejoin_after", &S::rejoin_after,
                 "Rest time after which a foot that slipped is used again [{s}]",
                 {.least = 0})
          .field("rejoin_speed", &S::rejoin_speed,
                 "Speed below which a foot that slipped counts as at rest [{m/s}]",
                 {.least = 0, .open = true})
          .field("lost_after", &S::lost_after,
                 "Longest time in which all standing feet may seem to slip [{s}]",
                 {.least = 0})
          .more("After this time, the filter assumes that its own velocity is wrong.")
          .group("Standard deviations of the initial state.")
          .field("tilt_deviation", &S::tilt_deviation,
                 "Standard deviation of the initial rotation about horizontal axes (tilt) [{rad}]",
                 {.least = 0})
          .field("yaw_deviation", &S::yaw_deviation,
                 "Standard deviation of the initial rotation about the vertical (yaw) [{rad}]",
                 {.least = 0})
          .field("velocity_deviation", &S::velocity_deviation,
                 "Standard deviation of the initial velocity [{m/s}]",
                 {.least = 0})
          .field("position_deviation", &S::position_deviation,
                 "Standard deviation of the initial position [{m}]",
                 {.least = 0})
          .field("gyro_bias_deviation", &S::gyro_bias_deviation,
                 "Standard deviation of the gyroscope's initial bias [{rad/s}]",
                 {.least = 0})
          .field("accelerometer_bias_deviation", &S::accelerometer_bias_deviation,
                 "Standard deviation of the accelerometer's initial bias [{m/s^2}]",
                 {.least = 0})
          .group("Faults of the inertial measurement unit.")
          .field("watch", &S::watch,
                 "Monitor that compares the IMU with the feet");
  return all;
}

const Description& description_of(const EstimatorInnovation* /*of*/) {
  using S = EstimatorInnovation;
  static const Description all =
      Describe<S>("estimate", "EstimatorInnovation",
                  "Innovation r of the last update: measured minus predicted positions and "
                  "rotations of the feet.")
          .result()
          .field("squared", &S::squared,
                 "Normalized square r^T S^-1 r, with the covariance S of r")
          .more("If the filter is consistent, this square has a chi-square distribution with "
                "`rows` degrees of freedom.")
          .field("rows", &S::rows,
                 "Number of entries of r that the update used");
  return all;
}

const Description& description_of(const FootContactOptions* /*of*/) {
  using S = FootContactOptions;
  static const Description all =
      Describe<S>("estimate", "FootContactOptions",
                  "Options for detecting standing feet from the force on each foot. Force "
                  "thresholds are fractions of the robot's weight.")
          .field("touch", &S::touch,
                 "Force above which a foot counts as standing, as a fraction of the weight",
                 {.least = 0, .open = true})
          .field("lift", &S::lift,
                 "Force below which a foot counts as in the air, as a fraction of the weight",
                 {.least = 0, .open = true})
          .more("Between `lift` and `touch`, the state of the foot does not change.")
          .field("smoothing", &S::smoothing,
                 "Time constant of the low-pass filter on the forces (0: no filter) [{s}]",
                 {.least = 0})
          .more("The filter is of first order.")
          .field("force_noise", &S::force_noise,
                 "Noise density of the force sensors [{N/sqrt(Hz)}]",
                 {.least = 0})
          .more("The standard deviation of the filtered noise must be at most a quarter of the "
                "gap between the force thresholds `lift` and `touch`.")
          .field("bandwidth", &S::bandwidth,
                 "Bandwidth of the observer that estimates foot forces from joint torques "
                 "[{rad/s}]",
                 {.least = 0, .open = true});
  return all;
}

const Description& description_of(const FrictionEstimateOptions* /*of*/) {
  using S = FrictionEstimateOptions;
  static const Description all =
      Describe<S>("mpc", "FrictionEstimateOptions",
                  "Settings of the Kalman filter that estimates the coefficient of friction "
                  "between tool and surface: uncertainty of the initial coefficient, and noise.")
          .field("enabled", &S::enabled,
                 "Estimate the coefficient; if false, `coefficient` is used unchanged")
          .field("coefficient", &S::coefficient,
                 "Initial coefficient of friction",
                 {.least = 0})
          .more("Plans include friction if this initial value is positive or if `enabled` is true")
          .field("deviation", &S::deviation,
                 "Standard deviation of the initial coefficient",
                 {.least = 0, .open = true})
          .field("wander", &S::wander,
                 "Random-walk intensity of the coefficient over the sliding distance "
                 "[{1/sqrt(m)}]",
                 {.least = 0})
          .field("force_noise", &S::force_noise,
                 "Standard deviation of the measured force along the surface [{N}]",
                 {.least = 0, .open = true})
          .more("The noise of two forces is independent if they are measured more than "
                "`noise_time` apart")
          .field("noise_time", &S::noise_time,
                 "Correlation time of the force noise [{s}]",
                 {.least = 0})
          .field("speed", &S::speed,
                 "Sliding speed below which forces get little weight, because they may be "
                 "stiction [{m/s}]",
                 {.least = 0, .open = true});
  return all;
}

const Description& description_of(const ImuReading* /*of*/) {
  using S = ImuReading;
  static const Description all =
      Describe<S>("estimate", "ImuReading",
                  "Reading of an inertial measurement unit (IMU): mean values since the previous "
                  "reading, in the axes of the IMU frame.")
          .field("gyro", &S::gyro,
                 "Angular velocity [{rad/s}]")
          .field("accelerometer", &S::accelerometer,
                 "Specific force: acceleration minus gravity [{m/s^2}]")
          .more("At rest, this vector points up.");
  return all;
}

const Words& words_of(WrenchSensor /*of*/) {
  static const Words all{
      "mpc",
      "WrenchSensor",
      "Components of a wrench that a sensor measures, or that a controller reads.",
      {{"automatic", "Force of a tool, force and moment of a support"},
       {"none", "No component"},
       {"force", "Force, but no moment"},
       {"wrench", "Force and moment"}}};
  return all;
}

const Description& description_of(const TouchSensor* /*of*/) {
  using S = TouchSensor;
  static const Description all =
      Describe<S>("mpc", "TouchSensor",
                  "Wrench sensor at a touch of the robot (tool, foot or hand).")
          .field("frame", &S::frame,
                 "Frame of the touch")
          .field("sensor", &S::sensor,
                 "Components that the controller reads")
          .more("Automatic: force and moment of a support, only the force of a tool");
  return all;
}

const Description& description_of(const Measurement* /*of*/) {
  using S = Measurement;
  static const Description all =
      Describe<S>("mpc", "Measurement",
                  "Sensor values at one tick.")
          .field("time", &S::time,
                 "Time of the measurement [{s}]")
          .field("q", &S::q,
                 "Measured configuration, nq entries")
          .field("v", &S::v,
                 "Measured velocity, nv entries")
          .field("tau", &S::tau,
                 "Joint torques measured between motor and link, nv entries [{Nm (N)}]")
          .field("wrenches", &S::wrenches,
                 "Measured wrenches that surfaces exert on the robot, one column per entry of "
                 "Controller.touches: force (N), then moment (Nm)")
          .more("Each entry names the frame of a tool, foot or hand. Moments are about the origin"
                " of this frame. Force and moment are in the axes of this frame and exclude the "
                "weight of the tool or foot. Components that no sensor measures are NaN")
          .field("imu", &S::imu,
                 "Reading of the inertial measurement unit; empty if the robot has none")
          .field("base_lost_for", &S::base_lost_for,
                 "Time since the last position estimate of a floating base [{s}]")
          .more("The value 0 means that the estimate is current. While the value is positive, the"
                " floating base's entries of q and v are outdated");
  return all;
}

const Words& words_of(ModelErrorKind /*of*/) {
  static const Words all{
      "mpc",
      "ModelErrorKind",
      "Model error that an MpcController estimates. The error is relative to the commanded torque"
      " and therefore includes errors of the actuators.",
      {{"none", "No estimate, as in the controller of Kleff et al. (docs/frames.md)"},
       {"torque", "Torque error d of each joint, defined by the equation of motion M a + b = tau + J^T f + "
        "d"},
       {"force", "Measured normal force minus the normal force that the model predicts"}}};
  return all;
}

const Description& description_of(const ModelErrorOptions* /*of*/) {
  using S = ModelErrorOptions;
  static const Description all =
      Describe<S>("mpc", "ModelErrorOptions",
                  "Settings of the online estimate of the constant model error. The estimate is "
                  "added to the model (offset-free model predictive control).")
          .field("kind", &S::kind,
                 "Kind of error that is estimated: `none`, `torque` (per joint) or `force` (along"
                 " the normal)")
          .field("bandwidth", &S::bandwidth,
                 "Bandwidth of the observer (automatic: 30; for polishing, fitted to the arm) "
                 "[{rad/s}]",
                 {.least = 0, .open = true})
          .more("A higher bandwidth corrects friction sooner and tolerates less delay. If `kind` "
                "is `force`, the observer closes a loop through the controller, and the delays of"
                " that loop limit the bandwidth. Example: if the force sensor is filtered at 50 "
                "Hz, the loop works at 50 rad/s and oscillates at 100 rad/s.")
          .word("auto")
          .field("transient_scale", &S::transient_scale,
                 "Largest factor on the bandwidth (automatic: 3; for polishing, fitted to the "
                 "arm)",
                 {.least = 0, .open = true})
          .more("The factor rises while a torque error changes faster than its noise: after a "
                "push or an impact, or when a joint reverses. With 1, the bandwidth does not rise")
          .word("auto")
          .field("quiescent_scale", &S::quiescent_scale,
                 "Factor on the bandwidth while the torque error is only noise (1: no reduction)",
                 {.least = 0.01, .most = 1})
          .more("A smaller factor lets less noise pass, such as encoder steps")
          .field("lag", &S::lag,
                 "Lag of velocities behind torques (automatic: 0; for polishing, fitted to the "
                 "arm) [{s}]",
                 {.least = 0})
          .more("Motors and the filters of measured velocities cause the lag. "
                "MpcSpec.command_delay and measurement_delay are not part of the lag")
          .word("auto")
          .field("force_gain", &S::force_gain,
                 "Gain on the normal force error (automatic: 0; for polishing, fitted to the arm)"
                 " [{N/N}]",
                 {.least = 0})
          .more("The product of gain and force error is a commanded force on the tool. The gain "
                "is used only in contact, with a force sensor, and if `kind` is torque")
          .word("auto")
          .field("sliding_bandwidth", &S::sliding_bandwidth,
                 "Bandwidth of the estimate of friction along the surface (0: as `bandwidth`) "
                 "[{rad/s}]",
                 {.least = 0})
          .more("The estimate is made only if `kind` is torque")
          .field("decay_time", &S::decay_time,
                 "Decay time that plans assume for a new torque error, as after a push [{s}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("Errors that have lasted for some seconds do not decay. With an infinite decay "
                "time, no error decays.")
          .field("limit", &S::limit,
                 "Largest magnitude of an estimate [{Nm (N)}]",
                 {.least = 0, .open = true})
          .more("For a floating base, the limit is at least 6 % of the robot's weight")
          .field("joint_friction", &S::joint_friction,
                 "Estimate joint friction separately and feed it forward")
          .more("The compensation changes sign as soon as a joint reverses. It is used only if "
                "`kind` is torque")
          .field("friction_speed", &S::friction_speed,
                 "Joint speed below which the compensation of joint friction fades to zero "
                 "[{rad/s (m/s)}]",
                 {.least = 0, .open = true});
  return all;
}

const Description& description_of(const SlipOptions* /*of*/) {
  using S = SlipOptions;
  static const Description all =
      Describe<S>("mpc", "SlipOptions",
                  "Reaction of plans to a slipping support, such as a foot: plans reduce the "
                  "coefficient of friction of that support. The reduced coefficient is "
                  "`friction_fraction` times the measured ratio of tangential to normal force. "
                  "Without measured forces, the reduced coefficient is `min_friction`. A support "
                  "counts as slipping if its load (if measured), its sliding speed and its "
                  "sliding distance within about a second all exceed their thresholds.")
          .field("enabled", &S::enabled,
                 "Reduce the friction coefficient of supports that slip")
          .field("distance", &S::distance,
                 "Sliding distance above which a support can count as slipping [{m}]",
                 {.least = 0})
          .field("speed", &S::speed,
                 "Sliding speed (mean over 5 ms) above which a support can count as slipping "
                 "[{m/s}]",
                 {.least = 0})
          .field("load", &S::load,
                 "Load above which a support can count as slipping [{N}]",
                 {.least = 0})
          .field("friction_fraction", &S::friction_fraction,
                 "Reduced friction coefficient, as a fraction of the measured ratio of tangential"
                 " to normal force of the slipping support",
                 {.least = 0, .most = 1})
          .field("min_friction", &S::min_friction,
                 "Lower limit of the reduced friction coefficient",
                 {.least = 0, .open = true})
          .field("easing", &S::easing,
                 "Time constant of the reduction of the friction coefficient [{s}]",
                 {.least = 0})
          .more("Without measured forces, the time constant is doubled. The reduction is gradual,"
                " because the solver would not find a good plan after an abrupt change")
          .field("recovery", &S::recovery,
                 "Rate at which the friction coefficient recovers while the support does not slip"
                 " [{1/s}]",
                 {.least = 0})
          .field("radius", &S::radius,
                 "Radius of spherical feet (0: feet are not spherical) [{m}]",
                 {.least = 0})
          .more("Rolling of a spherical foot does not count as slipping");
  return all;
}

const Description& description_of(const SurfaceEstimateOptions* /*of*/) {
  using S = SurfaceEstimateOptions;
  static const Description all =
      Describe<S>("pressing", "SurfaceEstimateOptions",
                  "Settings of the Kalman filter that estimates the surface under a sliding tool "
                  "from the path of the tool: uncertainty of the initial surface, and noise.")
          .field("enabled", &S::enabled,
                 "Estimate the surface; if false, the initial surface is used unchanged")
          .field("height", &S::height,
                 "Standard deviation of the initial surface's height [{m}]",
                 {.least = 0, .open = true})
          .field("tilt", &S::tilt,
                 "Standard deviation of the initial normal's tilt about each tangent [{rad}]",
                 {.least = 0, .open = true})
          .field("curvature", &S::curvature,
                 "Standard deviation of the initial curvatures [{1/m}]",
                 {.least = 0, .open = true})
          .more("The filter adds a quarter of the magnitude of the initial curvatures to this "
                "value")
          .field("curvature_change", &S::curvature_change,
                 "Random-walk intensity of the curvatures over the travelled distance "
                 "[{1/m/sqrt(m)}]",
                 {.least = 0, .open = true})
          .field("position_noise", &S::position_noise,
                 "Standard deviation of position noise that is correlated along the path [{m}]",
                 {.least = 0, .open = true})
          .more("The noise is along the surface normal. The filter itself estimates the "
                "additional noise that is uncorrelated from tick to tick")
          .field("noise_length", &S::noise_length,
                 "Correlation length of position noise, such as the tip motion per encoder step "
                 "[{m}]",
                 {.least = 0, .open = true})
          .field("force_noise", &S::force_noise,
                 "Standard deviation of the force along the normal [{N}]",
                 {.least = 0, .open = true})
          .field("compliance", &S::compliance,
                 "Standard deviation of the initial compliance of the surface under the tip "
                 "[{m/N}]",
                 {.least = 0, .open = true})
          .more("The initial compliance is 0")
          .field("rate", &S::rate,
                 "Standard deviation of the surface's velocity along its normal (0: surface at "
                 "rest) [{m/s}]",
                 {.least = 0})
          .more("A moving surface can be distinguished from a slope only after the tip has "
                "changed direction");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
