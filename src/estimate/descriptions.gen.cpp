// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "estimate/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Words& words_of(FootKind /*of*/) {
  static const Words all{
      "estimate",
      "FootKind",
      "Kind of a robot's foot: which of its motions are zero while the foot stands.",
      {{"ball", "Point foot: the origin of its frame does not move"},
       {"sole", "Planar foot: its frame neither moves nor rotates"}}};
  return all;
}

const Description& description_of(const FootSpec* /*of*/) {
  using S = FootSpec;
  static const Description all =
      Describe<S>("estimate", "FootSpec",
                  "Foot of a robot. The estimator uses the foot while it stands on the ground.")
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
                 "Decay time of the jump when the feet replace a faulty IMU [{s}]",
                 {.least = 0, .open = true})
          .more("The jump is the difference between the last estimate and the estimate from the "
                "feet.");
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
                 "Fraction of the readings of a resting foot that the outlier test accepts",
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
                "gap between the forces of `lift` and `touch`.")
          .field("bandwidth", &S::bandwidth,
                 "Bandwidth of the observer that estimates foot forces from joint torques "
                 "[{rad/s}]",
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
          .more("At rest, it points up.");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
