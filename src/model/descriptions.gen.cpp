// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "model/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Words& words_of(JointConvention /*of*/) {
  static const Words all{
      "model",
      "JointConvention",
      "Coordinates in which another program writes joint positions and velocities.",
      {{"angles", "As in q, v, tau of a Model, but with one angle for the rotation of a continuous or "
        "planar joint"},
       {"same", "As in q, v, tau of a Model, with (cos, sin) for the rotation of a continuous or planar "
        "joint"},
       {"mujoco", "As in MuJoCo: one angle for the rotation of a continuous or planar joint, quaternions w "
        "x y z, and the linear velocity of a floating or planar joint in the axes of its parent"}}};
  return all;
}

const Words& words_of(JointKind /*of*/) {
  static const Words all{
      "model",
      "JointKind",
      "Kinds of moving joints.",
      {{"revolute", "q = angle, v = rate"},
       {"continuous", "q = (cos, sin), v = rate"},
       {"prismatic", "q = displacement, v = rate"},
       {"planar", "q = (x, y, cos, sin), v = (v_x, v_y, w_z) in body axes"},
       {"free_flyer", "q = (position, quaternion x y z w), v = (linear, angular velocity) in body axes"},
       {"ball", "q = quaternion x y z w, v = angular velocity in body axes"}}};
  return all;
}

const Description& description_of(const Following* /*of*/) {
  using S = Following;
  static const Description all =
      Describe<S>("model", "Following",
                  "Coupling of a follower joint to its leader joint: follower position = "
                  "multiplier * leader position + offset, in rad or m.")
          .field("leader", &S::leader,
                 "Index of the leader, which is not a follower itself")
          .field("multiplier", &S::multiplier)
          .field("offset", &S::offset);
  return all;
}

const Description& description_of(const Joint* /*of*/) {
  using S = Joint;
  static const Description all =
      Describe<S>("model", "Joint",
                  "A moving joint of a Model, and the rigid body that the joint moves. A follower"
                  " is a joint whose position is computed from another joint, the leader. A "
                  "follower has no entries in q and v.")
          .result()
          .field("name", &S::name)
          .field("kind", &S::kind)
          .field("parent", &S::parent,
                 "Index of the parent joint; -1: the world")
          .field("q_index", &S::q_index,
                 "Index of the first entry in q; for a coupled joint (follower), the leader's "
                 "index")
          .field("v_index", &S::v_index,
                 "Index of the first entry in v; for a coupled joint (follower), the leader's "
                 "index")
          .field("nq", &S::nq,
                 "Number of entries in q; 0 for a coupled joint (follower)")
          .field("nv", &S::nv,
                 "Number of entries in v; 0 for a coupled joint (follower)")
          .field("placement", &S::placement,
                 "Placement of the joint frame in the parent body's frame, at joint position zero")
          .field("mass", &S::mass,
                 "Mass of the body [{kg}]")
          .field("com", &S::com,
                 "Centre of mass of the body in the joint frame [{m}]")
          .field("inertia_at_com", &S::inertia_at_com,
                 "Inertia of the body about its centre of mass, in the axes of the joint frame "
                 "[{kg m^2}]")
          .field("follows", &S::follows,
                 "Coupling to another joint, the leader; only for coupled joints (followers)");
  return all;
}

const Description& description_of(const FileJoint* /*of*/) {
  using S = FileJoint;
  static const Description all =
      Describe<S>("model", "FileJoint",
                  "A joint that can move according to the robot's description. In the model, the "
                  "joint either moves or is held at a constant position.")
          .result()
          .field("name", &S::name)
          .field("kind", &S::kind)
          .field("joint", &S::joint,
                 "Index in the model's joints; -1: the joint is held")
          .field("held", &S::held,
                 "Position of a held joint, as in a Posture; empty if the joint moves");
  return all;
}

const Description& description_of(const Tendon* /*of*/) {
  using S = Tendon;
  static const Description all =
      Describe<S>("model", "Tendon",
                  "A tendon of a Model. Its length is a weighted sum of joint positions. A "
                  "spring, a damper or both act on the length. Locked joints contribute to "
                  "`rest`. A coupled joint (follower) contributes to the coefficient of its "
                  "leader.")
          .result()
          .field("name", &S::name)
          .field("parts", &S::parts,
                 "Joints along the tendon, in ascending order of v")
          .field("rest", &S::rest,
                 "Length at which the spring is at rest [{m}]")
          .field("stiffness", &S::stiffness,
                 "Stiffness of the spring [{N/m}]")
          .field("damping", &S::damping,
                 "Damping of the length [{Ns/m}]");
  return all;
}

