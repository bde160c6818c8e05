#include "estimate/descriptions.hpp"

namespace burnish {

const Words& words_of(FootKind /*of*/) {
  static const Words all{
      "estimate",
      "FootKind",
      "What of a foot stays where it is while the foot stands.",
      {{"ball", "the frame's origin"}, {"sole", "the frame: it neither moves nor turns"}}};
  return all;
}

const Description& description_of(const ImuReading* /*of*/) {
  using I = ImuReading;
  static const Description all =
      Describe<I>("estimate", "ImuReading",
                  "What an inertial measurement unit says, in the axes of the frame that it stands "
                  "for: means over the time since the reading before.")
          .field("gyro", &I::gyro, "{rad/s}")
          .field(
              "accelerometer", &I::accelerometer,
              "{m/s^2}, specific force: acceleration minus gravity, so that at rest it points up");
  return all;
}

const Description& description_of(const FootSpec* /*of*/) {
  static const Description all =
      Describe<FootSpec>("estimate", "FootSpec", "A foot that may stand.")
          .field("frame", &FootSpec::frame, "of a ball its middle, where it rolls little")
          .required()
          .field("kind", &FootSpec::kind, "ball, whose origin stays, or sole, which does not turn");
  return all;
}

const Description& description_of(const UnitWatchOptions* /*of*/) {
  using U = UnitWatchOptions;
  constexpr Range size = range::positive;
  static const Description all =
      Describe<U>("estimate", "UnitWatchOptions",
                  "What is taken for an inertial measurement unit that is wrong, while feet stand.")
          .field("enabled", &U::enabled,
                 "look at what the unit says; else only whether it says anything")
          .field("window", &U::window, "{s} over which the unit and the feet are compared", size)
          .field("turn", &U::turn, "{rad} that they may differ by in it, beside noise and biases",
                 size)
          .field("place", &U::place, "{m}, likewise", size)
          .field("rate", &U::rate,
                 "{rad/s} beyond the feet's that are not believed before that is clear", size)
          .field("feet_turn", &U::feet_turn,
                 "{rad} that a sole may turn against the others and stand", size)
          .field("feet_place", &U::feet_place,
                 "{m} that a foot may move against the others and stand", size)
          .field("silent_after", &U::silent_after,
                 "{s} without a reading, after which there is none", range::not_negative)
          .field("back_after", &U::back_after,
                 "{s} that a unit has to agree with the feet before it counts again", size)
          .field("fading", &U::fading,
                 "{s} in which the difference is made up when the feet take over", size);
  return all;
}

// NOLINTNEXTLINE(readability-function-size): a table
const Description& description_of(const BaseEstimatorOptions* /*of*/) {
  using B = BaseEstimatorOptions;
  constexpr Range size = range::not_negative, deviation = range::positive;
  static const Description all =
      Describe<B>("estimate", "BaseEstimatorOptions",
                  "How the floating base is estimated. Noise is white where it is a density, a "
                  "deviation per square root of Hz: a reading every dt s has the density times "
                  "1/sqrt(dt).")
          .field("imu_frame", &B::imu_frame,
                 "frame of the measurement unit, whose axes its readings have; empty: the floating "
                 "base's body")
          .field("feet", &B::feet, "that may stand, up to 32")
          .group("Noise.")
          .field("gyro_noise", &B::gyro_noise, "{rad/s/sqrt(Hz)}", size)
          .field("accelerometer_noise", &B::accelerometer_noise, "{m/s^2/sqrt(Hz)}", size)
          .field("gyro_bias_walk", &B::gyro_bias_walk,
                 "{rad/s^2/sqrt(Hz)} that the bias walks with", size)
          .field("accelerometer_bias_walk", &B::accelerometer_bias_walk,
                 "{m/s^3/sqrt(Hz)} that the bias walks with", size)
          .field("encoder_noise", &B::encoder_noise, "{rad (m)}, deviation of a reading", size)
          .field("place_noise", &B::place_noise,
                 "{m}, deviation per reading of a foot's place, beside encoders", deviation)
          .field("turn_noise", &B::turn_noise,
                 "{rad}, deviation per reading of a sole's rotation, likewise", deviation)
          .field("slip_noise", &B::slip_noise, "{m/s/sqrt(Hz)} that a foot creeps with", size)
          .field("sole_turn_noise", &B::sole_turn_noise, "{rad/s/sqrt(Hz)} that a sole creeps with",
                 size)
          .group("Feet that slip.")
          .field("gate", &B::gate, "share of a foot's readings that pass while it stands still",
                 range::between(0, 1))
          .field("rejoin_after", &B::rejoin_after,
                 "{s} that a foot which slipped has to rest before it counts again", size)
          .field("rejoin_speed", &B::rejoin_speed, "{m/s} below which it rests", deviation)
          .field("lost_after", &B::lost_after,
                 "{s} without any foot that counts while some stand, after which it is not they "
                 "that are taken to slip, but the base's velocity to be wrong",
                 size)
          .group("Of what reset() is told.")
          .field("tilt_deviation", &B::tilt_deviation,
                 "{rad}, of what reset() is told, about horizontal axes", size)
          .field("yaw_deviation", &B::yaw_deviation, "{rad}, likewise about the vertical", size)
          .field("velocity_deviation", &B::velocity_deviation, "{m/s}, likewise", size)
          .field("position_deviation", &B::position_deviation, "{m}, likewise", size)
          .field("gyro_bias_deviation", &B::gyro_bias_deviation, "{rad/s}, likewise", size)
          .field("accelerometer_bias_deviation", &B::accelerometer_bias_deviation,
                 "{m/s^2}, likewise", size)
          .group("A unit that goes wrong.")
          .field("watch", &B::watch, "of the unit, by the feet");
  return all;
}

const Description& description_of(const EstimatorInnovation* /*of*/) {
  using I = EstimatorInnovation;
  static const Description all =
      Describe<I>("estimate", "EstimatorInnovation",
                  "Of the readings of feet at the last update, against what was expected.")
          .result()
          .field("squared", &I::squared,
                 "r^T S^-1 r, as a chi-square of `rows` degrees where the filter is right")
          .field("rows", &I::rows, "that were used");
  return all;
}

const Description& description_of(const FootContactOptions* /*of*/) {
  using F = FootContactOptions;
  static const Description all =
      Describe<F>("estimate", "FootContactOptions",
                  "Which feet stand, by the force on each. Shares are of the robot's weight.")
          .field("touch", &F::touch, "share of the weight on a foot above which it stands",
                 range::positive)
          .field("lift", &F::lift,
                 "share below which it is in the air; between them it stays as it was",
                 range::positive)
          .field("smoothing", &F::smoothing, "{s}, of a first-order low-pass on forces; 0: none",
                 range::not_negative)
          .field("force_noise", &F::force_noise,
                 "{N/sqrt(Hz)}, of the force sensors; behind the low-pass it is to be a quarter of "
                 "what lies between `touch` and `lift` at most",
                 range::not_negative)
          .field("bandwidth", &F::bandwidth,
                 "{rad/s}, low-pass of forces that are told from torques (FootForces)",
                 range::positive);
  return all;
}

}  // namespace burnish
