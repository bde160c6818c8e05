// Conversion of continuous joints from cosine and sine to angle.
#pragma once

#include "burnish/identify/identification.hpp"

namespace burnish::identify_detail {

/// Returns whether q stores the joint as (cos, sin).
inline bool is_circle(const Joint& joint) {
  return joint.kind == JointKind::Continuous && joint.nq == 2;
}

/// Returns the model with its continuous joints replaced by unlimited revolute joints.
Model angle_model(const Model& model);

/// Returns the record with q in the format of angle_model(). Angles continue beyond half a turn.
/// `record` has q in the format of `model` or of angle_model(model). Throws Error for a wrong
/// number of columns. Throws Error with columns and time if a pair (cos, sin), from sample `first`
/// on, does not have length 1.
MotionRecord with_angles(const Model& model, const MotionRecord& record, Eigen::Index first = 0);

}  // namespace burnish::identify_detail
