#include "burnish/model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "model/followers.hpp"
#include "model/posture.hpp"

namespace burnish {
namespace {

constexpr std::array<std::string_view, 6> twist_names = {".vx", ".vy", ".vz", ".wx", ".wy", ".wz"};
constexpr std::array<std::string_view, 3> planar_twist_names = {".vx", ".vy", ".wz"};
constexpr std::array<std::string_view, 3> turn_names = {".wx", ".wy", ".wz"};
constexpr std::array<std::string_view, 7> pose_names = {".x",  ".y",  ".z", ".qx",
                                                        ".qy", ".qz", ".qw"};
constexpr std::array<std::string_view, 4> planar_pose_names = {".x", ".y", ".cos", ".sin"};
constexpr std::array<std::string_view, 4> quaternion_names = {".qx", ".qy", ".qz", ".qw"};
constexpr std::array<std::string_view, 2> circle_names = {".cos", ".sin"};

std::string_view suffix_of_v(JointKind kind, int entry) {
  const auto k = to_size(entry);
  if (kind == JointKind::FreeFlyer) return twist_names[k];
  if (kind == JointKind::Ball) return turn_names[k];
  return kind == JointKind::Planar ? planar_twist_names[k] : "";
}

std::string_view suffix_of_q(JointKind kind, int entry) {
  const auto k = to_size(entry);
  if (kind == JointKind::FreeFlyer) return pose_names[k];
  if (kind == JointKind::Planar) return planar_pose_names[k];
  if (kind == JointKind::Ball) return quaternion_names[k];
  return kind == JointKind::Continuous ? circle_names[k] : "";
}

/// Returns "robot 'x'", or "model" without a name.
std::string label_of(const Model& model) {
  return model.name.empty() ? "model" : "robot " + in_quotes(model.name);
}

void check_entry(const Model& model, int k, int size, const char* vector) {
  if (k >= 0 && k < size) return;
  refuse(label_of(model), "entry " + std::to_string(k) + " of " + vector +
                              " does not exist; the size is " + std::to_string(size));
}

void write_coordinates(const Joint& joint, std::span<const double> values, Eigen::VectorXd& q) {
  auto entries = q.segment(joint.q_index, joint.nq);
  switch (joint.kind) {
    case JointKind::Revolute:
    case JointKind::Prismatic:
      entries[0] = values[0];
      break;
    case JointKind::Continuous:
      entries << std::cos(values[0]), std::sin(values[0]);
      break;
    case JointKind::Planar:
      entries << values[0], values[1], std::cos(values[2]), std::sin(values[2]);
      break;
    case JointKind::FreeFlyer:
      entries = Eigen::Map<const Eigen::Matrix<double, 7, 1>>(values.data());
      entries.tail<4>().normalize();
      break;
    case JointKind::Ball:
      entries.head<4>() = Eigen::Map<const Eigen::Vector4d>(values.data()).normalized();
      break;
  }
}

/// Applies a follower's value in a posture. If the leader has no value and is not continuous, the
/// follower's value determines it. Otherwise the value must agree with the leader's value.
void agree_with_leader(const Model& model, const Joint& joint, double stated,
                       const Posture& posture, Eigen::VectorXd& q) {
  const Following& follows = *joint.follows;
  const Joint& leader = model.joints[to_size(follows.leader)];
  const bool has_value = posture.contains(leader.name);
  if (!has_value && leader.kind != JointKind::Continuous && follows.multiplier != 0.0 &&
      q[leader.q_index] == model.q_neutral[leader.q_index])
    q[leader.q_index] = (stated - follows.offset) / follows.multiplier;
  const double given = joint_value(model, joint, q);
  double miss = stated - given;
  if (joint.kind == JointKind::Continuous || leader.kind == JointKind::Continuous)
    miss = std::remainder(miss, 2.0 * std::numbers::pi);
  if (std::abs(miss) <= posture_tolerance) return;
  refuse(label_of(model), "posture of joint " + in_quotes(joint.name) + ": its value is " +
                              number(stated) + ", but it follows joint " + in_quotes(leader.name) +
                              ", which is at " + number(joint_value(model, leader, q)) +
                              (has_value ? "" : " (not stated in the posture)") +
                              ", so the follower must be at " + number(given) +
                              "; correct or omit one of the two values");
}

}  // namespace

int joint_nq(JointKind kind) {
  switch (kind) {
    case JointKind::Revolute:
    case JointKind::Prismatic:
      return 1;
    case JointKind::Continuous:
      return 2;
    case JointKind::Planar:
      return 4;
    case JointKind::FreeFlyer:
      return 7;
    case JointKind::Ball:
      return 4;
  }
  return 0;
}

int joint_nv(JointKind kind) {
  if (kind == JointKind::Planar || kind == JointKind::Ball) return 3;
  return kind == JointKind::FreeFlyer ? 6 : 1;
}

std::string_view name_of(JointKind kind) {
  switch (kind) {
    case JointKind::Revolute:
      return "revolute";
    case JointKind::Continuous:
      return "continuous";
    case JointKind::Prismatic:
      return "prismatic";
    case JointKind::Planar:
      return "planar";
    case JointKind::FreeFlyer:
      return "free-flyer";
    case JointKind::Ball:
      return "ball";
  }
  return "unknown";
}

std::span<const int> Model::support(int body) const {
  if (body < 0) return {};
  check_entry(*this, body, static_cast<int>(joints.size()), "the bodies");
  const int begin = support_begin[to_size(body)];
  const int end = support_begin[to_size(body) + 1];
  return std::span<const int>(support_entries).subspan(to_size(begin), to_size(end - begin));
}

std::string Model::v_name(int k) const {
  check_entry(*this, k, nv, "v");
  const Joint& joint = joints[to_size(joint_of_v[to_size(k)])];
  return joint.name + std::string(suffix_of_v(joint.kind, k - joint.v_index));
}

std::string Model::q_name(int k) const {
  check_entry(*this, k, nq, "q");
  std::size_t owner = 0;
  while (joints[owner].q_index > k || joints[owner].q_index + joints[owner].nq <= k) ++owner;
  const Joint& joint = joints[owner];
  return joint.name + std::string(suffix_of_q(joint.kind, k - joint.q_index));
}

int Model::frame_index(std::string_view frame_name) const {
  int of_joint = -1;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].name != frame_name) continue;
    if (frames[i].kind != FrameKind::Joint) return static_cast<int>(i);
    of_joint = static_cast<int>(i);
  }
  if (of_joint >= 0) return of_joint;
  std::vector<std::string> existing;
  for (const Frame& frame : frames) existing.push_back(frame.name);
  refuse(label_of(*this),
         "frame " + in_quotes(frame_name) + " does not exist" + did_you_mean(frame_name, existing));
}

