#include "estimate/foot_kinematics.hpp"

#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "model/joint_entries.hpp"

namespace burnish {
namespace {

CompiledFrame moving_frame(const Model& model, const std::string& name, const std::string& what) {
  CompiledFrame frame = compile_frame(model, name);
  if (frame.body < 0)
    throw Error(what + " " + in_quotes(name) +
                " is fixed to the world; wanted a frame of the robot");
  return frame;
}

CompiledFrame base_frame(const Model& model) {
  return {0, Mat3<double>::identity(), Vec3<double>::zero(), moving_axes(model, 0)};
}

const Model& floating(const Model& model) {
  if (model.joints.empty() || model.joints.front().kind != JointKind::FreeFlyer ||
      model.joints.front().parent != -1 || model.joints.front().v_index != 0)
    throw Error("robot " + in_quotes(model.name) +
                " has no floating base to estimate; wanted a model with a free-flying base");
  return model;
}

/// Returns true if the unit quaternions and the (cos, sin) pairs of all joints except the base have
/// length 1 within 1e-6.
bool joints_are_normalized(const Tree& tree, const ConstVectorRef& q) {
  for (std::size_t i = 1; i < tree.joints.size(); ++i) {
    const TreeJoint& joint = tree.joints[i];
    const int size = joint.follower < 0 ? unit_entries(joint.kind) : 0;
    if (size == 0) continue;
    const int first = joint.q + joint_nq(joint.kind) - size;
    if (!(std::abs(q.segment(first, size).squaredNorm() - 1.0) < 2e-6)) return false;
  }
  return true;
}

}  // namespace

FootKinematics::FootKinematics(const Model& model, const std::string& unit,
                               const std::vector<std::string>& feet)
    : tree_(floating(model)),
      unit_(unit.empty() ? base_frame(model)
                         : moving_frame(model, unit, "the measurement unit's frame")),
      kinematics_(tree_),
      q_(model.q_neutral),
      v_(Eigen::VectorXd::Zero(model.nv)),
      column_of_v_(to_size(model.nv), -1),
      seen_(feet.size()),
      velocities_(feet.size(), Vec3<double>::zero()),
      turnings_(velocities_) {
  for (const std::string& foot : feet) feet_.push_back(moving_frame(model, foot, "the foot"));
  q_.head<7>() << 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  base_joint_ = {tree_.joints.front().R, tree_.joints.front().p};
  std::vector<char> moves(to_size(model.nv), 0);
  for (const MovingAxis& axis : unit_.support) moves[to_size(axis.v)] = 1;
  for (const CompiledFrame& foot : feet_)
    for (const MovingAxis& axis : foot.support) moves[to_size(axis.v)] = 1;
  for (int k = 6; k < model.nv; ++k) {
    if (moves[to_size(k)] == 0) continue;
    column_of_v_[to_size(k)] = static_cast<int>(columns_.size());
    columns_.push_back(k);
  }
  jacobian_.setZero(static_cast<Eigen::Index>(6 * feet.size()),
                    static_cast<Eigen::Index>(columns_.size()));
  (void)update(model.q_neutral, v_);
}

Status FootKinematics::update(const ConstVectorRef& q, const ConstVectorRef& v) noexcept {
  if (q.size() != tree_.nq || v.size() != tree_.nv) return Status::WrongSize;
  const auto joints = tree_.nq - 7, rates = tree_.nv - 6;
  if (is_updated_ && q_.tail(joints) == q.tail(joints) && v_.tail(rates) == v.tail(rates))
    return Status::Ok;
  if (!q.tail(joints).allFinite() || !v.tail(rates).allFinite()) return Status::NotFinite;
  if (!joints_are_normalized(tree_, q)) return Status::NotNormalized;
  q_.tail(joints) = q.tail(joints);
  v_.tail(rates) = v.tail(rates);
  update_kinematics(tree_, q_.data(), v_.data(), kinematics_);
  unit_pose_ = pose_of(unit_, kinematics_);
  const BodyState<double>& base = kinematics_.bodies.front();
  unit_in_base_ = seen_from(FramePose<double>{base.R, base.p}, unit_pose_);
  const BodyState<double>& carrier = kinematics_.bodies[to_size(unit_.body)];
  const Motion<double> twist = at_point(carrier.v, unit_pose_.p);
  unit_in_base_velocity_ = {transpose_times(base.R, twist.linear),
                            transpose_times(base.R, twist.angular)};
  for (int foot = 0; foot < feet(); ++foot) {
    const auto i = to_size(foot);
    const FramePose<double> pose = pose_of(feet_[i], kinematics_);
    const FramePose<double> in_unit = seen_from(unit_pose_, pose);
    seen_[i] = {in_unit.p, in_unit.R};
    const BodyState<double>& body = kinematics_.bodies[to_size(feet_[i].body)];
    // With the foot at p_f, and the IMU at (R, p): d(R^T (p_f - p))/dt = R^T (dp_f/dt - dp/dt -
    // w x (p_f - p)). dp/dt + w x (p_f - p) is the velocity of the IMU's body at the foot.
    velocities_[i] = transpose_times(
        unit_pose_.R, at_point(body.v, pose.p).linear - at_point(carrier.v, pose.p).linear);
    turnings_[i] = transpose_times(unit_pose_.R, body.v.angular - carrier.v.angular);
    update_jacobian(foot);
  }
  is_updated_ = true;
  return Status::Ok;
}

void FootKinematics::update_jacobian(int foot) noexcept {
  auto J = jacobian_.middleRows(6 * foot, 6);
  J.setZero();
  const CompiledFrame& frame = feet_[to_size(foot)];
  const Vec3<double> p_foot = pose_of(frame, kinematics_).p;
  const auto add = [&](const std::vector<MovingAxis>& support, double sign) {
    for (const MovingAxis& moving : support) {
      const int column = column_of_v_[to_size(moving.v)];
      if (column < 0) continue;
      const Motion<double>& axis = kinematics_.axes[to_size(moving.axis)].axis;
      const Motion<double> at_foot = at_point(axis, p_foot);
      J.block<3, 1>(0, column) += sign * to_eigen(transpose_times(unit_pose_.R, at_foot.linear));
      J.block<3, 1>(3, column) += sign * to_eigen(transpose_times(unit_pose_.R, axis.angular));
    }
  };
  add(frame.support, 1.0);
  add(unit_.support, -1.0);
}

}  // namespace burnish
