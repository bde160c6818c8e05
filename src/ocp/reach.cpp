#include "ocp/reach.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "model/followers.hpp"

namespace burnish::ocp {

Reach reach_of(const Model& model, const std::string& frame) {
  const Frame& found = model.frames[to_size(model.frame_index(frame))];
  if (found.body < 0) return {found.placement.translation(), 0.0, ""};
  Reach reach{{}, found.placement.translation().norm(), ""};
  for (int j = found.body; j >= 0;) {
    const Joint& joint = model.joints[to_size(j)];
    if (joint.kind == JointKind::FreeFlyer || joint.kind == JointKind::Planar) return {};
    if (joint.kind == JointKind::Prismatic) {
      const auto [lower, upper] = position_range(model, joint);
      reach.distance += std::max(std::abs(lower), std::abs(upper));
    }
    if (joint.parent < 0) {
      reach.origin = joint.placement.translation();
      reach.joint = joint.name;
    } else {
      reach.distance += joint.placement.translation().norm();
    }
    j = joint.parent;
  }
  return reach;
}

}  // namespace burnish::ocp
