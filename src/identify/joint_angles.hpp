// Angles of continuous joints in place of their cosines and sines.
#pragma once

#include "burnish/identify/identification.hpp"

namespace burnish::identify_detail {

/// Whether q holds the joint as (cos, sin).
inline bool is_circle(const Joint& joint) {
  return joint.kind == JointKind::Continuous && joint.nq == 2;
}

/// The robot with revolute joints without limits in place of continuous ones: q holds their angles.
Model angle_model(const Model& model);

/// The record with q as angle_model() has it; angles go on beyond half a turn. `record` may have q
/// as `model` or as angle_model(model) has it. Throws Error, naming columns and time, for a (cos,
/// sin) from sample `first` on whose length is not one, and for other numbers of columns.
MotionRecord with_angles(const Model& model, const MotionRecord& record, Eigen::Index first = 0);

}  // namespace burnish::identify_detail
