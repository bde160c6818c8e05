// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "contact/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
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
  using S = SlidingFriction;
  static const Description all =
      Describe<S>("contact", "SlidingFriction",
                  "Coulomb's, of a tool that slides: beside lambda along the held normal, on the "
                  "tool acts -coefficient lambda v_t / sqrt(|v_t|^2 + speed^2), v_t being the "
                  "velocity across the normal, seen from the base, of the tool's point where it "
                  "acts.")
          .field("coefficient", &S::coefficient,
                 "0: none, until it is set",
                 {.least = 0})
          .field("speed", &S::speed,
                 "{m/s}, below which it fades, so that it has a derivative at rest; none: in a "
                 "problem what its steps tolerate, elsewhere 0.01",
                 {.least = 0, .open = true})
          .word("none")
          .field("radius", &S::radius,
                 "{m} from the tool's origin against the normal to where it acts: of a round tip",
                 {.least = 0});
  return all;
}

const Description& description_of(const ContactSpec* /*of*/) {
  using S = ContactSpec;
  static const Description all =
      Describe<S>("contact", "ContactSpec",
                  "A tool frame tied to a base frame along some directions: alpha + kd nu + kp e "
                  "= 0, nu and alpha being velocity and acceleration of the tool relative to the "
                  "base, in the reference.")
          .field("name", &S::name,
                 "unique; the tool's name if left empty")
          .field("tool", &S::tool,
                 "frame C2")
          .field("base", &S::base,
                 "frame C1; \"world\" is always known")
          .field("reference", &S::reference)
          .field("directions", &S::directions,
                 "\"all\", \"linear\", \"angular\", \"pad_x|y|z\", or names separated by commas "
                 "such as \"z,rx,ry\"")
          .field("acceleration", &S::acceleration)
          .field("error", &S::error)
          .field("kp", &S::kp,
                 "{1/s^2}, by direction; only entries of held directions are used")
          .field("kd", &S::kd,
                 "{1/s}")
          .field("target", &S::target,
                 "Placement of C2 in C1 that the error is measured from.")
          .field("friction", &S::friction,
                 "none: the tool slides freely");
  return all;
}

const Description& description_of(const ContactForce* /*of*/) {
  using S = ContactForce;
  static const Description all =
      Describe<S>("contact", "ContactForce",
                  "The wrench that the base exerts on the tool, at one state.")
          .result()
          .field("contact", &S::contact,
                 "name of the contact")
          .field("on", &S::on,
                 "tool frame C2: the body acted on")
          .field("by", &S::by,
                 "base frame C1: the body that acts, \"world\" for the environment")
          .field("reference", &S::reference,
                 "in which `value` is written")
          .field("value", &S::value,
                 "force (N), then moment about the reference's origin (Nm)")
          .field("tool_rotation", &S::tool_rotation,
                 "world axes, at that state")
          .field("base_rotation", &S::base_rotation)
          .field("tool_position", &S::tool_position,
                 "{m}")
          .field("base_position", &S::base_position)
          .field("frame_rotation", &S::frame_rotation)
          .field("frame_position", &S::frame_position);
  return all;
}

const Description& description_of(const ContactSolver* /*of*/) {
  using S = ContactSolver;
  static const Description all =
      Describe<S>("contact", "ContactSolver",
                  "The KKT system of eq. (3) and its relaxation.")
          .field("mu", &S::mu,
                 "Compliance, the lower right block -mu 1 of the KKT matrix. 0: the exact system,"
                 " which needs independent rows. Positive: any rows, m/s^2 per unit force.",
                 {.least = 0})
          .field("max_proximal_iterations", &S::max_proximal_iterations,
                 "With mu > 0: refinements lambda <- G^-1 (rho + mu lambda), at most; they remove"
                 " the compliance while it lasts. 0 keeps the compliant solution.",
                 {.least = 0})
          .field("proximal_tolerance", &S::proximal_tolerance,
                 "The iterations stop when every |mu (lambda - previous)| <= this, m/s^2: what is"
                 " left of the contact acceleration.",
                 {.least = 0});
  return all;
}

const Description& description_of(const LoopGains* /*of*/) {
  using S = LoopGains;
  static const Description all =
      Describe<S>("contact", "LoopGains",
                  "How a loop that has drifted comes back: alpha + kd nu + kp e = 0.")
          .field("kp", &S::kp,
                 "{1/s^2}",
                 {.least = 0})
          .field("kd", &S::kd,
                 "{1/s}",
                 {.least = 0});
  return all;
}

const Description& description_of(const RedundantLoop* /*of*/) {
  using S = RedundantLoop;
  static const Description all =
      Describe<S>("contact", "RedundantLoop",
                  "Rows of a loop that those of its other directions, or of other loops, imply.")
          .result()
          .field("loop", &S::loop)
          .field("directions", &S::directions);
  return all;
}

const Description& description_of(const LoopFreedom* /*of*/) {
  using S = LoopFreedom;
  static const Description all =
      Describe<S>("contact", "LoopFreedom",
                  "What loops leave of the freedom of a robot.")
          .result()
          .field("rows", &S::rows,
                 "of all loops as described")
          .field("rank", &S::rank,
                 "of their Jacobian")
          .field("freedom", &S::freedom,
                 "nv - rank")
          .field("redundant", &S::redundant,
                 "loops that have some");
  return all;
}

const Description& description_of(const LoopProjectionOptions* /*of*/) {
  using S = LoopProjectionOptions;
  static const Description all =
      Describe<S>("contact", "LoopProjectionOptions",
                  "How a posture is moved onto the loops.")
          .field("keep", &S::keep,
                 "Joints that stay where they are.")
          .field("weights", &S::weights,
                 "How dear a change of each entry of v is, nv positive numbers, or empty: all "
                 "alike.")
          .field("tolerance", &S::tolerance,
                 "m and rad, of every row",
                 {.least = 0, .open = true})
          .field("max_iterations", &S::max_iterations,
                 "of all attempts",
                 {.least = 1})
          .field("within_limits", &S::within_limits,
                 "Revolute and prismatic joints stay within their limits, or where they start "
                 "beyond them.");
  return all;
}

const Description& description_of(const LoopMiss* /*of*/) {
  using S = LoopMiss;
  static const Description all =
      Describe<S>("contact", "LoopMiss",
                  "How far a loop is from closed.")
          .result()
          .field("loop", &S::loop)
          .field("translation", &S::translation,
                 "{m}, along the held directions")
          .field("rotation", &S::rotation,
                 "{rad}, about the held directions");
  return all;
}

const Description& description_of(const LoopProjection* /*of*/) {
  using S = LoopProjection;
  static const Description all =
      Describe<S>("contact", "LoopProjection",
                  "A posture that closes the loops, or the nearest to one that was found.")
          .result()
          .field("q", &S::q,
                 "nq")
          .field("misses", &S::misses,
                 "what is left, per loop")
          .field("iterations", &S::iterations)
          .field("status", &S::status,
                 "NotConverged: some loop is not closed");
  return all;
}

const Words& words_of(LoopMetric /*of*/) {
  static const Words all{
      "contact",
      "LoopMetric",
      "What a change of velocity is measured by.",
      {{"plain", "|dv|^2, rad/s and m/s alike"},
       {"mass", "dv^T M dv: what impulses in the loops do"}}};
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
