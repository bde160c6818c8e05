// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "contact/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Words& words_of(Acceleration /*of*/) {
  static const Words all{
      "contact",
      "Acceleration",
      "Kind of tool acceleration that a contact prescribes.",
      {{"time_derivative", "True time derivative of the contact velocity"},
       {"spatial", "Spatial acceleration of the tool in tool axes, transformed to contact axes"},
       {"classical", "Acceleration of the tool's material point, in contact axes"}}};
  return all;
}

const Words& words_of(PoseError /*of*/) {
  static const Words all{
      "contact",
      "PoseError",
      "Kind of pose error that the proportional gain of a contact multiplies.",
      {{"split", "Position error and logarithm of the rotation error"},
       {"log6", "SE(3) logarithm of the pose error, transformed from tool axes to contact axes"}}};
  return all;
}

const Description& description_of(const SlidingFriction* /*of*/) {
  using S = SlidingFriction;
  static const Description all =
      Describe<S>("contact", "SlidingFriction",
                  "Smoothed Coulomb friction on a sliding tool. The friction force on the tool is"
                  " -coefficient lambda v_t / sqrt(|v_t|^2 + speed^2). Here lambda is the normal "
                  "force, and v_t is the tangential velocity of the tool relative to the base. "
                  "The velocity is taken at the point where friction acts.")
          .field("coefficient", &S::coefficient,
                 "Coefficient of friction",
                 {.least = 0})
          .more("With 0, there is no friction until another coefficient is set.")
          .field("speed", &S::speed,
                 "Speed below which friction fades out (none: chosen from a problem's time steps)"
                 " [{m/s}]",
                 {.least = 0, .open = true})
          .word("none")
          .more("The fade-out makes friction differentiable at rest. The speed chosen from the "
                "time steps is at least 0.01 m/s. For a contact without a problem, none means "
                "0.01 m/s.")
          .field("radius", &S::radius,
                 "Radius of a round tool tip [{m}]",
                 {.least = 0})
          .more("Friction acts at the tool's origin shifted by this distance, opposite to the "
                "normal.")
          .field("coefficient_input", &S::coefficient_input,
                 "Name of the scalar input of an optimal control problem whose values, at least "
                 "0, replace `coefficient` (empty: no input)")
          .more("See InputSpec.");
  return all;
}

const Description& description_of(const ContactSpec* /*of*/) {
  using S = ContactSpec;
  static const Description all =
      Describe<S>("contact", "ContactSpec",
                  "Contact that constrains a tool frame relative to a base frame in some "
                  "directions: alpha + kd nu + kp e = 0. Here e, nu and alpha are the pose error,"
                  " velocity and acceleration of the tool relative to the base, written in the "
                  "axes of the contact's Reference.")
          .field("name", &S::name,
                 "Unique name (empty: the name of the tool frame)")
          .field("tool", &S::tool,
                 "Name of the tool frame C2")
          .field("base", &S::base,
                 "Name of the base frame C1; \"world\" always exists")
          .field("reference", &S::reference)
          .field("directions", &S::directions,
                 "Constrained directions: \"all\", \"linear\", \"angular\", \"pad_x\", \"pad_y\","
                 " \"pad_z\" (a flat pad with normal x, y or z), or a list (\"z,rx,ry\")")
          .field("acceleration", &S::acceleration)
          .field("error", &S::error)
          .field("kp", &S::kp,
                 "Gains on the pose error, one per direction [{1/s^2}]")
          .more("Gains of free directions have no effect.")
          .field("kd", &S::kd,
                 "Gains on the velocity, one per direction [{1/s}]")
          .field("target", &S::target,
                 "Desired pose of the tool frame C2 in the base frame C1")
          .more("At this pose, the pose error is zero.")
          .field("friction", &S::friction,
                 "Friction on the tool (none: frictionless)")
          .field("surface_input", &S::surface_input,
                 "Name of the input of an optimal control problem whose surface replaces the "
                 "surface of `reference` (empty: no input)")
          .more("The reference must follow a surface. See InputSpec.");
  return all;
}

const Description& description_of(const ContactForce* /*of*/) {
  using S = ContactForce;
  static const Description all =
      Describe<S>("contact", "ContactForce",
                  "Wrench that the base of a contact exerts on the tool, at one state of the "
                  "robot.")
          .result()
          .field("contact", &S::contact,
                 "Name of the contact")
          .field("on", &S::on,
                 "Name of the tool frame C2; the force acts on the tool's body")
          .field("by", &S::by,
                 "Name of the base frame C1; the base's body exerts the force (\"world\": the "
                 "environment)")
          .field("reference", &S::reference,
                 "Origin and axes in which `value` is written")
          .field("value", &S::value,
                 "Force (N), then moment about the origin of the reference (Nm)")
          .field("tool_rotation", &S::tool_rotation,
                 "Rotation matrix from tool axes to world axes")
          .field("base_rotation", &S::base_rotation,
                 "Rotation matrix from base axes to world axes")
          .field("tool_position", &S::tool_position,
                 "Position of the tool frame in the world [{m}]")
          .field("base_position", &S::base_position,
                 "Position of the base frame in the world [{m}]")
          .field("frame_rotation", &S::frame_rotation,
                 "Rotation matrix from the axes of the frame `reference.axes` to world axes")
          .field("frame_position", &S::frame_position,
                 "Position of the reference's origin in the world [{m}]");
  return all;
}

