#include "contact/descriptions.hpp"

namespace burnish {

const Words& words_of(Acceleration /*of*/) {
  static const Words all{
      "contact",
      "Acceleration",
      "Which acceleration of the tool a contact prescribes.",
      {{"time_derivative", "the true derivative of the constraint velocity"},
       {"spatial", "the tool's local spatial acceleration carried into the axes (Proposition 3)"},
       {"classical", "of the material point, written in the axes"}}};
  return all;
}

const Words& words_of(PoseError /*of*/) {
  static const Words all{
      "contact",
      "PoseError",
      "Position-level error that the proportional gain acts on.",
      {{"split", "position error, and the logarithm of the rotation error"},
       {"log6", "the SE(3) logarithm in tool axes, carried into the contact's axes"}}};
  return all;
}

const Description& description_of(const SlidingFriction* /*of*/) {
  using F = SlidingFriction;
  static const Description all =
      Describe<F>("contact", "SlidingFriction",
                  "Coulomb's, of a tool that slides: beside lambda along the held normal, on the "
                  "tool acts -coefficient lambda v_t / sqrt(|v_t|^2 + speed^2), v_t being the "
                  "velocity across the normal, seen from the base, of the tool's point where it "
                  "acts.")
          .field("coefficient", &F::coefficient, "0: none, until it is set", range::not_negative)
          .field("speed", &F::speed,
                 "{m/s}, below which it fades, so that it has a derivative at rest; none: in a "
                 "problem what its steps tolerate, elsewhere 0.01",
                 range::positive)
          .word("none")
          .field("radius", &F::radius,
                 "{m} from the tool's origin against the normal to where it acts: of a round tip",
                 range::not_negative);
  return all;
}

const Description& description_of(const ContactSpec* /*of*/) {
  using C = ContactSpec;
  static const Description all =
      Describe<C>("contact", "ContactSpec",
                  "A tool frame tied to a base frame along some directions: alpha + kd nu + kp e = "
                  "0, nu and alpha being velocity and acceleration of the tool relative to the "
                  "base, in the reference.")
          .field("name", &C::name, "unique; the tool's name if left empty")
          .field("tool", &C::tool, "frame C2")
          .field("base", &C::base, "frame C1; \"world\" is always known")
          .field("reference", &C::reference)
          .field("directions", &C::directions,
                 "\"all\", \"linear\", \"angular\", \"pad_x|y|z\", or names separated by commas "
                 "such as \"z,rx,ry\"")
          .field("acceleration", &C::acceleration)
          .field("error", &C::error)
          .field("kp", &C::kp, "{1/s^2}, by direction; only entries of held directions are used")
          .field("kd", &C::kd, "{1/s}")
          .field("target", &C::target, "Placement of C2 in C1 that the error is measured from.")
          .field("friction", &C::friction, "none: the tool slides freely");
  return all;
}

const Description& description_of(const ContactSolver* /*of*/) {
  using C = ContactSolver;
  static const Description all =
      Describe<C>("contact", "ContactSolver", "The KKT system of eq. (3) and its relaxation.")
          .field("mu", &C::mu,
                 "Compliance, the lower right block -mu 1 of the KKT matrix. 0: the exact system, "
                 "which needs independent rows. Positive: any rows, m/s^2 per unit force.",
                 range::not_negative)
          .field("max_proximal_iterations", &C::max_proximal_iterations,
                 "With mu > 0: refinements lambda <- G^-1 (rho + mu lambda), at most; they remove "
                 "the compliance while it lasts. 0 keeps the compliant solution.",
                 range::from(0))
          .field("proximal_tolerance", &C::proximal_tolerance,
                 "The iterations stop when every |mu (lambda - previous)| <= this, m/s^2: what is "
                 "left of the contact acceleration.",
                 range::not_negative);
  return all;
}

const Description& description_of(const ContactForce* /*of*/) {
  using C = ContactForce;
  static const Description all =
      Describe<C>("contact", "ContactForce",
                  "The wrench that the base exerts on the tool, at one state.")
          .result()
          .field("contact", &C::contact, "name of the contact")
          .field("on", &C::on, "tool frame C2: the body acted on")
          .field("by", &C::by, "base frame C1: the body that acts, \"world\" for the environment")
          .field("reference", &C::reference, "in which `value` is written")
          .field("value", &C::value, "force (N), then moment about the reference's origin (Nm)")
          .field("tool_rotation", &C::tool_rotation, "world axes, at that state")
          .field("base_rotation", &C::base_rotation,
                 "Poses at that state, world axes, with which the force converts itself. `frame` "
                 "is what `reference` names: the rotation of its axes' frame, the position of its "
                 "origin's.")
          .field("tool_position", &C::tool_position, "{m}")
          .field("base_position", &C::base_position)
          .field("frame_rotation", &C::frame_rotation)
          .field("frame_position", &C::frame_position);
  return all;
}

const Words& words_of(LoopMetric /*of*/) {
  static const Words all{"contact",
                         "LoopMetric",
                         "What a change of velocity is measured by.",
                         {{"plain", "|dv|^2, rad/s and m/s alike"},
                          {"mass", "dv^T M dv: what impulses in the loops do"}}};
  return all;
}

const Description& description_of(const LoopGains* /*of*/) {
  using G = LoopGains;
  static const Description all =
      Describe<G>("contact", "LoopGains",
                  "How a loop that has drifted comes back: alpha + kd nu + kp e = 0.")
          .field("kp", &G::kp, "{1/s^2}", range::not_negative)
          .field("kd", &G::kd, "{1/s}", range::not_negative);
  return all;
}

const Description& description_of(const RedundantLoop* /*of*/) {
  using R = RedundantLoop;
  static const Description all =
      Describe<R>("contact", "RedundantLoop",
                  "Rows of a loop that those of its other directions, or of other loops, imply.")
          .result()
          .field("loop", &R::loop)
          .field("directions", &R::directions);
  return all;
}

const Description& description_of(const LoopFreedom* /*of*/) {
  using F = LoopFreedom;
  static const Description all =
      Describe<F>("contact", "LoopFreedom", "What loops leave of the freedom of a robot.")
          .result()
          .field("rows", &F::rows, "of all loops as described")
          .field("rank", &F::rank, "of their Jacobian")
          .field("freedom", &F::freedom, "nv - rank")
          .field("redundant", &F::redundant, "loops that have some");
  return all;
}

const Description& description_of(const LoopProjectionOptions* /*of*/) {
  using O = LoopProjectionOptions;
  static const Description all =
      Describe<O>("contact", "LoopProjectionOptions", "How a posture is moved onto the loops.")
          .field("keep", &O::keep, "Joints that stay where they are.")
          .field("weights", &O::weights,
                 "How dear a change of each entry of v is, nv positive numbers, or empty: all "
                 "alike.")
          .field("tolerance", &O::tolerance, "m and rad, of every row", range::positive)
          .field("max_iterations", &O::max_iterations, "of all attempts", Range{.least = 1.0})
          .field("within_limits", &O::within_limits,
                 "Revolute and prismatic joints stay within their limits, or where they start "
                 "beyond them.");
  return all;
}

const Description& description_of(const LoopMiss* /*of*/) {
  using M = LoopMiss;
  static const Description all =
      Describe<M>("contact", "LoopMiss", "How far a loop is from closed.")
          .result()
          .field("loop", &M::loop)
          .field("translation", &M::translation, "{m}, along the held directions")
          .field("rotation", &M::rotation, "{rad}, about the held directions");
  return all;
}

const Description& description_of(const LoopProjection* /*of*/) {
  using P = LoopProjection;
  static const Description all =
      Describe<P>("contact", "LoopProjection",
                  "A posture that closes the loops, or the nearest to one that was found.")
          .result()
          .field("q", &P::q, "nq")
          .field("misses", &P::misses, "what is left, per loop")
          .field("iterations", &P::iterations)
          .field("status", &P::status, "NotConverged: some loop is not closed");
  return all;
}

}  // namespace burnish
