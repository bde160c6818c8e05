#include "identify/joint_angles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "identify/record_check.hpp"

namespace burnish::identify_detail {
namespace {

constexpr double whole_turn = 2.0 * std::numbers::pi;
/// Largest deviation of a wrap from whole turns [rad]; a larger deviation means a jump. No joint
/// turns this far between two samples.
constexpr double wrap_tolerance = 0.5 * std::numbers::pi;

/// Calls `visit` for each joint of `model`, with the joint's index in q of the model `angles`.
template <typename Visit>
void each_joint(const Model& model, const Model& angles, const Visit& visit) {
  for (std::size_t i = 0; i < model.joints.size(); ++i)
    if (model.joints[i].nq > 0) visit(model.joints[i], angles.joints[i].q_index);
}

/// Throws Error for a (cos, sin) that is not on the unit circle.
void check_circle(const Model& model, const Joint& joint, const MotionRecord& record,
                  Eigen::Index first) {
  constexpr double tolerance = 0.05;  // Accepted deviation of the length of (cos, sin) from 1
  const auto pair = record.q.middleCols(joint.q_index, 2);
  for (Eigen::Index i = first; i < pair.rows(); ++i)
    if (const double length = pair.row(i).norm(); std::abs(length - 1.0) > tolerance)
      throw Error("identify: " + in_quotes(q_column(model, joint.q_index)) + " and " +
                  in_quotes(q_column(model, joint.q_index + 1)) + " form a vector of length " +
                  number(length) + " at " + time_text(record, i) +
                  "; wanted length 1: the cosine and the sine of the angle");
}

/// Removes wraps by whole turns; jumps of other sizes stay.
void unwrap_turns(Eigen::Ref<Eigen::VectorXd> angle) {
  double before = 0.0, turns = 0.0;
  bool has_previous = false;
  for (double& now : angle) {
    if (!std::isfinite(now)) continue;
    const double step = has_previous ? now - before : 0.0;
    const double whole = std::round(step / whole_turn);
    before = now;
    has_previous = true;
    if (std::abs(step - whole * whole_turn) < wrap_tolerance) turns -= whole;
    now += turns * whole_turn;
  }
}

}  // namespace

Model angle_model(const Model& model) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Model result = model;
  result.nq = 0;
  for (Joint& joint : result.joints) {
    if (joint.kind == JointKind::Continuous) joint.kind = JointKind::Revolute;
    joint.nq = joint.nq == 0 ? 0 : joint_nq(joint.kind);
    joint.q_index = result.nq;
    result.nq += joint.nq;
  }
  for (Joint& joint : result.joints)
    if (joint.follows) joint.q_index = result.joints[to_size(joint.follows->leader)].q_index;
  result.q_neutral = Eigen::VectorXd::Zero(result.nq);
  result.q_lower = Eigen::VectorXd::Constant(result.nq, -infinity);
  result.q_upper = Eigen::VectorXd::Constant(result.nq, infinity);
  each_joint(model, result, [&](const Joint& joint, int to) {
    if (is_circle(joint)) return;
    result.q_neutral.segment(to, joint.nq) = model.q_neutral.segment(joint.q_index, joint.nq);
    result.q_lower.segment(to, joint.nq) = model.q_lower.segment(joint.q_index, joint.nq);
    result.q_upper.segment(to, joint.nq) = model.q_upper.segment(joint.q_index, joint.nq);
  });
  for (Tendon& tendon : result.tendons)
    for (Tendon::Entry& entry : tendon.parts)
      entry.q = result.joints[to_size(model.joint_of_v[to_size(entry.v)])].q_index;
  return result;
}

MotionRecord with_angles(const Model& model, const MotionRecord& record, Eigen::Index first) {
  const Model angles = angle_model(model);
  const bool has_pairs = record.q.cols() == model.nq;
  MotionRecord result = record;
  if (angles.nq == model.nq) return result;
  if (!has_pairs && record.q.cols() != angles.nq)
    throw Error("identify: q has " + std::to_string(record.q.cols()) + " columns; wanted " +
                std::to_string(angles.nq) + ", with one angle for each continuous joint, or " +
                std::to_string(model.nq) + ", with a cosine and a sine for each");
  if (has_pairs) result.q.resize(record.q.rows(), angles.nq);
  each_joint(model, angles, [&](const Joint& joint, int to) {
    if (has_pairs && !is_circle(joint))
      result.q.middleCols(to, joint.nq) = record.q.middleCols(joint.q_index, joint.nq);
    if (!is_circle(joint)) return;
    Eigen::VectorXd angle = result.q.col(to);
    if (has_pairs) {
      check_circle(model, joint, record, first);
      for (Eigen::Index i = 0; i < angle.size(); ++i)
        angle[i] = std::atan2(record.q(i, joint.q_index + 1), record.q(i, joint.q_index));
    }
    unwrap_turns(angle);
    result.q.col(to) = angle;
  });
  return result;
}

}  // namespace burnish::identify_detail
