#include "ocp/descriptions.hpp"

namespace burnish::residual {

const Description& description_of(const State* /*of*/) {
  using S = State;
  static const Description all =
      Describe<S>("residual", "State",
                  "x (-) target, ndx rows: dq (rad, m), dv (rad/s, m/s), dtau (Nm, N).")
          .field("target", &S::target,
                 "a state of nx entries; None: the initial state of the problem");
  return all;
}

const Description& description_of(const Control* /*of*/) {
  using C = Control;
  static const Description all = Describe<C>("residual", "Control", "u - target, nu rows, Nm (N).")
                                     .field("target", &C::target, "None: zero");
  return all;
}

const Description& description_of(const JointPosition* /*of*/) {
  using J = JointPosition;
  static const Description all =
      Describe<J>("residual", "JointPosition",
                  "q_j - target for revolute and prismatic joints, one row each, rad or m. No "
                  "joints: all of them that have a limit.")
          .field("joints", &J::joints)
          .field("target", &J::target, "None: zero, as limits want it");
  return all;
}

const Description& description_of(const JointVelocity* /*of*/) {
  using J = JointVelocity;
  static const Description all =
      Describe<J>("residual", "JointVelocity",
                  "v - target for the entries of the named joints, rad/s or m/s; no joints: all "
                  "but the free-flying base.")
          .field("joints", &J::joints)
          .field("target", &J::target, "None: zero");
  return all;
}

const Description& description_of(const JointTorque* /*of*/) {
  using J = JointTorque;
  static const Description all =
      Describe<J>("residual", "JointTorque",
                  "What the actuators apply to the named joints minus the target, Nm or N: the "
                  "control, or with a cut-off of the torque model the torque state. No joints: all "
                  "actuated ones.")
          .field("joints", &J::joints)
          .field("target", &J::target, "None: zero");
  return all;
}

const Description& description_of(const JointTorqueRate* /*of*/) {
  using J = JointTorqueRate;
  static const Description all =
      Describe<J>("residual", "JointTorqueRate",
                  "How fast the torques of the named joints follow the control, minus the target: "
                  "cutoff (u - tau), Nm/s or N/s, at the begin of the step, over which it decays; "
                  "(u - tau) / step where torques are held and tau is the control of the step "
                  "before. With a torque model alone, where there is a control. No joints: all "
                  "actuated ones.")
          .field("joints", &J::joints)
          .field("target", &J::target, "None: zero");
  return all;
}

const Description& description_of(const FramePosition* /*of*/) {
  using F = FramePosition;
  static const Description all =
      Describe<F>("residual", "FramePosition",
                  "Origin of a frame minus the target, 3 rows, m, written in the axes of the "
                  "reference, whose base is the world. Its origin must not be the frame itself; "
                  "where its axes follow a surface at the frame (Reference.on) it is that of what "
                  "the surface is fixed in, and the first two rows are how far the target is along "
                  "the tangents at the frame.")
          .field("frame", &F::frame)
          .field("target", &F::target,
                 "3, {m}: from the reference's origin, in the axes that its rotation is fixed in; "
                 "of Reference::world(...) a point of the world")
          .field("reference", &F::reference);
  return all;
}

const Description& description_of(const FrameDistance* /*of*/) {
  using F = FrameDistance;
  static const Description all =
      Describe<F>("residual", "FrameDistance",
                  "Distance of a frame's origin from the target, 1 row, m, measured along "
                  "`directions` of the reference, whose base is the world and whose origin must "
                  "not be the frame itself: along all three from a point, along two from a line, "
                  "along one from a plane. It is sqrt(d^2 + (1e-6 m)^2), so that it has a "
                  "derivative everywhere; at d = 0 that is zero, as no direction leads away.")
          .field("frame", &F::frame)
          .field("target", &F::target,
                 "3, {m}, as of FramePosition. None: the reference's origin, unless that is the "
                 "world's")
          .field("directions", &F::directions, "one or more of x, y and z")
          .field("reference", &F::reference);
  return all;
}

const Description& description_of(const FrameRotation* /*of*/) {
  using F = FrameRotation;
  static const Description all =
      Describe<F>("residual", "FrameRotation",
                  "log(R_target^T A^T R), 3 rows, rad, target axes: how far the frame is from the "
                  "target, which is a rotation from the axes A of the reference, whose base is the "
                  "world; its origin does not matter.")
          .field("frame", &F::frame)
          .field("target", &F::target, "quaternion x, y, z, w, of unit length")
          .field("reference", &F::reference);
  return all;
}

const Description& description_of(const FrameInclination* /*of*/) {
  using F = FrameInclination;
  static const Description all =
      Describe<F>("residual", "FrameInclination",
                  "Lead and tilt of an axis of a frame minus the target, 2 rows, rad: the angles "
                  "by which it leans from the third axis of the reference, whose base is the "
                  "world, towards the first and towards the second: atan2(e_x, e_z) and "
                  "atan2(e_y, e_z), with e the axis in the reference. How it is turned about "
                  "itself does not matter. With Reference.on the third axis is a surface's normal.")
          .field("frame", &F::frame)
          .field("reference", &F::reference)
          .field("axis", &F::axis, "3, of any length, in the frame")
          .field("target", &F::target, "lead and tilt, {rad}; None: zero");
  return all;
}

const Description& description_of(const FrameHeight* /*of*/) {
  using F = FrameHeight;
  static const Description all =
      Describe<F>("residual", "FrameHeight",
                  "Height of a frame's origin above the surface that the reference follows "
                  "(Reference.on), minus the target, 1 row, m: how far away the surface is along "
                  "its normal at the frame, below zero in the material. Exact for planes, spheres "
                  "and cylinders, to first order for others; far outside of a surface that the "
                  "normal there misses it only grows.")
          .field("frame", &F::frame)
          .field("reference", &F::reference)
          .field("target", &F::target, "{m}; None: zero");
  return all;
}

const Description& description_of(const FramePlacement* /*of*/) {
  using F = FramePlacement;
  static const Description all =
      Describe<F>("residual", "FramePlacement",
                  "SE(3) logarithm of the frame in the target: 3 rows m, 3 rows rad, target axes.")
          .field("frame", &F::frame)
          .field("target", &F::target, "position (m), quaternion x, y, z, w");
  return all;
}

const Description& description_of(const FrameVelocity* /*of*/) {
  using F = FrameVelocity;
  static const Description all =
      Describe<F>("residual", "FrameVelocity",
                  "Velocity of a frame in the world minus the target, 6 rows: m/s, rad/s, written "
                  "in the reference, whose tool is the frame and whose base is the world.")
          .field("frame", &F::frame)
          .field("reference", &F::reference)
          .field("target", &F::target, "None: zero");
  return all;
}

const Description& description_of(const ContactForce* /*of*/) {
  using C = ContactForce;
  static const Description all =
      Describe<C>("residual", "ContactForce",
                  "Force of an active contact minus the target, N and Nm: the held rows in the "
                  "contact's own reference, or six rows in another one.")
          .field("contact", &C::contact)
          .field("reference", &C::reference)
          .field("target", &C::target, "None: zero");
  return all;
}

const Description& description_of(const ContactForceRate* /*of*/) {
  using C = ContactForceRate;
  static const Description all =
      Describe<C>("residual", "ContactForceRate",
                  "How fast the force of an active contact changes from the step before to this "
                  "one, minus the target: (f - f_before) / step, N/s and Nm/s, the held rows in "
                  "the contact's own reference. For contacts that the problem remembers the force "
                  "of.")
          .field("contact", &C::contact)
          .field("target", &C::target, "None: zero");
  return all;
}

const Description& description_of(const FrictionCone* /*of*/) {
  using F = FrictionCone;
  static const Description all =
      Describe<F>("residual", "FrictionCone",
                  "Two rows, N: friction * f_n - |f_t| (smoothed over 1e-3 N) and f_n, both to be "
                  "kept above a limit: the default penalty is a barrier at 0. f_n is the force "
                  "along the axis `normal` of the reference (0, 1, 2: x, y, z), f_t what stands at "
                  "a right angle to it. With `sides` n a pyramid inside the cone: n rows, N, "
                  "friction * cos(pi / n) * f_n - d_i . f_t, where d_0 is the next axis of the "
                  "reference after the normal and the others follow every 360 / n degrees.")
          .field("contact", &F::contact)
          .field("friction", &F::friction)
          .field("normal", &F::normal)
          .field("reference", &F::reference, "default: the contact's own")
          .field("sides", &F::sides, "3 to 32, of a pyramid inside the cone; 0: the cone itself");
  return all;
}

const Description& description_of(const CenterOfPressure* /*of*/) {
  using C = CenterOfPressure;
  static const Description all =
      Describe<C>(
          "residual", "CenterOfPressure",
          "Four rows, Nm: how far the centre of pressure is inside a rectangle of the "
          "tool's axes, times the normal force f_z: half_x f_z +- m_y, half_y f_z +- m_x, both "
          "halves in m; zero where the centre, which is (-m_y, m_x) / f_z, is at the edge "
          "above in x, below in x, below in y, above in y. With friction eight rows more, Nm, "
          "four to the right and four to the left: how far the moment about the normal is "
          "within what the corners bear with that coefficient each. Default penalty: a barrier "
          "at 0.")
          .field("contact", &C::contact)
          .field("half_x", &C::half_x, "{m}")
          .field("half_y", &C::half_y)
          .field("friction", &C::friction, "0: the moment about the normal is free");
  return all;
}

const Description& description_of(const CenterOfMass* /*of*/) {
  using C = CenterOfMass;
  static const Description all =
      Describe<C>("residual", "CenterOfMass", "Centre of mass minus the target, 3 rows, m, world.")
          .field("target", &C::target);
  return all;
}

const Description& description_of(const SupportMargin* /*of*/) {
  using S = SupportMargin;
  static const Description all =
      Describe<S>(
          "residual", "SupportMargin",
          "How far the centre of mass, seen from above, is inside of each edge of a support "
          "polygon: a row per edge, m, all to be kept above a limit: the default penalty is "
          "a barrier at 0. Row i is of the edge from point i to the next one, the last back "
          "to the first.")
          .field("points", &S::points,
                 "3 or more, x and y in the world, {m}: the corners of a convex polygon, "
                 "counter-clockwise as seen from above. Others are refused.");
  return all;
}

const Description& description_of(const CentroidalMomentum* /*of*/) {
  using C = CentroidalMomentum;
  static const Description all = Describe<C>("residual", "CentroidalMomentum",
                                             "Momentum about the centre of mass minus the target, "
                                             "6 rows: kg m/s, kg m^2/s, world axes.")
                                     .field("target", &C::target, "None: zero");
  return all;
}

}  // namespace burnish::residual