const Description& description_of(const ContactSolver* /*of*/) {
  using S = ContactSolver;
  static const Description all =
      Describe<S>("contact", "ContactSolver",
                  "Options for computing contact forces from the KKT system: compliance and "
                  "proximal iterations.")
          .field("mu", &S::mu,
                 "Compliance of the contact rows (0: rigid contacts)",
                 {.least = 0})
          .more("Rigid contacts need independent rows; compliant contacts do not. The compliance "
                "mu is in m/s^2 per unit force. The lower right block of the KKT matrix is -mu "
                "times the identity.")
          .field("max_proximal_iterations", &S::max_proximal_iterations,
                 "Maximum number of proximal iterations (0: none)",
                 {.least = 0})
          .more("Proximal iterations remove the effect of the compliance mu on the solution. Each"
                " iteration computes lambda <- G^-1 (rho + mu lambda), where G lambda = rho is "
                "the compliant system.")
          .field("proximal_tolerance", &S::proximal_tolerance,
                 "Contact acceleration error at which proximal iterations stop [{m/s^2}]",
                 {.least = 0})
          .more("The error of a row is |mu (lambda - previous lambda)|. Proximal iterations stop "
                "once the errors of all rows are at most this tolerance.");
  return all;
}

const Description& description_of(const LoopGains* /*of*/) {
  using S = LoopGains;
  static const Description all =
      Describe<S>("contact", "LoopGains",
                  "Baumgarte gains, which correct the drift of a kinematic loop: alpha + kd nu + "
                  "kp e = 0. The symbols e, nu and alpha are the position error, velocity and "
                  "acceleration between the loop's two frames.")
          .field("kp", &S::kp,
                 "Gain on the position error [{1/s^2}]",
                 {.least = 0})
          .field("kd", &S::kd,
                 "Gain on the velocity [{1/s}]",
                 {.least = 0});
  return all;
}

const Description& description_of(const RedundantLoop* /*of*/) {
  using S = RedundantLoop;
  static const Description all =
      Describe<S>("contact", "RedundantLoop",
                  "Redundant directions of a loop. Other constraints of the loops already imply "
                  "these directions.")
          .result()
          .field("loop", &S::loop)
          .field("directions", &S::directions);
  return all;
}

const Description& description_of(const LoopFreedom* /*of*/) {
  using S = LoopFreedom;
  static const Description all =
      Describe<S>("contact", "LoopFreedom",
                  "Degrees of freedom of a robot whose loops are closed.")
          .result()
          .field("rows", &S::rows,
                 "Number of constraint rows of all loops")
          .field("rank", &S::rank,
                 "Rank of the Jacobian of all loops")
          .field("freedom", &S::freedom,
                 "Remaining degrees of freedom: nv - rank")
          .field("redundant", &S::redundant,
                 "Loops with redundant directions");
  return all;
}

const Description& description_of(const LoopProjectionOptions* /*of*/) {
  using S = LoopProjectionOptions;
  static const Description all =
      Describe<S>("contact", "LoopProjectionOptions",
                  "Options for projecting a configuration onto closed loops.")
          .field("keep", &S::keep,
                 "Names of joints that must not move")
          .field("weights", &S::weights,
                 "Cost of motion for each entry of v: nv positive numbers (empty: equal costs)")
          .field("tolerance", &S::tolerance,
                 "Largest accepted error of a closed loop in each constrained direction, m or rad",
                 {.least = 0, .open = true})
          .field("max_iterations", &S::max_iterations,
                 "Maximum number of iterations, summed over all restarts",
                 {.least = 1})
          .field("within_limits", &S::within_limits,
                 "Whether revolute and prismatic joints must stay within their position limits")
          .more("A joint that starts beyond a limit does not move further out.");
  return all;
}

const Description& description_of(const LoopMiss* /*of*/) {
  using S = LoopMiss;
  static const Description all =
      Describe<S>("contact", "LoopMiss",
                  "Closure error of a loop.")
          .result()
          .field("loop", &S::loop)
          .field("translation", &S::translation,
                 "Length of the position error, in the constrained directions only [{m}]")
          .field("rotation", &S::rotation,
                 "Size of the rotation error, about the constrained directions only [{rad}]");
  return all;
}

const Description& description_of(const LoopProjection* /*of*/) {
  using S = LoopProjection;
  static const Description all =
      Describe<S>("contact", "LoopProjection",
                  "Result of a projection onto the loops. If no posture was found that closes the"
                  " loops, the result is the posture with the smallest error.")
          .result()
          .field("q", &S::q,
                 "Configuration, nq entries")
          .field("misses", &S::misses,
                 "Remaining closure error of each loop")
          .field("iterations", &S::iterations)
          .field("status", &S::status,
                 "NotConverged if a loop is still open");
  return all;
}

const Words& words_of(LoopMetric /*of*/) {
  static const Words all{
      "contact",
      "LoopMetric",
      "Norm of the change dv of a velocity. A projection onto the loops minimizes this norm.",
      {{"plain", "|dv|^2, with equal weights for rad/s and m/s"},
       {"mass", "dv^T M dv, with the mass matrix M; dv is then the effect of impulses in the loops"}}};
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
