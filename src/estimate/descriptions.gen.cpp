// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "estimate/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Words& words_of(FootKind /*of*/) {
  static const Words all{
      "estimate",
      "FootKind",
      "What of a foot stays where it is while the foot stands.",
      {{"ball", "the frame's origin"},
       {"sole", "the frame: it neither moves nor turns"}}};
  return all;
}

const Description& description_of(const FootSpec* /*of*/) {
  using S = FootSpec;
  static const Description all =
      Describe<S>("estimate", "FootSpec",
                  "A foot that may stand.")
          .field("frame", &S::frame,
                 "of a ball its middle, where it rolls little")
          .required()
          .field("kind", &S::kind,
                 "ball, whose origin stays, or sole, which does not turn");
  return all;
}

const Description& description_of(const UnitWatchOptions* /*of*/) {
  using S = UnitWatchOptions;
  static const Description all =
      Describe<S>("estimate", "UnitWatchOptions",
                  "Thresholds by which a faulty inertial measurement unit is found while feet "
                  "stand.")
          .field("enabled", &S::enabled,
                 "compare the unit with the feet; else find only a unit that is silent")
          .field("window", &S::window,
                 "{s} over which the unit and the feet are compared",
                 {.least = 0, .open = true})
          .field("turn", &S::turn,
                 "{rad} that they may differ by in it, beside noise and biases",
                 {.least = 0, .open = true})
          .field("place", &S::place,
                 "{m}, likewise",
                 {.least = 0, .open = true})
          .field("rate", &S::rate,
                 "Turn rate in excess of the feet's that is not used until it is clear which of "
                 "both is wrong [{rad/s}]",
                 {.least = 0, .open = true})
          .field("feet_turn", &S::feet_turn,
                 "{rad} that a sole may turn against the others and stand",
                 {.least = 0, .open = true})
          .field("feet_place", &S::feet_place,
                 "{m} that a foot may move against the others and stand",
                 {.least = 0, .open = true})
          .field("silent_after", &S::silent_after,
                 "{s} without a reading, after which there is none",
                 {.least = 0})
          .field("back_after", &S::back_after,
                 "{s} that a unit has to agree with the feet before it counts again",
                 {.least = 0, .open = true})
          .field("fading", &S::fading,
                 "{s} in which the difference is made up when the feet take over",
                 {.least = 0, .open = true});
  return all;
}

