#include "burnish/model/joint_order.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/model/state.hpp"
#include "model/followers.hpp"
#include "model/joint_entries.hpp"
#include "model/posture.hpp"

namespace burnish {
namespace {

using Eigen::VectorXd;

/// Returns the number of a joint's position entries. The position of a continuous joint is one
/// angle or, as in q, (cos, sin).
int positions_of(JointKind kind, JointConvention convention) {
  return convention == JointConvention::Same ? joint_nq(kind)
                                             : static_cast<int>(posture_size(kind));
}

/// Returns true if the last four entries are a quaternion in the order w, x, y, z.
bool has_w_first(JointKind kind, JointConvention convention) {
  return convention == JointConvention::Mujoco && unit_entries(kind) == 4;
}

/// Reorder a quaternion from (w, x, y, z) to (x, y, z, w), and from (x, y, z, w) to (w, x, y, z).
void w_to_end(Eigen::Ref<VectorXd> x) { std::rotate(x.begin(), x.begin() + 1, x.end()); }
void w_to_front(Eigen::Ref<VectorXd> x) { std::rotate(x.begin(), x.end() - 1, x.end()); }

/// Replace an angle at the end of x by the pair (cos, sin), and a pair at the end by the angle.
VectorXd with_pair(const VectorXd& x) {
  const Eigen::Index size = x.size() - 1;
  VectorXd result(size + 2);
  result << x.head(size), std::cos(x[size]), std::sin(x[size]);
  return result;
}
VectorXd with_angle(const VectorXd& x) {
  const Eigen::Index size = x.size() - 2;
  VectorXd result(size + 1);
  result << x.head(size), std::atan2(x[size + 1], x[size]);
  return result;
}

bool turns_on_circle(JointKind kind) { return unit_entries(kind) == 2; }

/// Converts the entries of one joint from the given convention to entries of q.
VectorXd ours(VectorXd x, JointKind kind, JointConvention convention) {
  if (has_w_first(kind, convention)) w_to_end(x.tail<4>());
  if (turns_on_circle(kind) && convention != JointConvention::Same) return with_pair(x);
  return x;
}

/// Converts the entries of one joint from entries of q to the given convention.
VectorXd theirs(VectorXd x, JointKind kind, JointConvention convention) {
  if (has_w_first(kind, convention)) w_to_front(x.tail<4>());
  if (turns_on_circle(kind) && convention != JointConvention::Same) return with_angle(x);
  return x;
}

/// Converts the coordinates of a posture to entries of q.
VectorXd of_posture(const std::vector<double>& held, JointKind kind) {
  const VectorXd x =
      Eigen::Map<const VectorXd>(held.data(), static_cast<Eigen::Index>(held.size()));
  return turns_on_circle(kind) ? with_pair(x) : x;
}

/// Normalises the unit vector in a joint's entries of q. Returns false if its length differs from 1
/// by more than the rounding of files.
bool normalise(JointKind kind, VectorXd& x) {
  constexpr double file_rounding = 1e-3;  // chosen by hand
  const int unit = unit_entries(kind);
  if (unit == 0) return true;
  const double length = x.tail(unit).norm();
  x.tail(unit) /= length;
  return std::abs(length - 1.0) <= file_rounding;
}

/// Returns the distance of two positions of one joint, given as entries of q.
double distance(JointKind kind, const VectorXd& x, const VectorXd& y) {
  if (unit_entries(kind) != 4) return (x - y).norm();
  VectorXd opposite = x;
  opposite.tail<4>() *= -1.0;  // the negative quaternion is the same rotation
  return std::min((x - y).norm(), (opposite - y).norm());
}

}  // namespace

JointOrder::JointOrder(Model model, std::vector<std::string> names, JointConvention convention)
    : model_(std::move(model)), convention_(convention), names_(std::move(names)) {
  std::vector<std::string> existing;
  for (const FileJoint& stated : model_.file_joints) existing.push_back(stated.name);
  std::set<std::string> listed;
  for (const std::string& name : names_) {
    if (name.empty())
      refuse("joint number " + std::to_string(listed.size() + 1) +
             " of the order has no name; wanted the name of a joint of the model");
    const auto at = std::find(existing.begin(), existing.end(), name);
    if (at == existing.end())
      refuse("joint " + in_quotes(name) + " of the order does not exist" +
             did_you_mean(name, existing));
    if (!listed.insert(name).second)
      refuse("joint " + in_quotes(name) + " is twice in the order; wanted each joint once");
    add(model_.file_joints[to_size(at - existing.begin())]);
  }
}

JointOrder JointOrder::mujoco(const Model& model) {
  std::vector<std::string> names;
  for (const FileJoint& stated : model.file_joints) names.push_back(stated.name);
  return {model, std::move(names), JointConvention::Mujoco};
}

void JointOrder::add(const FileJoint& stated) {
  places_.push_back({stated, nq_, nv_});
  nq_ += positions_of(stated.kind, convention_);
  nv_ += joint_nv(stated.kind);
}

const Joint* JointOrder::moving(const Place& place) const {
  return place.stated.joint < 0 ? nullptr : &model_.joints[to_size(place.stated.joint)];
}

void JointOrder::refuse(const std::string& what) const {
  burnish::refuse(model_.name.empty() ? "model" : "robot " + in_quotes(model_.name), what);
}

void JointOrder::require_all_joints() const {
  std::vector<std::string> missing;
  for (const Joint& joint : model_.joints)
    if (!joint.follows && std::find(names_.begin(), names_.end(), joint.name) == names_.end())
      missing.push_back(joint.name);
  if (missing.empty()) return;
  refuse("the order leaves out " + listed("joint", missing) + ", which " +
         (missing.size() == 1 ? "moves" : "move") + "; wanted all moving joints in the order, or " +
         (missing.size() == 1 ? "this joint locked" : "these joints locked"));
}

void JointOrder::check(const Eigen::Ref<const VectorXd>& entries, int size,
                       const char* what) const {
  if (entries.size() != size)
    refuse(std::string(what) + " have " + std::to_string(entries.size()) + " entries; wanted " +
           std::to_string(size));
  if (!entries.allFinite()) refuse(std::string(what) + " are not finite; wanted finite numbers");
}

VectorXd JointOrder::file_position(const Place& place, const Eigen::Ref<const VectorXd>& q) const {
  const Joint* joint = moving(place);
  if (joint == nullptr) return of_posture(place.stated.held, place.stated.kind);
  if (!joint->follows) return q.segment(joint->q_index, joint->nq);
  const VectorXd value = VectorXd::Constant(1, joint_value(model_, *joint, q));
  return ours(value, joint->kind, JointConvention::Angles);
}

bool JointOrder::is_continuous(int joint) const {
  return model_.joints[to_size(joint)].kind == JointKind::Continuous;
}

VectorXd JointOrder::q_from(const Eigen::Ref<const VectorXd>& positions, double tolerance) const {
  require_all_joints();
  check(positions, nq_, "positions");
  VectorXd q = model_.q_neutral;
  std::vector<VectorXd> entries;
  for (const Place& place : places_) {
    const JointKind kind = place.stated.kind;
    VectorXd x =
        ours(positions.segment(place.q, positions_of(kind, convention_)), kind, convention_);
    if (!normalise(kind, x))
      refuse("joint " + in_quotes(place.stated.name) + ": its " +
             (unit_entries(kind) == 4 ? "quaternion" : "(cos, sin)") +
             " does not have length 1; wanted a length of 1, to within 0.001");
    const Joint* joint = moving(place);
    if (joint != nullptr && !joint->follows) q.segment(joint->q_index, joint->nq) = x;
    entries.push_back(std::move(x));
  }
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place& place = places_[i];
    const Joint* joint = moving(place);
    const bool is_held = joint == nullptr;
    double off = distance(place.stated.kind, entries[i], file_position(place, q));
    if (!is_held && joint->follows && is_continuous(joint->follows->leader))
      off = std::abs(std::remainder(off, 2.0 * std::numbers::pi));
    if (off <= tolerance) continue;
    refuse("joint " + in_quotes(place.stated.name) + " differs by " + number(off) + " from " +
           (is_held ? "its locked position" : "the position that its leader implies") +
           "; wanted at most " + number(tolerance));
  }
  return q;
}

