#include "specs_model.hpp"

namespace burnish::python {

template <>
const EnumTable& AsEnum<JointKind>::table() {
  static const EnumTable words("burnish.model", "JointKind",
                               {"revolute", "continuous", "prismatic", "planar", "free_flyer"});
  return words;
}
template <>
const EnumTable& AsEnum<JointType>::table() {
  static const EnumTable words(
      "burnish.model", "JointType",
      {"fixed", "revolute", "continuous", "prismatic", "planar", "floating"});
  return words;
}
template <>
const EnumTable& AsEnum<FrameKind>::table() {
  static const EnumTable words("burnish.model", "FrameKind", {"link", "joint", "user"});
  return words;
}
template <>
const EnumTable& AsEnum<Base>::table() {
  static const EnumTable words("burnish.model", "Base", {"fixed", "free_flyer"});
  return words;
}
template <>
const SpecTable& AsDataclass<InertiaSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "InertiaSpec")
                                      .field("mass", &InertiaSpec::mass)
                                      .field("com", &InertiaSpec::com)
                                      .field("inertia_at_com", &InertiaSpec::inertia_at_com);
  return fields;
}
template <>
const SpecTable& AsDataclass<BoxShape>::table() {
  static const SpecTable fields =
      SpecTable("burnish.model", "BoxShape").field("size", &BoxShape::size);
  return fields;
}
template <>
const SpecTable& AsDataclass<CylinderShape>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "CylinderShape")
                                      .field("radius", &CylinderShape::radius)
                                      .field("length", &CylinderShape::length);
  return fields;
}
template <>
const SpecTable& AsDataclass<SphereShape>::table() {
  static const SpecTable fields =
      SpecTable("burnish.model", "SphereShape").field("radius", &SphereShape::radius);
  return fields;
}
template <>
const SpecTable& AsDataclass<MeshShape>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "MeshShape")
                                      .field("uri", &MeshShape::uri)
                                      .field("scale", &MeshShape::scale);
  return fields;
}
template <>
const SpecTable& AsDataclass<VisualSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "VisualSpec")
                                      .field("shape", &VisualSpec::shape)
                                      .field("placement", &VisualSpec::placement)
                                      .field("rgba", &VisualSpec::rgba);
  return fields;
}
template <>
const SpecTable& AsDataclass<LinkSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "LinkSpec")
                                      .field("name", &LinkSpec::name)
                                      .field("inertia", &LinkSpec::inertia)
                                      .field("visuals", &LinkSpec::visuals)
                                      .field("line", &LinkSpec::line);
  return fields;
}
template <>
const SpecTable& AsDataclass<MimicSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "MimicSpec")
                                      .field("leader", &MimicSpec::leader)
                                      .field("multiplier", &MimicSpec::multiplier)
                                      .field("offset", &MimicSpec::offset);
  return fields;
}
template <>
const SpecTable& AsDataclass<JointSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "JointSpec")
                                      .field("name", &JointSpec::name)
                                      .field("type", &JointSpec::type)
                                      .field("parent_link", &JointSpec::parent_link)
                                      .field("child_link", &JointSpec::child_link)
                                      .field("placement", &JointSpec::placement)
                                      .field("axis", &JointSpec::axis)
                                      .field("lower", &JointSpec::lower)
                                      .field("upper", &JointSpec::upper)
                                      .field("velocity_limit", &JointSpec::velocity_limit)
                                      .field("effort_limit", &JointSpec::effort_limit)
                                      .field("damping", &JointSpec::damping)
                                      .field("friction", &JointSpec::friction)
                                      .field("armature", &JointSpec::armature)
                                      .field("mimic", &JointSpec::mimic)
                                      .field("line", &JointSpec::line);
  return fields;
}
template <>
const SpecTable& AsDataclass<TreeSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "TreeSpec")
                                      .field("name", &TreeSpec::name)
                                      .field("source", &TreeSpec::source)
                                      .field("links", &TreeSpec::links)
                                      .field("joints", &TreeSpec::joints)
                                      .field("warnings", &TreeSpec::warnings);
  return fields;
}
template <>
const SpecTable& AsDataclass<FrameSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "FrameSpec")
                                      .field("name", &FrameSpec::name)
                                      .field("parent", &FrameSpec::parent)
                                      .field("placement", &FrameSpec::placement);
  return fields;
}
template <>
const SpecTable& AsDataclass<ModelOptions>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "ModelOptions")
                                      .field("base", &ModelOptions::base)
                                      .field("base_placement", &ModelOptions::base_placement)
                                      .field("locked", &ModelOptions::locked)
                                      .field("free", &ModelOptions::free)
                                      .field("posture", &ModelOptions::posture)
                                      .field("frames", &ModelOptions::frames)
                                      .field("gravity", &ModelOptions::gravity)
                                      .field("strict", &ModelOptions::strict);
  return fields;
}
template <>
const SpecTable& AsDataclass<Following>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "Following")
                                      .field("leader", &Following::leader)
                                      .field("multiplier", &Following::multiplier)
                                      .field("offset", &Following::offset);
  return fields;
}
template <>
const SpecTable& AsDataclass<Joint>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "Joint")
                                      .field("name", &Joint::name)
                                      .field("kind", &Joint::kind)
                                      .field("parent", &Joint::parent)
                                      .field("q_index", &Joint::q_index)
                                      .field("v_index", &Joint::v_index)
                                      .field("nq", &Joint::nq)
                                      .field("nv", &Joint::nv)
                                      .field("placement", &Joint::placement)
                                      .field("mass", &Joint::mass)
                                      .field("com", &Joint::com)
                                      .field("inertia_at_com", &Joint::inertia_at_com)
                                      .field("follows", &Joint::follows);
  return fields;
}
template <>
const SpecTable& AsDataclass<Frame>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "Frame")
                                      .field("name", &Frame::name)
                                      .field("kind", &Frame::kind)
                                      .field("body", &Frame::body)
                                      .field("placement", &Frame::placement);
  return fields;
}
template <>
const SpecTable& AsDataclass<Visual>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "Visual")
                                      .field("link", &Visual::link)
                                      .field("body", &Visual::body)
                                      .field("placement", &Visual::placement)
                                      .field("shape", &Visual::shape)
                                      .field("rgba", &Visual::rgba);
  return fields;
}
template <>
const SpecTable& AsDataclass<RobotOverrides>::table() {
  static const SpecTable fields = SpecTable("burnish.model", "RobotOverrides")
                                      .field("base", &RobotOverrides::base)
                                      .field("locked", &RobotOverrides::locked)
                                      .field("free", &RobotOverrides::free)
                                      .field("carrying", &RobotOverrides::carrying)
                                      .field("posture", &RobotOverrides::posture)
                                      .field("srdf", &RobotOverrides::srdf)
                                      .field("strict", &RobotOverrides::strict);
  return fields;
}

}  // namespace burnish::python