int Model::joint_index(std::string_view joint_name) const {
  std::vector<std::string> existing;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].name == joint_name) return static_cast<int>(i);
    existing.push_back(joints[i].name);
  }
  for (const std::string& locked : locked_joints) {
    if (locked != joint_name) continue;
    refuse(label_of(*this), "joint " + in_quotes(joint_name) + " is locked; wanted a moving joint");
  }
  refuse(label_of(*this),
         "joint " + in_quotes(joint_name) + " does not exist" + did_you_mean(joint_name, existing));
}

bool Model::has_frame(std::string_view frame_name) const {
  for (const Frame& frame : frames) {
    if (frame.name == frame_name) return true;
  }
  return false;
}

double Model::total_mass() const {
  return std::accumulate(joints.begin(), joints.end(), 0.0,
                         [](double sum, const Joint& joint) { return sum + joint.mass; });
}

Eigen::VectorXd configuration(const Model& model, const Posture& posture) {
  std::map<std::string_view, const Joint*> moving;
  std::vector<std::string> existing = model.locked_joints;
  for (const Joint& joint : model.joints) {
    moving.emplace(joint.name, &joint);
    existing.push_back(joint.name);
  }
  Eigen::VectorXd q = model.q_neutral;
  for (const auto& [name, values] : posture) {
    if (const auto found = moving.find(name); found != moving.end()) {
      const Joint& joint = *found->second;
      check_posture_values(label_of(model), name, values, posture_size(joint.kind));
      if (!joint.follows) write_coordinates(joint, values, q);
      continue;
    }
    const bool is_ignored =
        name == root_joint_name || std::find(model.locked_joints.begin(), model.locked_joints.end(),
                                             name) != model.locked_joints.end();
    if (!is_ignored) {
      refuse(label_of(model), "posture: joint " + in_quotes(name) + " does not exist" +
                                  did_you_mean(name, existing));
    }
  }
  for (const auto& [name, values] : posture) {
    const auto found = moving.find(name);
    if (found != moving.end() && found->second->follows)
      agree_with_leader(model, *found->second, values[0], posture, q);
  }
  return q;
}

}  // namespace burnish
