// What the layer's specifications hold.
#pragma once

#include "base/description.hpp"
#include "burnish/model/joint_order.hpp"
#include "burnish/model/model.hpp"

namespace burnish {
const Words& words_of(JointKind);
const Words& words_of(JointType);
const Words& words_of(FrameKind);
const Words& words_of(Base);
const Words& words_of(SiblingOrder);
const Words& words_of(JointConvention);
const Description& description_of(const InertiaSpec*);
const Description& description_of(const BoxShape*);
const Description& description_of(const CylinderShape*);
const Description& description_of(const SphereShape*);
const Description& description_of(const MeshShape*);
const Description& description_of(const VisualSpec*);
const Description& description_of(const LinkSpec*);
const Description& description_of(const MimicSpec*);
const Description& description_of(const JointSpec*);
const Description& description_of(const TendonSpec::Part*);
const Description& description_of(const TendonSpec*);
const Description& description_of(const LoopSpec*);
const Description& description_of(const TreeSpec*);
const Description& description_of(const FrameSpec*);
const Description& description_of(const ModelOptions*);
const Description& description_of(const Following*);
const Description& description_of(const Joint*);
const Description& description_of(const StatedJoint*);
const Description& description_of(const Tendon::Entry*);
const Description& description_of(const Tendon*);
const Description& description_of(const Frame*);
const Description& description_of(const Visual*);
const Description& description_of(const Loop*);

}  // namespace burnish
