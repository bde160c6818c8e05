// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "model/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Words& words_of(JointConvention /*of*/) {
  static const Words all{
      "model",
      "JointConvention",
      "How vectors of another program write the joints.",
      {{"angles", "one angle of a continuous joint; else as in q, v and tau here"},
       {"same", "as in q, v and tau here, (cos, sin) of a continuous joint included"},
       {"mujoco", "one angle of a continuous joint; quaternions w x y z; the linear velocity of a floating "
        "joint along the axes of its parent"}}};
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
       {"free_flyer", "q = (p, quaternion x y z w), v = (v, w) in body axes"},
       {"ball", "q = quaternion x y z w, v = w in body axes"}}};
  return all;
}

const Description& description_of(const Following* /*of*/) {
  using S = Following;
  static const Description all =
      Describe<S>("model", "Following",
                  "How a joint moves with another one: multiplier * value of the leader + offset,"
                  " rad or m.")
          .field("leader", &S::leader,
                 "index of a joint that follows no other")
          .field("multiplier", &S::multiplier)
          .field("offset", &S::offset);
  return all;
}

const Description& description_of(const Joint* /*of*/) {
  using S = Joint;
  static const Description all =
      Describe<S>("model", "Joint",
                  "A moving joint of a Model and the rigid body that it carries. One that follows"
                  " another has no entries of its own in q and v: its leader's move both.")
          .result()
          .field("name", &S::name)
          .field("kind", &S::kind)
          .field("parent", &S::parent,
                 "index of the joint that carries this one, -1 for the world")
          .field("q_index", &S::q_index,
                 "first entry in q; of a follower that of its leader")
          .field("v_index", &S::v_index,
                 "first entry in v; of a follower that of its leader")
          .field("nq", &S::nq,
                 "entries in q, 0 of a follower")
          .field("nv", &S::nv,
                 "entries in v, 0 of a follower")
          .field("placement", &S::placement,
                 "joint frame at zero in the parent body's frame")
          .field("mass", &S::mass,
                 "of the body, kg")
          .field("com", &S::com,
                 "of the body, in the joint frame, m")
          .field("inertia_at_com", &S::inertia_at_com,
                 "of the body, about com, joint axes, kg m^2")
          .field("follows", &S::follows);
  return all;
}

const Description& description_of(const StatedJoint* /*of*/) {
  using S = StatedJoint;
  static const Description all =
      Describe<S>("model", "StatedJoint",
                  "A joint that has a position in the description: it moves in the model too, or "
                  "is held.")
          .result()
          .field("name", &S::name)
          .field("kind", &S::kind)
          .field("joint", &S::joint,
                 "index in the model's joints, -1: held")
          .field("held", &S::held,
                 "where it is held, in the coordinates of a Posture");
  return all;
}

const Description& description_of(const Tendon* /*of*/) {
  using S = Tendon;
  static const Description all =
      Describe<S>("model", "Tendon",
                  "Joints of a Model coupled by the length of a tendon, which has a spring, a "
                  "damper or both. What locked joints add is taken off `rest`, and what followers"
                  " add stands at their leaders.")
          .result()
          .field("name", &S::name)
          .field("parts", &S::parts,
                 "ascending in v")
          .field("rest", &S::rest,
                 "{m}")
          .field("stiffness", &S::stiffness,
                 "{N/m}")
          .field("damping", &S::damping,
                 "{Ns/m}");
  return all;
}

const Description& description_of(const Tendon::Entry* /*of*/) {
  using S = Tendon::Entry;
  static const Description all =
      Describe<S>("model", "TendonEntry",
                  "A joint that a tendon of a Model goes along.")
          .result()
          .field("q", &S::q,
                 "the joint's entry of q, if its kind has one alone")
          .field("v", &S::v,
                 "the joint's entry of v")
          .field("coefficient", &S::coefficient,
                 "{m/rad} or 1");
  return all;
}

const Words& words_of(FrameKind /*of*/) {
  static const Words all{
      "model",
      "FrameKind",
      "What a named frame belongs to.",
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
                 "index of the joint whose body carries it, -1 for the world")
          .field("placement", &S::placement,
                 "in the body's frame (in the world if body is -1)")
          .required();
  return all;
}

const Description& description_of(const Visual* /*of*/) {
  using S = Visual;
  static const Description all =
      Describe<S>("model", "Visual",
                  "A solid to draw, fixed to a body of a Model.")
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
                  "Two frames of a Model tied to each other along some directions: motion of the "
                  "second seen from the first, in the first one's axes.")
          .result()
          .field("name", &S::name)
          .field("first", &S::first,
                 "frame of the model, NAME/first")
          .field("second", &S::second,
                 "frame of the model, NAME/second")
          .field("directions", &S::directions);
  return all;
}