VectorXd JointOrder::q_to(const Eigen::Ref<const VectorXd>& q) const {
  check_configuration(model_, q);
  VectorXd result(nq_);
  for (const Place& place : places_)
    result.segment(place.q, positions_of(place.stated.kind, convention_)) =
        theirs(file_position(place, q), place.stated.kind, convention_);
  return result;
}

Eigen::Matrix3d JointOrder::linear_axes(const Place& place,
                                        const Eigen::Ref<const VectorXd>& q) const {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  const Joint* joint = moving(place);
  if (convention_ != JointConvention::Mujoco || joint == nullptr) return rotation;
  const auto x = q.segment(joint->q_index, joint->nq);
  if (joint->kind == JointKind::FreeFlyer)
    rotation = Eigen::Quaterniond(x[6], x[3], x[4], x[5]).toRotationMatrix();
  if (joint->kind == JointKind::Planar) rotation.topLeftCorner<2, 2>() << x[2], -x[3], x[3], x[2];
  return rotation;
}

VectorXd JointOrder::from(const Eigen::Ref<const VectorXd>& entries,
                          const Eigen::Ref<const VectorXd>& q, bool adds_followers) const {
  check_configuration(model_, q);
  VectorXd result = VectorXd::Zero(model_.nv);
  for (const Place& place : places_) {
    const Joint* joint = moving(place);
    if (joint == nullptr) continue;
    if (joint->follows) {
      if (adds_followers) result[joint->v_index] += joint->follows->multiplier * entries[place.v];
      continue;
    }
    auto x = result.segment(joint->v_index, joint->nv);
    x += entries.segment(place.v, joint->nv);
    const int linear = sliding_entries(joint->kind);
    if (linear < 2) continue;
    const Eigen::VectorXd along = x.head(linear);
    x.head(linear) = linear_axes(place, q).topLeftCorner(linear, linear).transpose() * along;
  }
  return result;
}

