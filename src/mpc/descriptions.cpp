#include "mpc/descriptions.hpp"

namespace burnish {

const Words& words_of(ModelErrorKind /*of*/) {
  static const Words all{
      "mpc",
      "ModelErrorKind",
      "What an MpcController estimates of what its model gets wrong. Both are relative to the "
      "torque "
      "that was commanded, so that what actuators get wrong is part of them.",
      {{"none", "nothing: the paper's controller"},
       {"torque", "d in M a + b = tau + J^T f + d, a torque per joint"},
       {"force", "what the measured normal force is above the one that the model predicts"}}};
  return all;
}

const Description& description_of(const ModelErrorOptions* /*of*/) {
  using M = ModelErrorOptions;
  static const Description all =
      Describe<M>("mpc", "ModelErrorOptions",
                  "The constant part of what the model gets wrong, estimated from measurements and "
                  "given back to the model (offset-free model predictive control).")
          .field("kind", &M::kind, "none, torque (per joint) or force (along the normal)")
          .field("bandwidth", &M::bandwidth,
                 "{rad/s} of the observer; more follows friction, and bears less delay",
                 range::positive)
          .more(
              "Force closes a loop through the controller and is not to be faster than its delays "
              "bear: behind a force sensor filtered at 50 Hz, 50 rad/s are well, 100 rad/s "
              "oscillate.")
          .field("limit", &M::limit, "{Nm (N)}: estimates stay within +- this", range::positive);
  return all;
}

const Description& description_of(const SafetyLimits* /*of*/) {
  using S = SafetyLimits;
  constexpr Range limit = range::positive_or_infinite, count = range::from(1);
  static const Description all =
      Describe<S>(
          "mpc", "SafetyLimits",
          "When a run is given up, whatever the task; the task's own limits are its. Infinite: "
          "never.")
          .field("joint_speed_ratio", &S::joint_speed_ratio, "of the robot's velocity limits",
                 limit)
          .field("joint_margin", &S::joint_margin, "{rad} that a joint may be beyond its limit",
                 range::not_negative)
          .more("m of prismatic joints")
          .field("stale", &S::stale, "{s} without a new measurement", limit)
          .more("longer than a tick")
          .field("bad", &S::bad, "{s} of measurements that are no state", limit)
          .more("which the last good one bridges")
          .field("failed_solves", &S::failed_solves, "in a row", count)
          .more("the first solve may not fail")
          .field("deadline", &S::deadline, "{s} of computing time per plan",
                 range::not_negative_or_infinite)
          .more("of wall clock; the first one, made at rest, may take longer")
          .field("late_solves", &S::late_solves, "in a row", count);
  return all;
}

const Description& description_of(const Fallback* /*of*/) {
  using F = Fallback;
  static const Description all =
      Describe<F>(
          "mpc", "Fallback",
          "How the robot is brought to rest after a fault, and held there: tau = b(q, 0) - M "
          "(stiffness e + damping v) on the actuated joints, e = q (-) q_hold, within the "
          "torque limits. q_hold is where the robot was at the fault, and slips where the "
          "spring would use more than `give` of a joint's effort limit.")
          .field("stiffness", &F::stiffness,
                 "{1/s^2}, times the mass matrix; 0: nothing holds, the arm is braked only",
                 range::not_negative)
          .field("damping", &F::damping, "{1/s}, times the mass matrix", range::not_negative)
          .field("give", &F::give, "of the torque limits, where the spring slips; 0 to 1",
                 range::share);
  return all;
}

}  // namespace burnish