const Description& description_of(const Tendon::Entry* /*of*/) {
  using S = Tendon::Entry;
  static const Description all =
      Describe<S>("model", "TendonEntry",
                  "A joint along a tendon of a Model.")
          .result()
          .field("q", &S::q,
                 "Index of the joint's position in q (of its cosine for a continuous joint)")
          .field("v", &S::v,
                 "Index of the joint's entry in v")
          .field("coefficient", &S::coefficient,
                 "Tendon length per joint position [{m/rad}]; dimensionless for a prismatic joint");
  return all;
}

const Words& words_of(FrameKind /*of*/) {
  static const Words all{
      "model",
      "FrameKind",
      "Kinds of named frames: frame of a link, frame of a joint, or additional frame.",
      {{"link"},
       {"joint"},
       {"user"}}};
  return all;
}

const Description& description_of(const Frame* /*of*/) {
  using S = Frame;
  static const Description all =
      Describe<S>("model", "Frame",
                  "A named frame fixed to a body of a Model.")
          .result()
          .field("name", &S::name)
          .field("kind", &S::kind)
          .field("body", &S::body,
                 "Index of the joint that moves the frame; -1: fixed to the world")
          .field("placement", &S::placement,
                 "Placement in the body's frame, or in the world if body is -1")
          .required();
  return all;
}

const Description& description_of(const Visual* /*of*/) {
  using S = Visual;
  static const Description all =
      Describe<S>("model", "Visual",
                  "A solid shape to draw, fixed to a body of a Model.")
          .result()
          .field("link", &S::link)
          .field("body", &S::body)
          .field("placement", &S::placement)
          .required()
          .field("shape", &S::shape)
          .field("rgba", &S::rgba);
  return all;
}

const Description& description_of(const Loop* /*of*/) {
  using S = Loop;
  static const Description all =
      Describe<S>("model", "Loop",
                  "A constraint between two frames of a Model that closes a kinematic chain. The "
                  "constraint prevents relative motion of the frames along `directions`, in the "
                  "axes of the first frame.")
          .result()
          .field("name", &S::name)
          .field("first", &S::first,
                 "Name of the first frame: name of the loop followed by \"/first\"")
          .field("second", &S::second,
                 "Name of the second frame: name of the loop followed by \"/second\"")
          .field("directions", &S::directions);
  return all;
}

const Words& words_of(Base /*of*/) {
  static const Words all{
      "model",
      "Base",
      "Attachment of the root link to the world.",
      {{"fixed"},
       {"free_flyer"}}};
  return all;
}

const Description& description_of(const ModelOptions* /*of*/) {
  using S = ModelOptions;
  static const Description all =
      Describe<S>("model", "ModelOptions",
                  "Options for building a Model from a TreeSpec.")
          .field("base", &S::base)
          .field("base_placement", &S::base_placement,
                 "Placement of the root link in the world")
          .more("For a free-flying base, the placement sets only the neutral configuration.")
          .field("locked", &S::locked,
                 "Joints to lock")
          .more("Joints that are coupled to a locked joint (followers) are locked too. A joint is"
                " locked at its value in `posture`, or at zero if `posture` has no value for the "
                "joint.")
          .field("free", &S::free,
                 "Joints that stay free; empty: all joints")
          .more("If the list is not empty, all other joints are locked. Exceptions are joints "
                "that are coupled to a listed joint (followers) and a free-flying base.")
          .field("posture", &S::posture,
                 "Positions of locked joints; values of moving joints are ignored")
          .field("frames", &S::frames,
                 "Frames to add, in order")
          .more("The parent of a frame may be a frame earlier in the list.")
          .field("gravity", &S::gravity,
                 "Gravity [{m/s^2}]")
          .field("strict", &S::strict,
                 "Treat warnings about the robot's description as errors");
  return all;
}

const Description& description_of(const InertiaSpec* /*of*/) {
  using S = InertiaSpec;
  static const Description all =
      Describe<S>("model", "InertiaSpec",
                  "Mass distribution of a link, in the axes of the link.")
          .field("mass", &S::mass,
                 "Mass [{kg}]")
          .field("com", &S::com,
                 "Centre of mass [{m}]")
          .field("inertia_at_com", &S::inertia_at_com,
                 "Inertia about the centre of mass, in the axes of the link [{kg m^2}]");
  return all;
}

const Description& description_of(const BoxShape* /*of*/) {
  using S = BoxShape;
  static const Description all =
      Describe<S>("model", "BoxShape",
                  "A box.")
          .field("size", &S::size,
                 "Full lengths along x, y and z [{m}]")
          .required();
  return all;
}

