// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/model/joint_order.hpp"
#include "burnish/model/model.hpp"
#include "burnish/model/tree_spec.hpp"

namespace burnish {

const Words& words_of(JointConvention);
const Words& words_of(JointKind);
const Description& description_of(const Following*);
const Description& description_of(const Joint*);
const Description& description_of(const FileJoint*);
const Description& description_of(const Tendon*);
const Description& description_of(const Tendon::Entry*);
const Words& words_of(FrameKind);
const Description& description_of(const Frame*);
const Description& description_of(const Visual*);
const Description& description_of(const Loop*);
const Words& words_of(Base);
const Description& description_of(const ModelOptions*);
const Description& description_of(const InertiaSpec*);
const Description& description_of(const BoxShape*);
const Description& description_of(const CylinderShape*);
const Description& description_of(const SphereShape*);
const Description& description_of(const MeshShape*);
const Description& description_of(const VisualSpec*);
const Description& description_of(const LinkSpec*);
const Words& words_of(JointType);
const Description& description_of(const MimicSpec*);
const Description& description_of(const JointSpec*);
const Description& description_of(const FrameSpec*);
const Description& description_of(const LoopSpec*);
const Description& description_of(const TendonSpec*);
const Description& description_of(const TendonSpec::Part*);
const Words& words_of(SiblingOrder);
const Description& description_of(const TreeSpec*);

}  // namespace burnish
