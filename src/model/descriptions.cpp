#include "model/descriptions.hpp"

namespace burnish {

const Words& words_of(JointKind /*of*/) {
  static const Words all{"model",
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

const Words& words_of(JointType /*of*/) {
  static const Words all{
      "model",
      "JointType",
      "Joints as a description has them.",
      {{"fixed"}, {"revolute"}, {"continuous"}, {"prismatic"}, {"planar"}, {"floating"}, {"ball"}}};
  return all;
}

const Words& words_of(FrameKind /*of*/) {
  static const Words all{
      "model", "FrameKind", "What a named frame belongs to.", {{"link"}, {"joint"}, {"user"}}};
  return all;
}

const Words& words_of(Base /*of*/) {
  static const Words all{
      "model", "Base", "How the root link stands in the world.", {{"fixed"}, {"free_flyer"}}};
  return all;
}

const Words& words_of(SiblingOrder /*of*/) {
  static const Words all{"model",
                         "SiblingOrder",
                         "Order in a Model of joints that share a parent link.",
                         {{"by_name"}, {"as_listed"}}};
  return all;
}

const Words& words_of(JointConvention /*of*/) {
  static const Words all{
      "model",
      "JointConvention",
      "How vectors of another program write the joints.",
      {{"angles", "one angle of a continuous joint; else as in q, v and tau here"},
       {"same", "as in q, v and tau here, (cos, sin) of a continuous joint included"},
       {"mujoco",
        "one angle of a continuous joint; quaternions w x y z; the linear velocity of a floating "
        "joint along the axes of its parent"}}};
  return all;
}

const Description& description_of(const InertiaSpec* /*of*/) {
  using I = InertiaSpec;
  static const Description all =
      Describe<I>("model", "InertiaSpec", "Mass distribution of a link, in the link's axes.")
          .field("mass", &I::mass, "{kg}")
          .field("com", &I::com, "{m}, from the link's origin")
          .field("inertia_at_com", &I::inertia_at_com, "{kg m^2}, about com, link axes");
  return all;
}

const Description& description_of(const BoxShape* /*of*/) {
  using B = BoxShape;
  static const Description all = Describe<B>("model", "BoxShape", "A box.")
                                     .field("size", &B::size, "{m}, full lengths along x, y, z")
                                     .required();
  return all;
}

const Description& description_of(const CylinderShape* /*of*/) {
  using C = CylinderShape;
  static const Description all = Describe<C>("model", "CylinderShape", "A cylinder.")
                                     .field("radius", &C::radius, "{m}")
                                     .required()
                                     .field("length", &C::length, "{m}, along z, centred")
                                     .required();
  return all;
}

const Description& description_of(const SphereShape* /*of*/) {
  using S = SphereShape;
  static const Description all = Describe<S>("model", "SphereShape", "A sphere.")
                                     .field("radius", &S::radius, "{m}")
                                     .required();
  return all;
}

const Description& description_of(const MeshShape* /*of*/) {
  using M = MeshShape;
  static const Description all =
      Describe<M>("model", "MeshShape", "A mesh is kept for drawing only.")
          .field("uri", &M::uri, "as written in the file, `package://` included")
          .required()
          .field("scale", &M::scale, "per axis")
          .required();
  return all;
}

const Description& description_of(const VisualSpec* /*of*/) {
  using V = VisualSpec;
  static const Description all =
      Describe<V>("model", "VisualSpec", "One solid to draw, attached to a link.")
          .field("shape", &V::shape)
          .required()
          .field("placement", &V::placement, "in the link's frame")
          .field("rgba", &V::rgba);
  return all;
}

const Description& description_of(const LinkSpec* /*of*/) {
  using L = LinkSpec;
  static const Description all =
      Describe<L>("model", "LinkSpec", "A body of a robot, as its description has it.")
          .field("name", &L::name)
          .required()
          .field("inertia", &L::inertia)
          .field("visuals", &L::visuals)
          .field("line", &L::line, "of the file, for sentences about it; 0: none");
  return all;
}

const Description& description_of(const MimicSpec* /*of*/) {
  using M = MimicSpec;
  static const Description all =
      Describe<M>("model", "MimicSpec",
                  "A joint that copies another: q = multiplier * q_leader + offset.")
          .field("leader", &M::leader)
          .required()
          .field("multiplier", &M::multiplier)
          .field("offset", &M::offset);
  return all;
}

const Description& description_of(const JointSpec* /*of*/) {
  using J = JointSpec;
  static const Description all =
      Describe<J>("model", "JointSpec", "A joint of a robot, as its description has it.")
          .field("name", &J::name)
          .required()
          .field("type", &J::type)
          .field("parent_link", &J::parent_link)
          .field("child_link", &J::child_link)
          .field("placement", &J::placement,
                 "Of the child link's frame in the parent link's frame when the joint is at zero.")
          .field("axis", &J::axis,
                 "Unit axis in the child link's frame (for Planar the normal of the plane).")
          .field("lower", &J::lower, "{rad} or m")
          .field("upper", &J::upper, "{rad} or m")
          .field("velocity_limit", &J::velocity_limit, "{rad/s} or m/s")
          .field("effort_limit", &J::effort_limit, "{Nm} or N")
          .field("damping", &J::damping, "{Nms/rad} or Ns/m")
          .field("friction", &J::friction, "{Nm} or N, Coulomb")
          .field("armature", &J::armature, "{kg m^2} or kg")
          .field("stiffness", &J::stiffness, "of a spring in the joint, {Nm/rad} or N/m")
          .field("rest", &J::rest,
                 "where that spring is at rest, {rad} or m; a ball's is at no rotation")
          .field("mimic", &J::mimic)
          .field("held", &J::held,
                 "Value of a fixed joint that moves in the description and is held there, as "
                 "equalities of MJCF hold hinges and slides, {rad} or m; empty of others.")
          .field("line", &J::line, "of the file, for sentences about it; 0: none");
  return all;
}

const Description& description_of(const TendonSpec::Part* /*of*/) {
  using P = TendonSpec::Part;
  static const Description all =
      Describe<P>("model", "TendonPart", "A joint that a tendon goes along.")
          .field("joint", &P::joint)
          .required()
          .field("coefficient", &P::coefficient, "{m/rad} or 1");
  return all;
}

const Description& description_of(const TendonSpec* /*of*/) {
  using T = TendonSpec;
  static const Description all =
      Describe<T>("model", "TendonSpec",
                  "A fixed tendon: joints coupled by its length, the sum of coefficient times "
                  "position over them.")
          .field("name", &T::name)
          .required()
          .field("parts", &T::parts)
          .field("held", &T::held, "the length stays at `rest`")
          .field("rest", &T::rest, "{m}, where it is held or its spring is at rest")
          .field("stiffness", &T::stiffness, "{N/m}")
          .field("damping", &T::damping, "{Ns/m}")
          .field("line", &T::line, "of the file, for sentences about it; 0: none");
  return all;
}

const Description& description_of(const LoopSpec* /*of*/) {
  using L = LoopSpec;
  static const Description all =
      Describe<L>("model", "LoopSpec",
                  "Two links tied to each other along some directions: what closes a chain. "
                  "Relative motion of the second frame seen from the first, in the first one's "
                  "axes, is held to none.")
          .field("name", &L::name)
          .required()
          .field("first_link", &L::first_link, "or \"world\"")
          .required()
          .field("second_link", &L::second_link, "or \"world\"")
          .required()
          .field("first", &L::first, "frame in the first link")
          .field("second", &L::second, "frame in the second link")
          .field("directions", &L::directions,
                 R"("linear", "all", or names separated by commas such as "x,y,z,rx,rz")")
          .field("line", &L::line, "of the file, for sentences about it; 0: none");
  return all;
}

const Description& description_of(const TreeSpec* /*of*/) {
  using T = TreeSpec;
  static const Description all =
      Describe<T>("model", "TreeSpec",
                  "A robot as its description states it: links and joints as plain values. "
                  "build_model() compiles it.")
          .field("name", &T::name, "of the robot")
          .field("source", &T::source,
                 "file it was read from, used in error sentences; may be empty")
          .field("links", &T::links)
          .field("joints", &T::joints)
          .field("sibling_order", &T::sibling_order,
                 "Order in the Model of joints that share a parent link: by name as of URDF, or as "
                 "in `joints`, as of MJCF.")
          .field("loops", &T::loops)
          .field("tendons", &T::tendons)
          .field("frames", &T::frames, "that the file names beside links and joints")
          .field("postures", &T::postures, "that the file names")
          .field("gravity", &T::gravity, "{m/s^2}, where the file states it")
          .field("warnings", &T::warnings,
                 "What was odd about the file but stopped nothing, one sentence each; a Model gets "
                 "them too.")
          .field("notes", &T::notes,
                 "What the file holds beside that which is passed over without changing dynamics, "
                 "one sentence each: no oddity, so that strict reading bears it. A Model gets them "
                 "too.");
  return all;
}

const Description& description_of(const FrameSpec* /*of*/) {
  using F = FrameSpec;
  static const Description all =
      Describe<F>("model", "FrameSpec", "A frame to add while compiling.")
          .field("name", &F::name)
          .required()
          .field("parent", &F::parent, "name of an existing frame")
          .required()
          .field("placement", &F::placement, "in the parent frame");
  return all;
}

const Description& description_of(const ModelOptions* /*of*/) {
  using M = ModelOptions;
  static const Description all =
      Describe<M>("model", "ModelOptions", "How a TreeSpec becomes a Model.")
          .field("base", &M::base)
          .field("base_placement", &M::base_placement,
                 "Placement of the root link in the world; with a free-flyer only the neutral "
                 "posture uses it.")
          .field("locked", &M::locked,
                 "Joints to lock. A locked joint is fixed at its value in `posture`, or at zero, "
                 "and those that follow it where it puts them.")
          .field("free", &M::free,
                 "When not empty: every joint that is not listed here is locked (a free-flying "
                 "base stays free), but for those that follow a listed one.")
          .field("posture", &M::posture,
                 "Where locked joints are held; values of joints that move are passed over.")
          .field("frames", &M::frames, "added in this order; a parent may be an earlier one")
          .field("gravity", &M::gravity, "{m/s^2}")
          .field("strict", &M::strict, "refuse what would be a warning");
  return all;
}

const Description& description_of(const Following* /*of*/) {
  using F = Following;
  static const Description all =
      Describe<F>("model", "Following",
                  "How a joint moves with another one: multiplier * value of the leader + offset, "
                  "rad or m.")
          .field("leader", &F::leader, "index of a joint that follows no other")
          .field("multiplier", &F::multiplier)
          .field("offset", &F::offset);
  return all;
}

const Description& description_of(const Joint* /*of*/) {
  using J = Joint;
  static const Description all =
      Describe<J>("model", "Joint",
                  "A moving joint of a Model and the rigid body that it carries. One that follows "
                  "another has no entries of its own in q and v: its leader's move both.")
          .result()
          .field("name", &J::name)
          .field("kind", &J::kind)
          .field("parent", &J::parent, "index of the joint that carries this one, -1 for the world")
          .field("q_index", &J::q_index, "first entry in q; of a follower that of its leader")
          .field("v_index", &J::v_index, "first entry in v; of a follower that of its leader")
          .field("nq", &J::nq, "entries in q, 0 of a follower")
          .field("nv", &J::nv, "entries in v, 0 of a follower")
          .field("placement", &J::placement, "joint frame at zero in the parent body's frame")
          .field("mass", &J::mass, "of the body, kg")
          .field("com", &J::com, "of the body, in the joint frame, m")
          .field("inertia_at_com", &J::inertia_at_com, "of the body, about com, joint axes, kg m^2")
          .field("follows", &J::follows);
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
          .field("joint", &S::joint, "index in the model's joints, -1: held")
          .field("held", &S::held, "where it is held, in the coordinates of a Posture");
  return all;
}

const Description& description_of(const Tendon::Entry* /*of*/) {
  using E = Tendon::Entry;
  static const Description all =
      Describe<E>("model", "TendonEntry", "A joint that a tendon of a Model goes along.")
          .result()
          .field("q", &E::q, "the joint's entry of q, if its kind has one alone")
          .field("v", &E::v, "the joint's entry of v")
          .field("coefficient", &E::coefficient, "{m/rad} or 1");
  return all;
}

const Description& description_of(const Tendon* /*of*/) {
  using T = Tendon;
  static const Description all =
      Describe<T>("model", "Tendon",
                  "Joints of a Model coupled by the length of a tendon, which has a spring, a "
                  "damper or both. What locked joints add is taken off `rest`, and what followers "
                  "add stands at their leaders.")
          .result()
          .field("name", &T::name)
          .field("parts", &T::parts, "ascending in v")
          .field("rest", &T::rest, "{m}")
          .field("stiffness", &T::stiffness, "{N/m}")
          .field("damping", &T::damping, "{Ns/m}");
  return all;
}

const Description& description_of(const Frame* /*of*/) {
  using F = Frame;
  static const Description all =
      Describe<F>("model", "Frame", "A named frame fixed to a body of a Model.")
          .result()
          .field("name", &F::name)
          .field("kind", &F::kind)
          .field("body", &F::body, "index of the joint whose body carries it, -1 for the world")
          .field("placement", &F::placement, "in the body's frame (in the world if body is -1)")
          .required();
  return all;
}

const Description& description_of(const Visual* /*of*/) {
  using V = Visual;
  static const Description all =
      Describe<V>("model", "Visual", "A solid to draw, fixed to a body of a Model.")
          .result()
          .field("link", &V::link)
          .field("body", &V::body)
          .field("placement", &V::placement)
          .required()
          .field("shape", &V::shape)
          .field("rgba", &V::rgba);
  return all;
}

const Description& description_of(const Loop* /*of*/) {
  using L = Loop;
  static const Description all =
      Describe<L>("model", "Loop",
                  "Two frames of a Model tied to each other along some directions: motion of the "
                  "second seen from the first, in the first one's axes.")
          .result()
          .field("name", &L::name)
          .field("first", &L::first, "frame of the model, NAME/first")
          .field("second", &L::second, "frame of the model, NAME/second")
          .field("directions", &L::directions);
  return all;
}

}  // namespace burnish