const Words& words_of(Base /*of*/) {
  static const Words all{
      "model",
      "Base",
      "How the root link stands in the world.",
      {{"fixed"},
       {"free_flyer"}}};
  return all;
}

const Description& description_of(const ModelOptions* /*of*/) {
  using S = ModelOptions;
  static const Description all =
      Describe<S>("model", "ModelOptions",
                  "How a TreeSpec becomes a Model.")
          .field("base", &S::base)
          .field("base_placement", &S::base_placement,
                 "Placement of the root link in the world; with a free-flyer only the neutral "
                 "posture uses it.")
          .field("locked", &S::locked,
                 "Joints to lock. A locked joint is fixed at its value in `posture`, or at zero, "
                 "and those that follow it where it puts them.")
          .field("free", &S::free,
                 "When not empty: every joint that is not listed here is locked (a free-flying "
                 "base stays free), but for those that follow a listed one.")
          .field("posture", &S::posture,
                 "Where locked joints are held; values of joints that move are passed over.")
          .field("frames", &S::frames,
                 "added in this order; a parent may be an earlier one")
          .field("gravity", &S::gravity,
                 "{m/s^2}")
          .field("strict", &S::strict,
                 "refuse what would be a warning");
  return all;
}

const Description& description_of(const InertiaSpec* /*of*/) {
  using S = InertiaSpec;
  static const Description all =
      Describe<S>("model", "InertiaSpec",
                  "Mass distribution of a link, in the link's axes.")
          .field("mass", &S::mass,
                 "{kg}")
          .field("com", &S::com,
                 "{m}, from the link's origin")
          .field("inertia_at_com", &S::inertia_at_com,
                 "{kg m^2}, about com, link axes");
  return all;
}

const Description& description_of(const BoxShape* /*of*/) {
  using S = BoxShape;
  static const Description all =
      Describe<S>("model", "BoxShape",
                  "A box.")
          .field("size", &S::size,
                 "{m}, full lengths along x, y, z")
          .required();
  return all;
}

const Description& description_of(const CylinderShape* /*of*/) {
  using S = CylinderShape;
  static const Description all =
      Describe<S>("model", "CylinderShape",
                  "A cylinder.")
          .field("radius", &S::radius,
                 "{m}")
          .required()
          .field("length", &S::length,
                 "{m}, along z, centred")
          .required();
  return all;
}

const Description& description_of(const SphereShape* /*of*/) {
  using S = SphereShape;
  static const Description all =
      Describe<S>("model", "SphereShape",
                  "A sphere.")
          .field("radius", &S::radius,
                 "{m}")
          .required();
  return all;
}

const Description& description_of(const MeshShape* /*of*/) {
  using S = MeshShape;
  static const Description all =
      Describe<S>("model", "MeshShape",
                  "A mesh is kept for drawing only.")
          .field("uri", &S::uri,
                 "as written in the file, `package://` included")
          .required()
          .field("scale", &S::scale,
                 "per axis")
          .required();
  return all;
}

const Description& description_of(const VisualSpec* /*of*/) {
  using S = VisualSpec;
  static const Description all =
      Describe<S>("model", "VisualSpec",
                  "One solid to draw, attached to a link.")
          .field("shape", &S::shape)
          .required()
          .field("placement", &S::placement,
                 "in the link's frame")
          .field("rgba", &S::rgba);
  return all;
}

const Description& description_of(const LinkSpec* /*of*/) {
  using S = LinkSpec;
  static const Description all =
      Describe<S>("model", "LinkSpec",
                  "A body of a robot, as its description has it.")
          .field("name", &S::name)
          .required()
          .field("inertia", &S::inertia)
          .field("visuals", &S::visuals)
          .field("line", &S::line,
                 "of the file, for sentences about it; 0: none");
  return all;
}

const Words& words_of(JointType /*of*/) {
  static const Words all{
      "model",
      "JointType",
      "Joints as a description has them.",
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
                  "A joint that copies another: q = multiplier * q_leader + offset.")
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
                  "A joint of a robot, as its description has it.")
          .field("name", &S::name)
          .required()
          .field("type", &S::type)
          .field("parent_link", &S::parent_link)
          .field("child_link", &S::child_link)
          .field("placement", &S::placement,
                 "Of the child link's frame in the parent link's frame when the joint is at zero.")
          .field("axis", &S::axis,
                 "Unit axis in the child link's frame (for Planar the normal of the plane).")
          .field("lower", &S::lower,
                 "{rad} or m")
          .field("upper", &S::upper,
                 "{rad} or m")
          .field("velocity_limit", &S::velocity_limit,
                 "{rad/s} or m/s")
          .field("effort_limit", &S::effort_limit,
                 "{Nm} or N")
          .field("damping", &S::damping,
                 "{Nms/rad} or Ns/m")
          .field("friction", &S::friction,
                 "{Nm} or N, Coulomb")
          .field("armature", &S::armature,
                 "{kg m^2} or kg")
          .field("stiffness", &S::stiffness,
                 "of a spring in the joint, {Nm/rad} or N/m")
          .field("rest", &S::rest,
                 "where that spring is at rest, {rad} or m; a ball's is at no rotation")
          .field("mimic", &S::mimic)
          .field("held", &S::held,
                 "Value of a fixed joint that moves in the description and is held there, as "
                 "equalities of MJCF hold hinges and slides, {rad} or m; empty of others.")
          .field("line", &S::line,
                 "of the file, for sentences about it; 0: none");
  return all;
}