const Description& description_of(const BaseEstimatorOptions* /*of*/) {
  using S = BaseEstimatorOptions;
  static const Description all =
      Describe<S>("estimate", "BaseEstimatorOptions",
                  "How the floating base is estimated. Noise is white where it is a density, a "
                  "deviation per square root of Hz: a reading every dt s has the density times "
                  "1/sqrt(dt).")
          .field("imu_frame", &S::imu_frame,
                 "frame of the measurement unit, whose axes its readings have; empty: the "
                 "floating base's body")
          .field("feet", &S::feet,
                 "that may stand, up to 32")
          .group("Noise.")
          .field("gyro_noise", &S::gyro_noise,
                 "{rad/s/sqrt(Hz)}",
                 {.least = 0})
          .field("accelerometer_noise", &S::accelerometer_noise,
                 "{m/s^2/sqrt(Hz)}",
                 {.least = 0})
          .field("gyro_bias_walk", &S::gyro_bias_walk,
                 "{rad/s^2/sqrt(Hz)} that the bias walks with",
                 {.least = 0})
          .field("accelerometer_bias_walk", &S::accelerometer_bias_walk,
                 "{m/s^3/sqrt(Hz)} that the bias walks with",
                 {.least = 0})
          .field("encoder_noise", &S::encoder_noise,
                 "{rad (m)}, deviation of a reading",
                 {.least = 0})
          .field("place_noise", &S::place_noise,
                 "{m}, deviation per reading of a foot's place, beside encoders",
                 {.least = 0, .open = true})
          .field("turn_noise", &S::turn_noise,
                 "{rad}, deviation per reading of a sole's rotation, likewise",
                 {.least = 0, .open = true})
          .field("slip_noise", &S::slip_noise,
                 "{m/s/sqrt(Hz)} that a foot creeps with",
                 {.least = 0})
          .field("sole_turn_noise", &S::sole_turn_noise,
                 "{rad/s/sqrt(Hz)} that a sole creeps with",
                 {.least = 0})
          .group("Feet that slip.")
          .field("gate", &S::gate,
                 "share of a foot's readings that pass while it stands still",
                 {.least = 0, .most = 1, .open = true})
          .field("rejoin_after", &S::rejoin_after,
                 "{s} that a foot which slipped has to rest before it counts again",
                 {.least = 0})
          .field("rejoin_speed", &S::rejoin_speed,
                 "{m/s} below which it rests",
                 {.least = 0, .open = true})
          .field("lost_after", &S::lost_after,
                 "Time for which feet stand and all of them seem to slip [{s}], after which the "
                 "base's velocity is taken to be wrong instead",
                 {.least = 0})
          .group("Of what reset() is told.")
          .field("tilt_deviation", &S::tilt_deviation,
                 "{rad}, of what reset() is told, about horizontal axes",
                 {.least = 0})
          .field("yaw_deviation", &S::yaw_deviation,
                 "{rad}, likewise about the vertical",
                 {.least = 0})
          .field("velocity_deviation", &S::velocity_deviation,
                 "{m/s}, likewise",
                 {.least = 0})
          .field("position_deviation", &S::position_deviation,
                 "{m}, likewise",
                 {.least = 0})
          .field("gyro_bias_deviation", &S::gyro_bias_deviation,
                 "{rad/s}, likewise",
                 {.least = 0})
          .field("accelerometer_bias_deviation", &S::accelerometer_bias_deviation,
                 "{m/s^2}, likewise",
                 {.least = 0})
          .group("A unit that goes wrong.")
          .field("watch", &S::watch,
                 "of the unit, by the feet");
  return all;
}

const Description& description_of(const EstimatorInnovation* /*of*/) {
  using S = EstimatorInnovation;
  static const Description all =
      Describe<S>("estimate", "EstimatorInnovation",
                  "Of the readings of feet at the last update, against what was expected.")
          .result()
          .field("squared", &S::squared,
                 "r^T S^-1 r, as a chi-square of `rows` degrees where the filter is right")
          .field("rows", &S::rows,
                 "that were used");
  return all;
}

const Description& description_of(const FootContactOptions* /*of*/) {
  using S = FootContactOptions;
  static const Description all =
      Describe<S>("estimate", "FootContactOptions",
                  "Which feet stand, by the force on each. Shares are of the robot's weight.")
          .field("touch", &S::touch,
                 "share of the weight on a foot above which it stands",
                 {.least = 0, .open = true})
          .field("lift", &S::lift,
                 "share below which it is in the air; between them it stays as it was",
                 {.least = 0, .open = true})
          .field("smoothing", &S::smoothing,
                 "{s}, of a first-order low-pass on forces; 0: none",
                 {.least = 0})
          .field("force_noise", &S::force_noise,
                 "{N/sqrt(Hz)}, of the force sensors; behind the low-pass it is to be a quarter "
                 "of what lies between `touch` and `lift` at most",
                 {.least = 0})
          .field("bandwidth", &S::bandwidth,
                 "{rad/s}, low-pass of forces that are told from torques (FootForces)",
                 {.least = 0, .open = true});
  return all;
}

const Description& description_of(const ImuReading* /*of*/) {
  using S = ImuReading;
  static const Description all =
      Describe<S>("estimate", "ImuReading",
                  "What an inertial measurement unit says, in the axes of the frame that it "
                  "stands for: means over the time since the reading before.")
          .field("gyro", &S::gyro,
                 "{rad/s}")
          .field("accelerometer", &S::accelerometer,
                 "{m/s^2}, specific force: acceleration minus gravity, so that at rest it points "
                 "up");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
