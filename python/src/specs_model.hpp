// Values of the model layer.
#pragma once

#include "burnish/model/model.hpp"
#include "burnish/robots/robot.hpp"
#include "spec.hpp"

namespace burnish::python {

template <>
struct EnumOf<JointKind> : AsEnum<JointKind> {};
template <>
struct EnumOf<JointType> : AsEnum<JointType> {};
template <>
struct EnumOf<FrameKind> : AsEnum<FrameKind> {};
template <>
struct EnumOf<Base> : AsEnum<Base> {};
template <>
struct SpecOf<InertiaSpec> : AsDataclass<InertiaSpec> {};
template <>
struct SpecOf<BoxShape> : AsDataclass<BoxShape> {};
template <>
struct SpecOf<CylinderShape> : AsDataclass<CylinderShape> {};
template <>
struct SpecOf<SphereShape> : AsDataclass<SphereShape> {};
template <>
struct SpecOf<MeshShape> : AsDataclass<MeshShape> {};
template <>
struct SpecOf<VisualSpec> : AsDataclass<VisualSpec> {};
template <>
struct SpecOf<LinkSpec> : AsDataclass<LinkSpec> {};
template <>
struct SpecOf<MimicSpec> : AsDataclass<MimicSpec> {};
template <>
struct SpecOf<Following> : AsDataclass<Following> {};
template <>
struct SpecOf<JointSpec> : AsDataclass<JointSpec> {};
template <>
struct SpecOf<TreeSpec> : AsDataclass<TreeSpec> {};
template <>
struct SpecOf<FrameSpec> : AsDataclass<FrameSpec> {};
template <>
struct SpecOf<ModelOptions> : AsDataclass<ModelOptions> {};
template <>
struct SpecOf<Joint> : AsDataclass<Joint> {};
template <>
struct SpecOf<Frame> : AsDataclass<Frame> {};
template <>
struct SpecOf<Visual> : AsDataclass<Visual> {};
template <>
struct SpecOf<RobotOverrides> : AsDataclass<RobotOverrides> {};

}  // namespace burnish::python