const Description& description_of(const CylinderShape* /*of*/) {
  using S = CylinderShape;
  static const Description all =
      Describe<S>("model", "CylinderShape",
                  "A cylinder.")
          .field("radius", &S::radius,
                 "Radius [{m}]")
          .required()
          .field("length", &S::length,
                 "Length along z, with the origin in the middle [{m}]")
          .required();
  return all;
}

const Description& description_of(const SphereShape* /*of*/) {
  using S = SphereShape;
  static const Description all =
      Describe<S>("model", "SphereShape",
                  "A sphere.")
          .field("radius", &S::radius,
                 "Radius [{m}]")
          .required();
  return all;
}

const Description& description_of(const MeshShape* /*of*/) {
  using S = MeshShape;
  static const Description all =
      Describe<S>("model", "MeshShape",
                  "A mesh file, used for drawing only.")
          .field("uri", &S::uri,
                 "File name as in the description, including `package://`")
          .required()
          .field("scale", &S::scale,
                 "Scale factors along the axes")
          .required();
  return all;
}

const Description& description_of(const VisualSpec* /*of*/) {
  using S = VisualSpec;
  static const Description all =
      Describe<S>("model", "VisualSpec",
                  "A solid shape to draw, attached to a link.")
          .field("shape", &S::shape)
          .required()
          .field("placement", &S::placement,
                 "Placement of the shape in the frame of the link")
          .field("rgba", &S::rgba,
                 "Colour: red, green, blue, opacity");
  return all;
}

const Description& description_of(const LinkSpec* /*of*/) {
  using S = LinkSpec;
  static const Description all =
      Describe<S>("model", "LinkSpec",
                  "A link (rigid body) of a robot, as its description states it.")
          .field("name", &S::name)
          .required()
          .field("inertia", &S::inertia)
          .field("visuals", &S::visuals)
          .field("line", &S::line,
                 "Line in the description file, for messages about the link; 0: unknown");
  return all;
}

const Words& words_of(JointType /*of*/) {
  static const Words all{
      "model",
      "JointType",
      "Types of joints in a robot description.",
      {{"fixed"},
       {"revolute"},
       {"continuous"},
       {"prismatic"},
       {"planar"},
       {"floating"},
       {"ball"}}};
  return all;
}

const Description& description_of(const MimicSpec* /*of*/) {
  using S = MimicSpec;
  static const Description all =
      Describe<S>("model", "MimicSpec",
                  "Coupling of a joint to another joint, the leader: q = multiplier * q_leader + "
                  "offset. q is the position of the joint, and q_leader is the position of the "
                  "leader.")
          .field("leader", &S::leader)
          .required()
          .field("multiplier", &S::multiplier)
          .field("offset", &S::offset);
  return all;
}

const Description& description_of(const JointSpec* /*of*/) {
  using S = JointSpec;
  static const Description all =
      Describe<S>("model", "JointSpec",
                  "A joint of a robot, as its description states it.")
          .field("name", &S::name)
          .required()
          .field("type", &S::type)
          .field("parent_link", &S::parent_link)
          .field("child_link", &S::child_link)
          .field("placement", &S::placement,
                 "Placement of the child link's frame in the parent link's frame, at joint "
                 "position zero")
          .field("axis", &S::axis,
                 "Unit axis of the joint in the child link's frame; for a planar joint, normal of"
                 " the plane")
          .field("lower", &S::lower,
                 "Lower position limit [{rad}] or [m]")
          .field("upper", &S::upper,
                 "Upper position limit [{rad}] or [m]")
          .field("velocity_limit", &S::velocity_limit,
                 "Velocity limit [{rad/s}] or [m/s]")
          .field("effort_limit", &S::effort_limit,
                 "Torque or force limit [{Nm}] or [N]")
          .field("damping", &S::damping,
                 "Viscous friction [{Nm s/rad}] or [Ns/m]")
          .field("friction", &S::friction,
                 "Coulomb friction [{Nm}] or [N]")
          .field("armature", &S::armature,
                 "Inertia of the motor, reflected to the joint [{kg m^2}] or [kg]")
          .field("stiffness", &S::stiffness,
                 "Stiffness of a spring in the joint [{Nm/rad}] or [N/m]")
          .field("rest", &S::rest,
                 "Rest position of the joint's spring [{rad}] or [m]")
          .more("Ignored for a ball joint. The spring of a ball joint is at rest without "
                "rotation.")
          .field("mimic", &S::mimic)
          .field("held", &S::held,
                 "Constant position of a held joint [{rad}] or [m]; empty for other joints")
          .more("An equality constraint of MJCF can hold a hinge or slide joint. A held joint has"
                " the type Fixed.")
          .field("line", &S::line,
                 "Line in the description file, for messages about the joint; 0: unknown");
  return all;
}