VectorXd JointOrder::to(const Eigen::Ref<const VectorXd>& entries,
                        const Eigen::Ref<const VectorXd>& q, bool moves_followers) const {
  check_configuration(model_, q);
  check_tangent(model_, entries);
  VectorXd result = VectorXd::Zero(nv_);
  for (const Place& place : places_) {
    const Joint* joint = moving(place);
    if (joint == nullptr) continue;
    if (joint->follows) {
      if (moves_followers) result[place.v] = joint->follows->multiplier * entries[joint->v_index];
      continue;
    }
    auto x = result.segment(place.v, joint->nv);
    x = entries.segment(joint->v_index, joint->nv);
    const int linear = sliding_entries(joint->kind);
    if (linear < 2) continue;
    const Eigen::VectorXd along = x.head(linear);
    x.head(linear) = linear_axes(place, q).topLeftCorner(linear, linear) * along;
  }
  return result;
}

VectorXd JointOrder::v_from(const Eigen::Ref<const VectorXd>& velocities,
                            const Eigen::Ref<const VectorXd>& q) const {
  require_all_joints();
  check(velocities, nv_, "velocities");
  return from(velocities, q, false);
}

VectorXd JointOrder::v_to(const Eigen::Ref<const VectorXd>& v,
                          const Eigen::Ref<const VectorXd>& q) const {
  return to(v, q, true);
}

VectorXd JointOrder::tau_from(const Eigen::Ref<const VectorXd>& torques,
                              const Eigen::Ref<const VectorXd>& q) const {
  check(torques, nv_, "torques");
  return from(torques, q, true);
}

VectorXd JointOrder::tau_to(const Eigen::Ref<const VectorXd>& tau,
                            const Eigen::Ref<const VectorXd>& q) const {
  return to(tau, q, false);
}

}  // namespace burnish