const Description& description_of(const FrameSpec* /*of*/) {
  using S = FrameSpec;
  static const Description all =
      Describe<S>("model", "FrameSpec",
                  "A frame to add while compiling.")
          .field("name", &S::name)
          .required()
          .field("parent", &S::parent,
                 "name of an existing frame")
          .required()
          .field("placement", &S::placement,
                 "in the parent frame");
  return all;
}

const Description& description_of(const LoopSpec* /*of*/) {
  using S = LoopSpec;
  static const Description all =
      Describe<S>("model", "LoopSpec",
                  "Two links tied to each other along some directions: what closes a chain. "
                  "Relative motion of the second frame seen from the first, in the first one's "
                  "axes, is held to none.")
          .field("name", &S::name)
          .required()
          .field("first_link", &S::first_link,
                 "or \"world\"")
          .required()
          .field("second_link", &S::second_link,
                 "or \"world\"")
          .required()
          .field("first", &S::first,
                 "frame in the first link")
          .field("second", &S::second,
                 "frame in the second link")
          .field("directions", &S::directions,
                 "\"linear\", \"all\", or names separated by commas such as \"x,y,z,rx,rz\"")
          .field("line", &S::line,
                 "of the file, for sentences about it; 0: none");
  return all;
}

const Description& description_of(const TendonSpec* /*of*/) {
  using S = TendonSpec;
  static const Description all =
      Describe<S>("model", "TendonSpec",
                  "A fixed tendon: joints coupled by its length, the sum of coefficient times "
                  "position over them.")
          .field("name", &S::name)
          .required()
          .field("parts", &S::parts)
          .field("held", &S::held,
                 "the length stays at `rest`")
          .field("rest", &S::rest,
                 "{m}, where it is held or its spring is at rest")
          .field("stiffness", &S::stiffness,
                 "{N/m}")
          .field("damping", &S::damping,
                 "{Ns/m}")
          .field("line", &S::line,
                 "of the file, for sentences about it; 0: none");
  return all;
}

const Description& description_of(const TendonSpec::Part* /*of*/) {
  using S = TendonSpec::Part;
  static const Description all =
      Describe<S>("model", "TendonPart",
                  "A joint that a tendon goes along.")
          .field("joint", &S::joint)
          .required()
          .field("coefficient", &S::coefficient,
                 "{m/rad} or 1");
  return all;
}

const Words& words_of(SiblingOrder /*of*/) {
  static const Words all{
      "model",
      "SiblingOrder",
      "Order in a Model of joints that share a parent link.",
      {{"by_name"},
       {"as_listed"}}};
  return all;
}

const Description& description_of(const TreeSpec* /*of*/) {
  using S = TreeSpec;
  static const Description all =
      Describe<S>("model", "TreeSpec",
                  "A robot as its description states it: links and joints as plain values. "
                  "build_model() compiles it.")
          .field("name", &S::name,
                 "of the robot")
          .field("source", &S::source,
                 "file it was read from, used in error sentences; may be empty")
          .field("links", &S::links)
          .field("joints", &S::joints)
          .field("sibling_order", &S::sibling_order,
                 "Order in the Model of joints that share a parent link: by name as of URDF, or "
                 "as in `joints`, as of MJCF.")
          .field("loops", &S::loops)
          .field("tendons", &S::tendons)
          .field("frames", &S::frames,
                 "that the file names beside links and joints")
          .field("postures", &S::postures,
                 "that the file names")
          .field("gravity", &S::gravity,
                 "{m/s^2}, where the file states it")
          .field("warnings", &S::warnings,
                 "What was odd about the file but stopped nothing, one sentence each; a Model "
                 "gets them too.")
          .field("notes", &S::notes,
                 "What the file holds beside that which is passed over without changing dynamics,"
                 " one sentence each: no oddity, so that strict reading bears it. A Model gets "
                 "them too.");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