const Description& description_of(const FrameSpec* /*of*/) {
  using S = FrameSpec;
  static const Description all =
      Describe<S>("model", "FrameSpec",
                  "A named frame to add when the Model is built.")
          .field("name", &S::name)
          .required()
          .field("parent", &S::parent,
                 "Name of an existing frame")
          .required()
          .field("placement", &S::placement,
                 "Placement in the parent frame");
  return all;
}

const Description& description_of(const LoopSpec* /*of*/) {
  using S = LoopSpec;
  static const Description all =
      Describe<S>("model", "LoopSpec",
                  "A constraint between two links that closes a kinematic chain. A frame is fixed"
                  " to each link. The constraint prevents relative motion of the two frames along"
                  " `directions`, in the axes of the first frame.")
          .field("name", &S::name)
          .required()
          .field("first_link", &S::first_link,
                 "Name of the first link, or \"world\"")
          .required()
          .field("second_link", &S::second_link,
                 "Name of the second link, or \"world\"")
          .required()
          .field("first", &S::first,
                 "Placement of the first frame in the first link")
          .field("second", &S::second,
                 "Placement of the second frame in the second link")
          .field("directions", &S::directions,
                 "Constrained directions: \"linear\", \"all\", or names separated by commas such "
                 "as \"x,y,z,rx,rz\"")
          .field("line", &S::line,
                 "Line in the description file, for messages about the loop; 0: unknown");
  return all;
}

const Description& description_of(const TendonSpec* /*of*/) {
  using S = TendonSpec;
  static const Description all =
      Describe<S>("model", "TendonSpec",
                  "A tendon that couples joints, such as a fixed tendon of MuJoCo. The length of "
                  "the tendon is the sum of coefficient * position over the joints.")
          .field("name", &S::name)
          .required()
          .field("parts", &S::parts)
          .field("held", &S::held,
                 "Whether a constraint holds the length at `rest`")
          .field("rest", &S::rest,
                 "Length of a held tendon, or rest length of the spring [{m}]")
          .field("stiffness", &S::stiffness,
                 "Stiffness of the tendon's spring [{N/m}]")
          .field("damping", &S::damping,
                 "Damping of the tendon's length [{Ns/m}]")
          .field("line", &S::line,
                 "Line in the description file, for messages about the tendon; 0: unknown");
  return all;
}

const Description& description_of(const TendonSpec::Part* /*of*/) {
  using S = TendonSpec::Part;
  static const Description all =
      Describe<S>("model", "TendonPart",
                  "A joint along a tendon, with the coefficient of its position in the tendon's "
                  "length.")
          .field("joint", &S::joint)
          .required()
          .field("coefficient", &S::coefficient,
                 "Tendon length per joint position [{m/rad}]; dimensionless for a prismatic joint");
  return all;
}

const Words& words_of(SiblingOrder /*of*/) {
  static const Words all{
      "model",
      "SiblingOrder",
      "Order of joints with the same parent link in a Model.",
      {{"by_name"},
       {"as_listed"}}};
  return all;
}

const Description& description_of(const TreeSpec* /*of*/) {
  using S = TreeSpec;
  static const Description all =
      Describe<S>("model", "TreeSpec",
                  "A robot as its description states it: links and joints as plain values. "
                  "build_model() compiles a TreeSpec to a Model.")
          .field("name", &S::name,
                 "Name of the robot")
          .field("source", &S::source,
                 "File that the robot was read from, for error messages; may be empty")
          .field("links", &S::links)
          .field("joints", &S::joints)
          .field("sibling_order", &S::sibling_order,
                 "Order of joints with the same parent link in the Model")
          .more("For URDF, joints are sorted by name. For MJCF, joints are in the order of "
                "`joints`.")
          .field("loops", &S::loops)
          .field("tendons", &S::tendons)
          .field("frames", &S::frames,
                 "Named frames of the file other than frames of links and joints")
          .field("postures", &S::postures,
                 "Named postures of the file")
          .field("gravity", &S::gravity,
                 "Gravity, if stated in the file [{m/s^2}]")
          .field("warnings", &S::warnings,
                 "Warnings about odd but usable content of the file, one sentence each")
          .more("The warnings are copied to the Model.")
          .field("notes", &S::notes,
                 "Notes on ignored content of the file that does not affect dynamics, one "
                 "sentence each")
          .more("The notes are copied to the Model. Strict loading does not reject such content.");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
